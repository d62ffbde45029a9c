// The geometry of the collision monitor: zones, obstacles, and when a moving robot meets them.
#include <cmath>
#include <limits>
#include <vector>

#include "gtest/gtest.h"
#include "nav2_collision_monitor/kinematics.hpp"
#include "zone_math.hpp"

namespace nav2_collision_monitor {
namespace {

const std::vector<Point> kSquare{{0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}, {-0.5, 0.5}};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double time_to_square(const std::vector<Point>& obstacles, const Velocity& velocity,
                      const Forecast& forecast = {2.0, 0.1, 1}) {
  return time_to_collision(obstacles, velocity, forecast, [](const std::vector<Point>& points) {
    return count_inside(kSquare, points);
  });
}

TEST(CollisionZones, PointsOfAPolygon) {
  EXPECT_TRUE(is_inside(kSquare, {0.0, 0.0}));
  EXPECT_TRUE(is_inside(kSquare, {0.49, -0.49}));
  EXPECT_FALSE(is_inside(kSquare, {0.51, 0.0}));
  EXPECT_FALSE(is_inside(kSquare, {-3.0, 0.2}));
  // A ray from it passes through two corners.
  EXPECT_FALSE(is_inside(kSquare, {-1.0, 0.5}));
  EXPECT_FALSE(is_inside(kSquare, {-1.0, -0.5}));
  const std::vector<Point> notched{{1, 1}, {1, -1}, {-1, -1}, {0, 0}, {-1, 1}};
  EXPECT_FALSE(is_inside(notched, {-0.5, 0.0}));
  EXPECT_TRUE(is_inside(notched, {-0.5, 0.7}));
  EXPECT_TRUE(is_inside(notched, {0.5, 0.0}));
}

TEST(CollisionZones, PointsThatAreNotNumbersAreOutside) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(count_inside(kSquare, {{kNan, 0.0}, {0.0, kNan}, {infinity, 0.0}, {0.0, -infinity}}),
            0);
  EXPECT_EQ(count_inside({}, {{0.0, 0.0}}), 0);
  EXPECT_EQ(count_inside(kSquare, {{0.1, 0.1}, {0.2, 0.2}, {0.8, 0.0}}), 2);
}

TEST(CollisionZones, TheFrameOfAPose) {
  std::vector<Point> points{{2.0, 1.0}};
  transformPoints({1.0, 1.0, M_PI / 2}, points);
  EXPECT_NEAR(points[0].x, 0.0, 1e-12);
  EXPECT_NEAR(points[0].y, -1.0, 1e-12);
}

TEST(CollisionZones, AVelocityTurnsWithTheRobot) {
  Pose pose{0.0, 0.0, 0.0};
  Velocity velocity{1.0, 0.0, M_PI / 2};
  projectState(1.0, pose, velocity);
  EXPECT_NEAR(pose.x, 1.0, 1e-12);
  EXPECT_NEAR(pose.theta, M_PI / 2, 1e-12);
  EXPECT_NEAR(velocity.x, 0.0, 1e-12);
  EXPECT_NEAR(velocity.y, 1.0, 1e-12);
}

TEST(CollisionZones, TimeToAWall) {
  // The edge of the square is 0.5 m in front: 0.61 m away at 0.2 m/s is 0.55 s, six steps.
  EXPECT_NEAR(time_to_square({{0.61, 0.0}}, {0.2, 0.0, 0.0}), 0.5, 1e-9);
  EXPECT_EQ(time_to_square({{0.61, 0.0}}, {0.0, 0.0, 0.0}), -1.0);
  EXPECT_EQ(time_to_square({{0.61, 0.0}}, {-0.2, 0.0, 0.0}), -1.0);
  EXPECT_EQ(time_to_square({{0.4, 0.0}}, {0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(time_to_square({{3.0, 0.0}}, {0.2, 0.0, 0.0}), -1.0);
  EXPECT_EQ(time_to_square({{0.61, 0.0}}, {0.2, 0.0, 0.0}, {2.0, 0.1, 2}), -1.0);
  EXPECT_EQ(time_to_square({}, {0.2, 0.0, 0.0}), -1.0);
}

TEST(CollisionZones, TimeToTheCornerOfARobotThatTurns) {
  // A corner reaches 0.7 m to the front after an eighth of a turn.
  const double time = time_to_square({{0.69, 0.0}}, {0.0, 0.0, M_PI / 4});
  EXPECT_GT(time, 0.7);
  EXPECT_LT(time, 1.0);
}

TEST(CollisionZones, LimitsScaleTheWholeVelocity) {
  EXPECT_EQ(limit_ratio({0.3, 0.0, 0.1}, 0.4, 0.2), 1.0);
  EXPECT_NEAR(limit_ratio({0.6, 0.8, 0.0}, 0.5, 0.5), 0.5, 1e-12);
  EXPECT_NEAR(limit_ratio({0.3, 0.0, -1.0}, 0.4, 0.25), 0.25, 1e-12);
  EXPECT_EQ(limit_ratio({0.0, 0.0, 0.0}, 0.0, 0.0), 1.0);
  EXPECT_EQ(limit_ratio({0.5, 0.0, 0.0}, 0.0, 1.0), 0.0);
}

TEST(CollisionZones, RangesOfVelocities) {
  const SpeedRange ahead{0.0, 0.5, -1.0, 1.0, 0.0, 0.0};
  EXPECT_TRUE(is_in_range({0.5, 0.0, 0.9}, ahead, false));
  EXPECT_FALSE(is_in_range({0.6, 0.0, 0.0}, ahead, false));
  EXPECT_FALSE(is_in_range({0.1, 0.0, 1.1}, ahead, false));
  EXPECT_FALSE(is_in_range({-0.1, 0.0, 0.0}, ahead, false));
  const SpeedRange left{0.1, 0.5, -1.0, 1.0, 2.0, 1.0};
  EXPECT_TRUE(is_in_range({0.0, 0.3, 0.0}, left, true));
  EXPECT_FALSE(is_in_range({0.3, 0.0, 0.0}, left, true));
  EXPECT_FALSE(is_in_range({0.0, 0.6, 0.0}, left, true));
  const SpeedRange behind{0.1, 0.5, -1.0, 1.0, -2.0, 2.0};
  EXPECT_TRUE(is_in_range({-0.3, 0.0, 0.0}, behind, true));
  EXPECT_FALSE(is_in_range({0.3, 0.0, 0.0}, behind, true));
}

TEST(CollisionZones, PointsOfARange) {
  const std::vector<Point> points = arc_points(2.0, 1.0, 0.25);
  ASSERT_EQ(points.size(), 5U);
  for (const Point& point : points) EXPECT_NEAR(std::hypot(point.x, point.y), 2.0, 1e-12);
  EXPECT_NEAR(std::atan2(points.front().y, points.front().x), -0.5, 1e-12);
  EXPECT_NEAR(std::atan2(points.back().y, points.back().x), 0.5, 1e-12);
  EXPECT_EQ(arc_points(2.0, 0.0, 0.25).size(), 1U);
}

TEST(CollisionZones, PointsOfAnOutline) {
  const std::vector<Point> points = outline_points(kSquare, 0.3);
  // Four edges of four pieces, with both ends.
  ASSERT_EQ(points.size(), 20U);
  for (const Point& point : points) {
    EXPECT_NEAR(std::max(std::abs(point.x), std::abs(point.y)), 0.5, 1e-12);
  }
  EXPECT_TRUE(outline_points({}, 0.3).empty());
  EXPECT_EQ(outline_points({{1.0, 1.0}}, 0.3).size(), 2U);
  EXPECT_LT(outline_points({{0.0, 0.0}, {1e12, 0.0}}, 0.001).size(), 210'000U);
  std::vector<Point> star;
  for (int i = 0; i < 1000; ++i) star.push_back({i % 2 == 0 ? 0.0 : 1e7, static_cast<double>(i)});
  EXPECT_LT(outline_points(star, 0.1).size(), 210'000U);
}

}  // namespace
}  // namespace nav2_collision_monitor
