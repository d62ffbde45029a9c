// The local planner DWB below ROS: velocities within limits, motion in steps, signs of commands.
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "costmap_queue/map_based_queue.hpp"
#include "dwb_critics/command_trend.hpp"
#include "dwb_plugins/kinematic_limits.hpp"
#include "dwb_plugins/motion_steps.hpp"
#include "dwb_plugins/one_d_velocity_iterator.hpp"
#include "gtest/gtest.h"

namespace {

using dwb_plugins::OneDVelocityIterator;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> all_of(OneDVelocityIterator iterator) {
  std::vector<double> result;
  for (; !iterator.isFinished() && result.size() < 1000; ++iterator) {
    result.push_back(iterator.getVelocity());
  }
  return result;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
}

TEST(Dwb, VelocitiesBetweenTheLimits) {
  expect_near(all_of({0.1, 0.0, 0.3, 10.0, -10.0, 1.0, 4}), {0.0, 0.1, 0.2, 0.3});
  // Both ends are there even with one sample.
  expect_near(all_of({0.1, 0.0, 0.3, 10.0, -10.0, 1.0, 1}), {0.0, 0.3});
  expect_near(all_of({0.0, 0.2, 0.2, 10.0, -10.0, 1.0, 5}), {0.2});
}

TEST(Dwb, VelocitiesThatCanBeReached) {
  expect_near(all_of({0.5, 0.0, 1.0, 2.0, -1.0, 0.1, 3}), {0.4, 0.55, 0.7});
  // From beyond a limit, the limit is the start.
  expect_near(all_of({2.0, 0.0, 1.0, 2.0, -1.0, 0.1, 2}), {0.9, 1.0});
}

TEST(Dwb, ZeroIsBetweenNegativeAndPositiveVelocities) {
  expect_near(all_of({0.0, -1.0, 1.0, 9.0, -9.0, 1.0, 4}), {-1.0, -1.0 / 3, 0.0, 1.0 / 3, 1.0});
  expect_near(all_of({0.0, -1.0, 1.0, 9.0, -9.0, 1.0, 3}), {-1.0, 0.0, 1.0});
}

TEST(Dwb, IterationEndsForNumbersThatAreNotFinite) {
  EXPECT_TRUE(all_of({0.0, 0.0, kNaN, 1.0, -1.0, 1.0, 5}).size() < 10);
  EXPECT_TRUE(all_of({0.0, kNaN, 1.0, 1.0, -1.0, 1.0, 5}).size() < 10);
  EXPECT_TRUE(all_of({0.0, 0.0, 1.0, INFINITY, -INFINITY, kNaN, 5}).size() < 10);
  expect_near(all_of({kNaN, 0.0, 1.0, 9.0, -9.0, 1.0, 2}), {0.0, 1.0});
}

struct Limits : dwb_plugins::KinematicParameters {
  Limits() {
    max_vel_x_ = base_max_vel_x_ = 0.4;
    max_vel_theta_ = base_max_vel_theta_ = 1.0;
    max_speed_xy_ = base_max_speed_xy_ = 0.5;
    min_speed_xy_ = 0.1;
    min_speed_theta_ = 0.2;
    squareSpeeds();
  }
  using KinematicParameters::limitSpeed;
};

TEST(Dwb, ValidSpeeds) {
  Limits limits;
  EXPECT_TRUE(limits.isValidSpeed(0.3, 0.4, 0.0));
  EXPECT_FALSE(limits.isValidSpeed(0.4, 0.4, 0.0));
  EXPECT_FALSE(limits.isValidSpeed(0.05, 0.0, 0.1));
  EXPECT_TRUE(limits.isValidSpeed(0.05, 0.0, -0.2));
  EXPECT_TRUE(limits.isValidSpeed(0.1, 0.0, 0.0));
  EXPECT_FALSE(limits.isValidSpeed(0.0, 0.0, 0.0));
}

TEST(Dwb, SpeedLimits) {
  Limits limits;
  limits.limitSpeed(50.0, true);
  EXPECT_DOUBLE_EQ(limits.getMaxX(), 0.2);
  EXPECT_DOUBLE_EQ(limits.getMaxTheta(), 0.5);
  EXPECT_DOUBLE_EQ(limits.getMaxSpeedXY_SQ(), 0.0625);
  limits.limitSpeed(0.1, false);
  EXPECT_DOUBLE_EQ(limits.getMaxX(), 0.08);
  EXPECT_DOUBLE_EQ(limits.getMinTheta(), -0.2);
  limits.limitSpeed(0.7, false);
  EXPECT_DOUBLE_EQ(limits.getMaxX(), 0.08);
  limits.limitSpeed(0.0, false);
  EXPECT_DOUBLE_EQ(limits.getMaxX(), 0.4);
  EXPECT_DOUBLE_EQ(limits.getMaxSpeedXY(), 0.5);
}

TEST(Dwb, AcceleratesWithinLimits) {
  EXPECT_DOUBLE_EQ(dwb_plugins::projectVelocity(0.0, 2.0, -4.0, 0.1, 1.0), 0.2);
  EXPECT_DOUBLE_EQ(dwb_plugins::projectVelocity(0.9, 2.0, -4.0, 0.1, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(dwb_plugins::projectVelocity(1.0, 2.0, -4.0, 0.1, 0.0), 0.6);
  EXPECT_DOUBLE_EQ(dwb_plugins::projectVelocity(0.3, 2.0, -4.0, 0.1, 0.0), 0.0);
}

struct Plane {
  double x, y, theta;
};

TEST(Dwb, StepsOfATrajectory) {
  EXPECT_EQ(dwb_plugins::count_steps(Plane{0.3, 0.4, 0.0}, 2.0, 0.1, 0.1), 10U);
  EXPECT_EQ(dwb_plugins::count_steps(Plane{0.1, 0.0, -1.0}, 1.5, 0.05, 0.025), 60U);
  EXPECT_EQ(dwb_plugins::count_steps(Plane{0.0, 0.0, 0.0}, 1.5, 0.05, 0.025), 1U);
  EXPECT_EQ(dwb_plugins::count_steps(Plane{1e30, 0.0, 0.0}, 1.5, 0.05, 0.025), 10'000U);
  EXPECT_EQ(dwb_plugins::count_steps(Plane{kNaN, 0.0, 0.0}, 1.5, 0.05, 0.025), 1U);
}

TEST(Dwb, MotionOnACircle) {
  // A quarter of a circle with a radius of 1 m, to the left.
  Plane pose{1.0, 2.0, M_PI_2};
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    pose = dwb_plugins::moved(pose, Plane{1.0, 0.0, 1.0}, M_PI_2 / steps);
  }
  EXPECT_NEAR(pose.x, 0.0, 2e-3);
  EXPECT_NEAR(pose.y, 3.0, 2e-3);
  EXPECT_NEAR(pose.theta, M_PI, 1e-9);
  const Plane aside = dwb_plugins::moved(Plane{0.0, 0.0, M_PI_2}, Plane{0.0, 1.0, 0.0}, 0.5);
  EXPECT_NEAR(aside.x, -0.5, 1e-12);
  EXPECT_NEAR(aside.y, 0.0, 1e-12);
}

TEST(Dwb, QueueByPriority) {
  costmap_queue::MapBasedQueue<int> queue;
  EXPECT_TRUE(queue.isEmpty());
  EXPECT_THROW(queue.front(), std::out_of_range);
  queue.pop();
  for (const int item : {5, 1, 3, 1}) queue.enqueue(item, item);
  std::vector<int> order;
  bool has_added = false;
  while (!queue.isEmpty()) {
    order.push_back(queue.front());
    queue.pop();
    if (!has_added) queue.enqueue(2, 2);
    has_added = true;
  }
  EXPECT_EQ(order, (std::vector<int>{1, 1, 2, 3, 5}));
  queue.enqueue(4, 4);
  queue.reset();
  EXPECT_TRUE(queue.isEmpty());
  queue.enqueue(7, 7);
  EXPECT_EQ(queue.front(), 7);
}

TEST(Dwb, SignsOfCommands) {
  dwb_critics::CommandTrend trend;
  EXPECT_FALSE(trend.update(0.5));
  EXPECT_FALSE(trend.update(0.0));
  EXPECT_FALSE(trend.hasSignFlipped());
  EXPECT_FALSE(trend.isOscillating(-0.5));
  EXPECT_TRUE(trend.update(-0.1));
  EXPECT_TRUE(trend.isOscillating(0.1));
  EXPECT_FALSE(trend.isOscillating(-0.1));
  EXPECT_FALSE(trend.isOscillating(0.0));
  EXPECT_TRUE(trend.update(0.1));
  EXPECT_TRUE(trend.isOscillating(-0.1));
  trend.reset();
  EXPECT_FALSE(trend.isOscillating(-0.1));
}

}  // namespace
