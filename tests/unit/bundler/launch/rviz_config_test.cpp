// Which displays of rviz2 the page has.
#include "bundler/launch/rviz_config.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace {

using Names = std::vector<std::string>;

TEST(RvizConfig, DisplaysWithTheirTopics) {
  const RvizDisplays found = rviz_displays(R"(
Panels: [{Class: rviz_common/Displays, Name: Displays}]
Visualization Manager:
  Class: ""
  Displays:
    - {Class: rviz_default_plugins/Grid, Enabled: true, Name: Grid, Value: true}
    - Class: rviz_default_plugins/LaserScan
      Enabled: true
      Name: Front laser
      Topic: {Depth: 5, Value: /scan}
    - {Class: rviz_default_plugins/Path, Enabled: true, Name: Old, Topic: /plan}
    - {Class: rviz_default_plugins/Odometry, Enabled: false, Name: Hidden, Topic: {Value: /odom}}
    - Class: rviz_common/Group
      Enabled: true
      Name: Robot
      Displays:
        - Class: rviz_default_plugins/RobotModel
          Enabled: true
          Name: ""
          Description Topic: {Value: /robot_description}
        - {Class: rviz_default_plugins/Image, Enabled: true, Name: Camera, Topic: {Value: /image}}
        - {Class: nav2_rviz_plugins/LaserScan, Enabled: true, Name: Other}
    - {Class: rviz_default_plugins/Effort, Enabled: true, Name: Effort}
)");
  EXPECT_EQ(found.shown, (Names{"Grid", "Front laser (/scan)", "Old (/plan)",
                                "RobotModel (/robot_description)"}));
  EXPECT_EQ(found.elsewhere, Names{"Camera (/image)"});
  EXPECT_EQ(found.missing, (Names{"Other", "Effort"}));
}

TEST(RvizConfig, KindsAreThoseOfThePage) {
  const auto text = read_file(
      std::filesystem::path(ROS2WASM_SOURCE_DIR) / "tests/support/rviz/kinds.rviz", kMostOfData);
  ASSERT_TRUE(text);
  const RvizDisplays found = rviz_displays(*text);
  const auto begin_with = [](const Names& names, std::string_view word) {
    return std::all_of(names.begin(), names.end(),
                       [&](const std::string& name) { return name.starts_with(word); });
  };
  EXPECT_EQ(found.shown.size(), 11U);
  EXPECT_TRUE(begin_with(found.shown, "drawn"));
  EXPECT_EQ(found.elsewhere.size(), 3U);
  EXPECT_TRUE(begin_with(found.elsewhere, "image"));
  EXPECT_EQ(found.missing.size(), 3U);
  EXPECT_TRUE(begin_with(found.missing, "skipped"));
}

TEST(RvizConfig, WhatIsNoneHasNone) {
  for (const char* text :
       {"", "[", "- a", "Visualization Manager: 1", "Visualization Manager: {Displays: {a: b}}",
        "Visualization Manager: {Displays: [1, [2]]}"}) {
    const RvizDisplays found = rviz_displays(text);
    EXPECT_TRUE(found.shown.empty() && found.elsewhere.empty()) << text;
  }
}

}  // namespace
}  // namespace ros2wasm
