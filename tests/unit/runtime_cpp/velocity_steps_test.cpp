// The steps of the velocity smoother, and the values that its parameters may have.
#include "velocity_steps.hpp"

#include <cmath>
#include <limits>

#include "gtest/gtest.h"
#include "parameter_checks.hpp"

namespace nav2_velocity_smoother {
namespace {

constexpr AxisLimits kAlongX{2.5, -2.5};
const Limits kDefaults{{-0.5, 0.0, -2.5},
                       {0.5, 0.0, 2.5},
                       {AxisLimits{2.5, -2.5}, AxisLimits{0.0, 0.0}, AxisLimits{3.2, -3.2}},
                       20.0,
                       false};

TEST(VelocitySteps, FourStepsToHalfAMetrePerSecond) {
  Velocity velocity{};
  for (const double expected : {0.125, 0.25, 0.375, 0.5, 0.5}) {
    velocity = next_velocity(velocity, {0.5, 0.0, 0.0}, kDefaults);
    EXPECT_NEAR(velocity[0], expected, 1e-12);
  }
  for (const double expected : {0.375, 0.25, 0.125, 0.0}) {
    velocity = next_velocity(velocity, {0.0, 0.0, 0.0}, kDefaults);
    EXPECT_NEAR(velocity[0], expected, 1e-12);
  }
  EXPECT_EQ(velocity[0], 0.0);
}

TEST(VelocitySteps, FactorOfAChange) {
  EXPECT_NEAR(find_eta(0.0, 0.5, kAlongX, 20.0), 0.25, 1e-12);
  EXPECT_NEAR(find_eta(0.0, -0.5, kAlongX, 20.0), 0.25, 1e-12);
  EXPECT_EQ(find_eta(0.0, 0.1, kAlongX, 20.0), -1.0);
  EXPECT_EQ(find_eta(0.3, 0.3, kAlongX, 20.0), -1.0);
  EXPECT_EQ(find_eta(0.0, 0.2, {0.0, 0.0}, 20.0), 0.0);
}

TEST(VelocitySteps, SlowingDownHasItsOwnLimit) {
  const AxisLimits limits{1.0, -4.0};
  EXPECT_NEAR(stepped(0.0, 1.0, limits, 1.0, 10.0), 0.1, 1e-12);
  EXPECT_NEAR(stepped(1.0, 0.0, limits, 1.0, 10.0), 0.6, 1e-12);
  EXPECT_NEAR(stepped(-1.0, 0.0, limits, 1.0, 10.0), -0.6, 1e-12);
  EXPECT_NEAR(stepped(-0.2, 1.0, limits, 1.0, 10.0), 0.2, 1e-12) << "through zero";
  EXPECT_NEAR(stepped(-0.5, -1.0, limits, 1.0, 10.0), -0.6, 1e-12);
  EXPECT_NEAR(stepped(0.0, 1.0, limits, 0.05, 10.0), 0.05, 1e-12);
}

TEST(VelocitySteps, AxesInProportion) {
  Limits limits = kDefaults;
  limits.scales = true;
  const Velocity velocity = next_velocity({}, {0.5, 0.0, 2.5}, limits);
  EXPECT_NEAR(velocity[0], 0.032, 1e-12);
  EXPECT_NEAR(velocity[2], 0.16, 1e-12);
  limits.scales = false;
  EXPECT_NEAR(next_velocity({}, {0.5, 0.0, 2.5}, limits)[0], 0.125, 1e-12);
}

TEST(VelocitySteps, CommandsWithinTheVelocities) {
  const Velocity velocity = clamped({-3.0, 1.0, 2.0}, kDefaults);
  EXPECT_EQ(velocity[0], -0.5);
  EXPECT_EQ(velocity[1], 0.0);
  EXPECT_EQ(velocity[2], 2.0);
}

TEST(VelocityParameters, Numbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -20.0, nan, infinity, 1e-300, 2000.0}) {
    EXPECT_FALSE(check_number("smoothing_frequency", bad).empty()) << bad;
  }
  EXPECT_EQ(check_number("smoothing_frequency", 20.0), "");
  EXPECT_FALSE(check_number("velocity_timeout", nan).empty());
  EXPECT_FALSE(check_number("odom_duration", 1e300).empty());
  EXPECT_EQ(check_number("velocity_timeout", -1.0), "");
  EXPECT_EQ(check_number("of somebody else", nan), "");
}

TEST(VelocityParameters, AxesHaveThreeNumbersOfOneSign) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Moment change = Moment::kChange;
  EXPECT_EQ(check_axes("max_accel", {1.0, 2.0}, change),
            "Invalid size of parameter max_accel. Must be size 3");
  EXPECT_EQ(check_axes("max_accel", {1.0, -2.0, 0.0}, change),
            "Negative values set of acceleration! These should be positive to speed up!");
  EXPECT_EQ(check_axes("max_decel", {-1.0, 2.0, 0.0}, Moment::kConfigure),
            "Positive values set of deceleration! These should be negative to slow down!");
  EXPECT_EQ(check_axes("max_velocity", {-1.0, 0.0, 0.0}, change),
            "Negative values set of max_velocity! These should be positive!");
  EXPECT_EQ(check_axes("min_velocity", {1.0, 0.0, 0.0}, Moment::kConfigure),
            "Positive values set of min_velocities! These should be negative!");
  EXPECT_EQ(check_axes("deadband_velocity", {nan, 0.0, 0.0}, change),
            "deadband_velocity must not contain NaN");
  EXPECT_EQ(check_axes("deadband_velocity", {-1.0, 0.0, 1.0}, change), "");
  EXPECT_EQ(check_feedback("OPEN_LOOP") + check_feedback("CLOSED_LOOP"), "");
  EXPECT_FALSE(check_feedback("open").empty());
}

}  // namespace
}  // namespace nav2_velocity_smoother
