#include "bundler/workspace/launch_packages.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

std::vector<std::string> names(std::string_view text) {
  std::vector<std::string> result;
  for (const auto& one : launch_packages(text, "a.launch.py")) result.push_back(one.value);
  return result;
}

TEST(LaunchPackages, TellsThoseOfPythonLaunchFiles) {
  EXPECT_EQ(
      names("Node(package='turtlesim', executable='a'),\n"
            "Node(\n  package = \"lab_nodes\"),\n"
            "ComposableNode(package='lab_nodes', plugin='x::Y'),\n"
            "FindPackageShare('lab_maps'), FindPackageShare( package='lab_world'),\n"
            "get_package_share_directory(\n  'lab_model')"),
      (std::vector<std::string>{"turtlesim", "lab_nodes", "lab_maps", "lab_world", "lab_model"}));
}

TEST(LaunchPackages, TellsThoseOfXmlAndYaml) {
  EXPECT_EQ(names("<node pkg=\"turtlesim\" exec=\"a\"/>\n"
                  "<include file=\"$(find-pkg-share lab_maps)/launch/a.launch.xml\"/>"),
            (std::vector<std::string>{"turtlesim", "lab_maps"}));
  EXPECT_EQ(names("launch:\n- node:\n    pkg: turtlesim\n    \"pkg\": 'lab_nodes'\n"),
            (std::vector<std::string>{"turtlesim", "lab_nodes"}));
}

TEST(LaunchPackages, LeavesOutCommentsVariablesAndOtherWords) {
  EXPECT_EQ(names("# Node(package='a')\n  # pkg: b\n<!-- <node pkg=\"c\"/>\n -->\n"
                  "Node(package=name_of_it, executable='d')\nFindPackageShare(name_of_it)\n"
                  "my_package='e' FindPackageShares('f') package == 'g' pkg='' find-pkg-share"),
            std::vector<std::string>{});
}

TEST(LaunchPackages, NeedsTheSimulatorForGazebo) {
  const std::vector<std::string> simulator{"ros2wasm_sim"};
  for (const char* text :
       {"ExecuteProcess(cmd=['gz', 'sim', '-r'])", "cmd = [\n  'ign gazebo', world], shell=True",
        "cmd=['ruby $(which gz) sim ', args]",
        "cmd=[[FindExecutable(name='gazebo'), ' --verbose']]",
        "<executable cmd=\"gzserver a.world\"/>", "- executable: {cmd: /usr/bin/gz sim}"})
    EXPECT_EQ(names(text), simulator) << text;
  for (const char* text : {"cmd=['gz', 'topic']", "cmd=['ros2', 'topic', 'gz']", "cmd=gazebo_cmd",
                           "name='gazebo'", "cmd=['gz'"})
    EXPECT_EQ(names(text), std::vector<std::string>{}) << text;
}

TEST(LaunchPackages, ShowsTheProgramThatNeedsTheSimulator) {
  const auto found = launch_packages("a\ncmd=['gzserver', 'a.world']", "a.launch.py");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].span.line, 2U);
  EXPECT_EQ(found[0].span.column, 7U);
  EXPECT_EQ(found[0].span.length, 8U);
}

TEST(LaunchPackages, TellsPlaces) {
  const auto found = launch_packages("\n  Node(package='turtlesim')\n", "a.launch.py");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].span.line, 2U);
  EXPECT_EQ(found[0].span.column, 17U);
  EXPECT_EQ(found[0].span.length, 9U);
  EXPECT_EQ(found[0].span.line_text, "  Node(package='turtlesim')");
}

TEST(LaunchPackages, EndsOnAnyText) {
  const std::string pieces[] = {
      "package",        "=", "'", "pkg", ":", " ", "\n", "#", "<!--", "(", "FindPackageShare",
      "find-pkg-share", "a"};
  std::string text;
  unsigned seed = 7;
  for (int i = 0; i < 20000; ++i) {
    seed = seed * 1103515245U + 12345U;
    text += pieces[(seed >> 16U) % std::size(pieces)];
  }
  for (std::size_t length = 0; length < 200; ++length) (void)names(text.substr(0, length));
  EXPECT_LE(names(text).size(), text.size());
}

TEST(LaunchPackages, KnowsLaunchFilesByTheirNames) {
  for (const std::string name :
       {"a.launch.py", "a_launch.py", "launch.xml", "a.launch.yaml", "a_launch.yml", "a.launch"})
    EXPECT_TRUE(is_launch_file_name(name)) << name;
  for (const std::string name : {"a.py", "launch.txt", "launches", "a.launch.py.orig"})
    EXPECT_FALSE(is_launch_file_name(name)) << name;
}

TEST(DescriptionPackages, AreThoseOfThePluginsThatAreLoaded) {
  const auto found = description_packages(
      "<robot>\n<plugin filename=\"libgz_ros2_control-system.so\" name=\"c\"/>\n"
      "<plugin filename='libgazebo_ros2_control.so'/><plugin filename='gz_ros2_control-system'/>",
      "a.xacro");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].value, "gz_ros2_control");
  EXPECT_EQ(found[0].span.line, 2U);
  EXPECT_EQ(found[1].value, "gazebo_ros2_control");
  EXPECT_TRUE(
      description_packages("<plugin filename='libgazebo_ros_diff_drive.so'/>", "a").empty());
  EXPECT_TRUE(
      description_packages("<!-- <plugin filename='libgazebo_ros2_control.so'/> -->", "a").empty());
  EXPECT_TRUE(is_description_name("robot.urdf.xacro"));
  EXPECT_FALSE(is_description_name("robot.launch.py"));
}

}  // namespace
}  // namespace ros2wasm
