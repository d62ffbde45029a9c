// From the axes and buttons of a gamepad to those of messages: signs, dead zone, sticky buttons,
// what is published when.
#include "joy_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "gamepad_device.hpp"

namespace joy {
namespace {

std::string problem(const JoySettings& settings) {
  try {
    settings.check();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

JoyState opened(const JoySettings& settings) {
  JoyState state(settings);
  state.open({0, 0, -1}, 3);
  return state;
}

TEST(JoyState, LeftAndUpArePositiveAndAReleasedTriggerIsOne) {
  EXPECT_FLOAT_EQ(axis_value(-1, 0.05), 1);
  EXPECT_FLOAT_EQ(axis_value(1, 0.05), -1);
  EXPECT_FLOAT_EQ(opened({}).axes()[2], 1);
}

TEST(JoyState, AnAxisStartsFromZeroAtTheEndOfTheDeadZone) {
  EXPECT_EQ(axis_value(0.25F, 0.25), 0);
  EXPECT_EQ(axis_value(-0.2F, 0.3), 0);
  EXPECT_FLOAT_EQ(axis_value(-0.65F, 0.3), 0.5);
  EXPECT_FLOAT_EQ(axis_value(0.5F, 0), -0.5);
}

TEST(JoyState, AxesStayWithinOneWhateverTheDeviceSays) {
  EXPECT_EQ(axis_value(3.28F, 0), -1);
  EXPECT_EQ(axis_value(-std::numeric_limits<float>::infinity(), 0.5), 1);
  EXPECT_EQ(axis_value(std::numeric_limits<float>::quiet_NaN(), 0.5), 0);
  EXPECT_EQ(axis_value(1, 1), 0);
}

TEST(JoyState, ButtonsArePublishedAtOnceAxesLaterAndWhatStaysNever) {
  JoyState state = opened({});
  EXPECT_EQ(state.update({0, 0, -1}, {0, 0, 0}), JoyChange::kNone);
  EXPECT_EQ(state.update({0.04F, 0, -1}, {0, 0, 0}), JoyChange::kNone) << "within the dead zone";
  EXPECT_EQ(state.update({0.5F, 0, -1}, {0, 0, 0}), JoyChange::kAxes);
  EXPECT_EQ(state.update({0.6F, 0, -1}, {0, 1, 0}), JoyChange::kButtons);
  EXPECT_EQ(state.buttons(), (std::vector<int32_t>{0, 1, 0}));
  EXPECT_EQ(state.update({0.6F, 0, -1}, {0, 1, 0}), JoyChange::kNone);
  EXPECT_EQ(state.update({0.6F, 0, -1}, {0, 0, 0}), JoyChange::kButtons);
  EXPECT_EQ(state.buttons(), (std::vector<int32_t>{0, 0, 0}));
}

TEST(JoyState, AStickyButtonChangesWhenItIsPressedOnly) {
  JoyState state = opened({.has_sticky_buttons = true});
  EXPECT_EQ(state.update({0, 0, -1}, {1, 0, 0}), JoyChange::kButtons);
  EXPECT_EQ(state.update({0, 0, -1}, {0, 0, 0}), JoyChange::kNone);
  EXPECT_EQ(state.buttons()[0], 1);
  EXPECT_EQ(state.update({0, 0, -1}, {1, 0, 0}), JoyChange::kButtons);
  EXPECT_EQ(state.buttons()[0], 0);
}

TEST(JoyState, OtherNumbersOfAxesAndButtonsDoNotChangeTheMessage) {
  JoyState state = opened({});
  EXPECT_EQ(state.update({0, 0, -1, 1}, {0, 0, 0, 1}), JoyChange::kNone);
  EXPECT_EQ(state.update({1}, {}), JoyChange::kAxes);
  EXPECT_EQ(state.axes().size(), 3U);
  EXPECT_EQ(state.buttons().size(), 3U);
  state.close();
  EXPECT_EQ(state.update({1}, {1}), JoyChange::kNone);
  EXPECT_TRUE(state.axes().empty());
  EXPECT_TRUE(state.buttons().empty());
}

TEST(JoyState, ParametersAreCheckedWithUpstreamsWords) {
  EXPECT_EQ(problem({}), "");
  EXPECT_EQ(problem({.deadzone = -0.1}), "Deadzone must be between 0.0 and 1.0");
  EXPECT_EQ(problem({.deadzone = std::nan("")}), "Deadzone must be between 0.0 and 1.0");
  EXPECT_EQ(problem({.autorepeat_rate = -1}), "Autorepeat rate must be >= 0.0");
  EXPECT_EQ(problem({.autorepeat_rate = 1001}), "Autorepeat rate must be <= 1000.0");
  EXPECT_EQ(problem({.coalesce_interval_ms = -1}), "coalesce_interval_ms must be positive");
}

TEST(JoyState, TheRepeatIntervalIsInWholeMilliseconds) {
  EXPECT_EQ(JoySettings{}.autorepeat_interval_ms(), 50);
  EXPECT_EQ(JoySettings{.autorepeat_rate = 30}.autorepeat_interval_ms(), 33);
  EXPECT_EQ(JoySettings{.autorepeat_rate = 0}.autorepeat_interval_ms(), 0);
  EXPECT_GT(JoySettings{.autorepeat_rate = 1e-300}.autorepeat_interval_ms(), 1'000'000);
}

TEST(GamepadDevice, IsNamedWithItsMotor) {
  const auto device = parse_device("rumble Xbox Wireless Controller");
  ASSERT_TRUE(device);
  EXPECT_EQ(device->name, "Xbox Wireless Controller");
  EXPECT_TRUE(device->can_rumble);
  EXPECT_FALSE(parse_device("still Pad")->can_rumble);
  for (const char* text : {"", "rumble", "joy Pad", " Pad"})
    EXPECT_FALSE(parse_device(text)) << text;
  EXPECT_EQ(device_topic(GamepadLayout::kController, 3), "/_gamepad/controller_3");
}

}  // namespace
}  // namespace joy
