#include "bundler/workspace/channel_record.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bundler/workspace/channel_request.hpp"

namespace ros2wasm {
namespace {

using Texts = std::vector<std::string>;

LocalPackage package(const std::string& name, const std::string& inside,
                     const std::string& type = "ament_cmake") {
  const auto xml = parse_package_xml(
      "<package format=\"3\"><name>" + name +
          "</name><version>1.2.0</version><description>First line\nand more</description>"
          "<maintainer email=\"a@example.org\">A</maintainer><license>MIT</license>"
          "<license>BSD-3-Clause</license>" +
          inside + "<export><build_type>" + type + "</build_type></export></package>",
      name + "/package.xml", ros_condition_variables("jazzy"));
  EXPECT_TRUE(xml);
  return {.xml = *xml};
}

const KnownNames kKnown{
    .names = {"eigen", "pyodide", "ros-jazzy-rclcpp", "ros-jazzy-rclpy", "ros-jazzy-tf2"},
    .of_lock = false,
    .absent = {}};
const ChannelAbi kAbi{.compiler_version = "3.1.6",
                      .compiler_build = "clang14.0.6_h0123456789ab_0",
                      .client_build = "hba9876543210_0"};

TEST(ChannelRecord, NeedsAreThoseOfUse) {
  const std::vector<LocalPackage> all{
      package("arm",
              "<build_depend>tf2</build_depend><depend version_gte=\"28.0\">rclcpp</depend>"
              "<exec_depend>arm_msgs</exec_depend><build_export_depend>eigen</build_export_depend>"
              "<exec_depend>nobody_has_it</exec_depend><test_depend>rclpy</test_depend>"),
      package("arm_msgs", "")};
  const CondaPackage record = channel_record(all[0], all, kKnown, "jazzy", true, kAbi);
  EXPECT_EQ(record.name, "ros-jazzy-arm");
  EXPECT_EQ(record.subdir, "emscripten-wasm32");
  EXPECT_EQ(record.noarch, NoarchKind::kNo);
  EXPECT_EQ(record.license, "MIT AND BSD-3-Clause");
  EXPECT_EQ(record.summary, "First line and more");
  EXPECT_EQ(record.depends, (Texts{"eigen", "emscripten-abi 3.1.6 clang14.0.6_h0123456789ab_0",
                                   "ros-jazzy-arm-msgs >=1.2.0", "ros-jazzy-rclcpp >=28.0",
                                   "ros2wasm-abi * hba9876543210_0"}));
}

TEST(ChannelRecord, WhatIsNotCompiledIsBoundToNoCompiler) {
  const std::vector<LocalPackage> all{package("arm_description", "<exec_depend>tf2</exec_depend>")};
  const CondaPackage record = channel_record(all[0], all, kKnown, "jazzy", false, kAbi);
  EXPECT_EQ(record.subdir, "noarch");
  EXPECT_EQ(record.noarch, NoarchKind::kGeneric);
  EXPECT_EQ(record.depends, Texts{"ros-jazzy-tf2"});
}

TEST(ChannelRecord, APythonPackageNeedsItsInterpreter) {
  const std::vector<LocalPackage> all{package("arm_plan", "", "ament_python")};
  EXPECT_EQ(channel_record(all[0], all, kKnown, "jazzy", false, kAbi).depends,
            (Texts{"pyodide", "ros-jazzy-rclpy"}));
}

TEST(ChannelRecord, ImportsThatPackageXmlForgetsCount) {
  std::vector<LocalPackage> all{package("arm", "")};
  all[0].cmake_packages.push_back({.value = "tf2", .span = {.file = {}, .line_text = {}}});
  EXPECT_EQ(channel_record(all[0], all, kKnown, "jazzy", false, kAbi).depends,
            Texts{"ros-jazzy-tf2"});
}

TEST(ChannelRecord, ALimitThatThePackageHereDoesNotKeepIsDropped) {
  const std::vector<LocalPackage> all{
      package("arm", "<depend version_gte=\"2.0\">arm_msgs</depend>"), package("arm_msgs", "")};
  EXPECT_EQ(channel_record(all[0], all, kKnown, "jazzy", false, kAbi).depends,
            Texts{"ros-jazzy-arm-msgs >=1.2.0"});
}

TEST(ChannelRecord, AnUnknownCompilerIsNamedByItsVersion) {
  const std::vector<LocalPackage> all{package("arm", "")};
  const ChannelAbi abi{.compiler_version = "3.1.6", .compiler_build = {}, .client_build = {}};
  EXPECT_EQ(channel_record(all[0], all, kKnown, "jazzy", true, abi).depends,
            Texts{"emscripten-abi 3.1.6.*"});
}

TEST(ChannelRequest, LimitsOfVersionsThatDoNotHoldInTheWorkspaceAreNamed) {
  const std::vector<LocalPackage> all{
      package("arm", "<depend version_gte=\"2.0\">arm_msgs</depend>"), package("arm_msgs", ""),
      package("hand", "<depend version_lte=\"1.2.0\">arm_msgs</depend>")};
  const auto request = channel_request(Manifest{}, all, {}, kKnown, "");
  ASSERT_TRUE(request);
  ASSERT_EQ(request->warnings.size(), 1U);
  EXPECT_EQ(request->warnings.front().code, "R2W0535");
  EXPECT_EQ(request->warnings.front().message,
            "package `arm` asks for `arm_msgs >=2.0`, and version 1.2.0 is built");
}

TEST(ChannelRecord, BuildStringsComeOfTheFiles) {
  const std::vector<LocalPackage> all{package("arm", "")};
  CondaPackage record = channel_record(all[0], all, kKnown, "jazzy", true, kAbi);
  EXPECT_EQ(channel_build_string(record, kAbi, "0123456789abcdef"), "em316_h01234567_0");
  record.build_number = 3;
  record.subdir = "noarch";
  EXPECT_EQ(channel_build_string(record, kAbi, "0123456789abcdef"), "h01234567_3");
}

}  // namespace
}  // namespace ros2wasm
