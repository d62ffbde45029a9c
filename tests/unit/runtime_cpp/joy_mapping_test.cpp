// From a joystick to velocities: buttons that allow it, axes, scales, and the stop.
#include <gtest/gtest.h>

#include "joy_mapping.hpp"

namespace teleop_twist_joy {
namespace {

const std::vector<float> kAxes = {0, 0, 0.5F, 0, 0, -1.0F};

std::vector<int32_t> holding(std::size_t button) {
  std::vector<int32_t> buttons(12, 0);
  buttons[button] = 1;
  return buttons;
}
const std::vector<int32_t> kNothing(12, 0);

TEST(JoyMapping, TheDefaultsAreButtonFiveAxisFiveAndAxisTwo) {
  Pilot pilot;
  const auto velocity = pilot.drive({}, kAxes, holding(5));
  ASSERT_TRUE(velocity);
  EXPECT_DOUBLE_EQ(velocity->x, -0.5);
  EXPECT_DOUBLE_EQ(velocity->yaw, 0.25);
  EXPECT_DOUBLE_EQ(velocity->y, 0);
}

TEST(JoyMapping, StopsOnceWhenTheButtonIsReleased) {
  Pilot pilot;
  ASSERT_TRUE(pilot.drive({}, kAxes, holding(5)));
  const auto stop = pilot.drive({}, kAxes, kNothing);
  ASSERT_TRUE(stop);
  EXPECT_DOUBLE_EQ(stop->x, 0);
  EXPECT_DOUBLE_EQ(stop->yaw, 0);
  EXPECT_FALSE(pilot.drive({}, kAxes, kNothing));
  ASSERT_TRUE(pilot.drive({}, kAxes, holding(5)));
  EXPECT_TRUE(pilot.drive({}, kAxes, kNothing));
}

TEST(JoyMapping, TheTurboButtonNeedsNoOtherAndHasItsOwnScales) {
  Mapping mapping;
  mapping.enable_turbo_button = 7;
  Pilot pilot;
  const auto velocity = pilot.drive(mapping, kAxes, holding(7));
  ASSERT_TRUE(velocity);
  EXPECT_DOUBLE_EQ(velocity->x, -1.0);
  EXPECT_DOUBLE_EQ(velocity->yaw, 0.5);
}

TEST(JoyMapping, WithoutARequiredButtonItAlwaysDrives) {
  Mapping mapping;
  mapping.require_enable_button = false;
  Pilot pilot;
  EXPECT_TRUE(pilot.drive(mapping, kAxes, {}));
  EXPECT_TRUE(pilot.drive(mapping, kAxes, kNothing));
}

TEST(JoyMapping, BackwardsATurnMayBeInverted) {
  Mapping mapping;
  mapping.inverted_reverse = true;
  Pilot pilot;
  EXPECT_DOUBLE_EQ(pilot.drive(mapping, kAxes, holding(5))->yaw, -0.25);
  EXPECT_DOUBLE_EQ(pilot.drive(mapping, {0, 0, 0.5F, 0, 0, 1.0F}, holding(5))->yaw, 0.25);
}

TEST(JoyMapping, ButtonsAndAxesThatTheJoystickLacksAreAtRest) {
  Pilot pilot;
  EXPECT_EQ(pilot.drive({}, {}, {})->x, 0);  // the stop
  Mapping mapping;
  mapping.enable_button = -1;
  EXPECT_FALSE(pilot.drive(mapping, kAxes, holding(5)));
  mapping.require_enable_button = false;
  EXPECT_DOUBLE_EQ(pilot.drive(mapping, {1.0F}, {})->x, 0);
}

TEST(JoyMapping, SixDirectionsHaveTheirOwnAxes) {
  Mapping mapping;
  mapping.x = {0, 1, 1};
  mapping.y = {1, 2, 1};
  mapping.z = {2, 3, 1};
  mapping.roll = {3, 4, 1};
  mapping.pitch = {4, 5, 1};
  mapping.yaw = {5, 6, 1};
  Pilot pilot;
  const auto velocity = pilot.drive(mapping, {1, 1, 1, 1, 1, 1}, holding(5));
  ASSERT_TRUE(velocity);
  EXPECT_DOUBLE_EQ(velocity->x, 1);
  EXPECT_DOUBLE_EQ(velocity->y, 2);
  EXPECT_DOUBLE_EQ(velocity->z, 3);
  EXPECT_DOUBLE_EQ(velocity->roll, 4);
  EXPECT_DOUBLE_EQ(velocity->pitch, 5);
  EXPECT_DOUBLE_EQ(velocity->yaw, 6);
}

}  // namespace
}  // namespace teleop_twist_joy
