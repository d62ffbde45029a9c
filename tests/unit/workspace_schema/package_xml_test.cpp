// package.xml: formats, kinds, conditions, places, and mistakes.
#include "workspace_schema/schema/package_xml.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

using Kind = DependencyKind;

Outcome<PackageXml> parse(std::string_view text) {
  return parse_package_xml(text, "src/demo/package.xml", ros_condition_variables("jazzy"));
}

std::string message_of(const Outcome<PackageXml>& outcome, std::size_t index = 0) {
  return outcome.ok() || outcome.errors().size() <= index ? "" : outcome.errors()[index].message;
}

constexpr std::string_view kFormat3 = R"(<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>demo</name>
  <version>1.2.3</version>
  <description>
    Two lines
    of text.
  </description>
  <maintainer email="a@b.c">A</maintainer>
  <license>Apache-2.0</license>
  <license>BSD</license>
  <!-- <depend>commented</depend> -->
  <buildtool_depend>ament_cmake</buildtool_depend>
  <depend>rclcpp</depend><depend version_gte="1.0.0">std_msgs</depend>
  <exec_depend condition="$ROS_VERSION == 1">roscpp</exec_depend>
  <exec_depend condition="$ROS_DISTRO >= humble">launch_ros</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export>
    <build_type condition="$ROS_VERSION == 1">catkin</build_type>
    <build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>
  </export>
</package>
)";

TEST(PackageXml, ReadsFormat3) {
  const auto package = parse(kFormat3);
  ASSERT_TRUE(package.ok()) << message_of(package);
  EXPECT_EQ(package->format, 3);
  EXPECT_EQ(package->name.value, "demo");
  EXPECT_EQ(package->version.value, "1.2.3");
  EXPECT_EQ(package->description, "Two lines of text.");
  EXPECT_EQ(package->build_type, "ament_cmake");
  ASSERT_EQ(package->licenses.size(), 2U);
  EXPECT_EQ(package->licenses[1].value, "BSD");
  ASSERT_EQ(package->member_of_groups.size(), 1U);
  EXPECT_EQ(package->names_of({Kind::kBuildTool}), std::vector<std::string>{"ament_cmake"});
  EXPECT_EQ(package->names_of({Kind::kBuild}), (std::vector<std::string>{"rclcpp", "std_msgs"}));
  EXPECT_EQ(package->names_of({Kind::kExec}),
            (std::vector<std::string>{"launch_ros", "rclcpp", "std_msgs"}));
}

TEST(PackageXml, PlacesAreThoseOfTheNames) {
  const auto package = parse(kFormat3);
  ASSERT_TRUE(package.ok());
  EXPECT_EQ(package->name.span.line, 4U);
  EXPECT_EQ(package->name.span.column, 9U);
  EXPECT_EQ(package->name.span.length, 4U);
  for (const PackageDependency& dependency : package->dependencies) {
    const SourceSpan& span = dependency.name.span;
    EXPECT_EQ(span.line_text.substr(span.column - 1, span.length), dependency.name.value);
  }
  const auto& std_msgs = package->dependencies[4];
  EXPECT_EQ(std_msgs.name.value, "std_msgs");
  EXPECT_EQ(std_msgs.name.span.column, 54U);
  EXPECT_EQ(std_msgs.version_limits.at("gte"), "1.0.0");
}

TEST(PackageXml, RunDependOfFormat1IsBuildExportAndExec) {
  const auto package = parse(
      "<package><name>a</name><version>0.0.1</version><run_depend>b</run_depend>"
      "<build_depend>c</build_depend></package>");
  ASSERT_TRUE(package.ok()) << message_of(package);
  EXPECT_EQ(package->format, 1);
  EXPECT_EQ(package->names_of({Kind::kExec}), std::vector<std::string>{"b"});
  EXPECT_EQ(package->names_of({Kind::kBuildExport}), std::vector<std::string>{"b"});
  EXPECT_EQ(package->names_of({Kind::kBuild}), std::vector<std::string>{"c"});
  EXPECT_EQ(package->build_type, "");
}

TEST(PackageXml, ReportsAllMistakes) {
  const auto package = parse(R"(<package format="3">
  <name>my package</name>
  <version>1.2</version>
  <run_depend>x</run_depend>
  <dependd>rclcpp</dependd>
  <depend condition="$A ==">y</depend>
  <depend></depend>
</package>)");
  ASSERT_FALSE(package.ok());
  ASSERT_EQ(package.errors().size(), 6U);
  EXPECT_EQ(package.errors()[0].code, "R2W0122");
  EXPECT_EQ(package.errors()[0].fix, std::vector<std::string>{"<name>my_package</name>"});
  EXPECT_EQ(package.errors()[1].code, "R2W0122");
  EXPECT_EQ(package.errors()[2].fix, std::vector<std::string>{"<exec_depend>x</exec_depend>"});
  EXPECT_EQ(package.errors()[3].fix, std::vector<std::string>{"<depend>rclcpp</depend>"});
  EXPECT_EQ(package.errors()[4].code, "R2W0123");
  EXPECT_EQ(package.errors()[5].message, "`<depend>` names no package");
}

TEST(PackageXml, BrokenXmlHasALine) {
  const auto package = parse("<package format=\"3\">\n  <name>a</nam>\n</package>\n");
  ASSERT_FALSE(package.ok());
  EXPECT_EQ(package.errors()[0].code, "R2W0120");
  ASSERT_TRUE(package.errors()[0].span.has_value());
  EXPECT_EQ(package.errors()[0].span->line, 2U);
}

// Guarantee, hostile input: a package.xml that is cut, deep, binary or no package is an error
TEST(PackageXml, HostileTextsAreErrors) {
  EXPECT_FALSE(parse("").ok());
  EXPECT_FALSE(parse("no xml").ok());
  EXPECT_FALSE(parse(std::string_view("<package>\0</package>", 20)).ok());
  EXPECT_FALSE(parse("<package>\xFF</package>").ok());
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_FALSE(parse(deep).ok());
  EXPECT_FALSE(parse("<robot/>").ok());
  EXPECT_FALSE(
      parse("<package format=\"9\"><name>a</name><version>1.0.0</version></package>").ok());
}

TEST(Condition, FollowsRep149) {
  const ConditionVariables variables{{"ROS_VERSION", "2"}, {"ROS_DISTRO", "jazzy"}};
  const auto holds = [&](std::string_view text) { return evaluate_condition(text, variables); };
  EXPECT_EQ(holds("$ROS_VERSION == 2"), true);
  EXPECT_EQ(holds("$ROS_VERSION==1"), false);
  EXPECT_EQ(holds("$ROS_DISTRO > humble"), true);
  EXPECT_EQ(holds("$ROS_DISTRO == \"jazzy\" and $ROS_VERSION != '1'"), true);
  EXPECT_EQ(holds("$X == 1 or $ROS_VERSION == 2 and $X == ''"), true);
  EXPECT_EQ(holds("($X == 1 or $ROS_VERSION == 2) and $X == 3"), false);
  EXPECT_EQ(holds("or"), std::nullopt);
  EXPECT_EQ(holds("$ROS_VERSION"), std::nullopt);
  EXPECT_EQ(holds("$ROS_VERSION == 2 )"), std::nullopt);
  EXPECT_EQ(holds("a == b c"), std::nullopt);
  EXPECT_EQ(holds(std::string(1000, '(')), std::nullopt);
}

}  // namespace
}  // namespace ros2wasm
