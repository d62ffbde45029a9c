// Discovery, order, what is asked of channels, manifests for folders without one.
#include <gtest/gtest.h>

#include <algorithm>

#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "bundler/workspace/default_manifest.hpp"
#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/host_packages.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;
using testing::TemporaryTree;

std::string package_xml(const std::string& name, const std::string& dependencies = "") {
  return "<package format=\"3\">\n<name>" + name +
         "</name>\n<version>1.0.0</version>\n"
         "<description>d</description>\n<maintainer email=\"a@example.org\">A</maintainer>\n"
         "<license>MIT</license>\n" +
         dependencies + "<export><build_type>ament_cmake</build_type></export>\n</package>\n";
}

Spanned<std::string> entry(const std::string& value) {
  return {.value = value, .span = {.file = "workspace.yaml", .line = 3, .column = 5}};
}

std::vector<LocalPackage> discovered(const TemporaryTree& tree, const std::string& pattern) {
  auto found =
      discover_packages(tree.root(), "shown", {entry(pattern)}, ros_condition_variables("jazzy"));
  EXPECT_TRUE(found);
  return found ? std::move(found).value() : std::vector<LocalPackage>();
}

std::vector<std::string> names(const std::vector<LocalPackage>& packages) {
  std::vector<std::string> result;
  for (const LocalPackage& one : packages) result.push_back(one.xml.name.value);
  return result;
}

TEST(Discovery, IsThatOfColcon) {
  const TemporaryTree tree;
  tree.write("src/a/package.xml", package_xml("a"));
  tree.write("src/a/vendor/inner/package.xml",
             package_xml("inner"));  // inside a package: not searched
  tree.write("src/group/b/package.xml", package_xml("b"));
  tree.write("src/off/COLCON_IGNORE", "");
  tree.write("src/off/c/package.xml", package_xml("c"));
  tree.write("src/off2/package.xml", package_xml("d"));
  tree.write("src/off2/AMENT_IGNORE", "");
  tree.write("src/.hidden/e/package.xml", package_xml("e"));
  fs::create_directory_symlink(tree / "src", tree / "src/group/round");
  EXPECT_EQ(names(discovered(tree, ".")), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(names(discovered(tree, "src/*")), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(names(discovered(tree, "src/a")), (std::vector<std::string>{"a"}));
  EXPECT_EQ(names(discovered(tree, "**/b")), (std::vector<std::string>{"b"}));
}

TEST(Discovery, ACMakeProjectIsAPackageOutsideOfOthers) {
  const TemporaryTree tree;
  tree.write("src/a/package.xml", package_xml("a"));
  tree.write("src/a/CMakeLists.txt", "project(a)\nfind_package(math REQUIRED)\n");
  tree.write("src/a/vendor/CMakeLists.txt", "project(vendor)\n");  // a part of a
  tree.write("src/math/CMakeLists.txt", "project(math VERSION 2.1)\nfind_package(base REQUIRED)\n");
  tree.write("src/math/inner/CMakeLists.txt", "project(inner)\n");
  tree.write("src/base/CMakeLists.txt", "project(base)\n");
  tree.write("src/twin/CMakeLists.txt", "project(a)\n");  // the name of a package of ROS
  tree.write("src/parts/CMakeLists.txt", "add_library(parts parts.cpp)\n");  // names no project
  tree.write("src/all/CMakeLists.txt", "project(all)\n");  // brings packages together
  tree.write("src/all/b/package.xml", package_xml("b"));
  for (const char* pattern : {".", "src/*", "src/**", "**"}) {
    const auto packages = discovered(tree, pattern);
    EXPECT_EQ(names(packages), (std::vector<std::string>{"a", "b", "base", "math"})) << pattern;
    for (const LocalPackage& one : packages) {
      const bool is_plain = one.xml.name.value == "base" || one.xml.name.value == "math";
      EXPECT_EQ(one.is_plain_cmake, is_plain);
      EXPECT_EQ(one.xml.build_type == "cmake", is_plain);
    }
    EXPECT_EQ(packages[3].xml.version.value, "2.1");
    const auto order = order_packages(packages, "jazzy");
    ASSERT_TRUE(order);
    std::vector<std::string> built;
    for (const std::size_t one : order->order) built.push_back(packages[one].xml.name.value);
    EXPECT_LT(std::find(built.begin(), built.end(), "base"),
              std::find(built.begin(), built.end(), "math"));
    EXPECT_LT(std::find(built.begin(), built.end(), "math"),
              std::find(built.begin(), built.end(), "a"));
  }
}

TEST(Discovery, AnEntryThatLeadsNowhereIsAnErrorWithItsPlace) {
  const TemporaryTree tree;
  tree.write("src/a/package.xml", package_xml("a"));
  const auto found =
      discover_packages(tree.root(), "shown", {entry("src/*"), entry("srk/*"), entry("nothing")},
                        ros_condition_variables("jazzy"));
  ASSERT_FALSE(found);
  ASSERT_EQ(found.errors().size(), 2U);
  EXPECT_EQ(found.errors()[0].code, "R2W0510");
  EXPECT_EQ(found.errors()[0].span->line, 3U);
  EXPECT_EQ(shown_path("/w/src/a", "/w", "shown"), "shown/src/a");
  EXPECT_EQ(shown_path("/w/src/a", "/w", ""), "src/a");
  EXPECT_EQ(shown_path("/w", "/w", "."), "");
  EXPECT_EQ(shown_path("/elsewhere/a", "/w", "shown"), "/elsewhere/a");
}

TEST(BuildOrder, WhatIsNeededComesFirst) {
  const TemporaryTree tree;
  tree.write("src/app/package.xml",
             package_xml("app", "<depend>middle</depend><depend>std_msgs</depend>\n"));
  tree.write("src/base/package.xml",
             package_xml("base", "<buildtool_depend>ament_cmake</buildtool_depend>\n"));
  tree.write("src/middle/package.xml",
             package_xml("middle",
                         "<build_depend>base</build_depend><exec_depend>app</exec_depend>\n"
                         "<depend version_gte=\"2.0.0\">rclcpp</depend>\n"
                         "<test_depend>ament_lint_auto</test_depend>\n"));
  const auto packages = discovered(tree, "src");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  EXPECT_EQ(order->order, (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(order->needs[0], (std::vector<std::size_t>{1, 2}));
  ASSERT_EQ(order->external.size(), 2U);
  EXPECT_EQ(order->external[0].match_spec, "ros-jazzy-rclcpp >=2.0.0");
  EXPECT_EQ(order->external[1].match_spec, "ros-jazzy-std-msgs");
}

TEST(BuildOrder, MembersOfAGroupComeBeforeWhatDependsOnIt) {
  const TemporaryTree tree;
  const std::string member = "<member_of_group>our_interfaces</member_of_group>\n";
  tree.write("src/all/package.xml",
             package_xml(
                 "all", "<group_depend>our_interfaces</group_depend>\n" + member +
                            "<group_depend condition=\"$ROS_VERSION == 1\">ros1</group_depend>\n"));
  tree.write("src/arms/package.xml", package_xml("arms", member));
  tree.write("src/other/package.xml",
             package_xml("other", "<member_of_group>ros1</member_of_group>\n"));
  tree.write("src/wheels/package.xml", package_xml("wheels", member));
  const auto order = order_packages(discovered(tree, "src"), "jazzy");
  ASSERT_TRUE(order);
  EXPECT_EQ(order->needs[0], (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(order->order, (std::vector<std::size_t>{1, 3, 0, 2}));
  EXPECT_TRUE(order->external.empty());
}

TEST(BuildOrder, Format2SaysTheSame) {
  const TemporaryTree tree;
  tree.write("src/app/package.xml",
             "<package format=\"2\">\n<name>app</name>\n<version>1.0.0</version>\n"
             "<description>d</description>\n<maintainer email=\"a@example.org\">A</maintainer>\n"
             "<license>MIT</license>\n<buildtool_depend>ament_cmake</buildtool_depend>\n"
             "<depend>lib</depend>\n<build_export_depend>geometry_msgs</build_export_depend>\n"
             "<exec_depend>tools</exec_depend>\n<test_depend>checks</test_depend>\n"
             "<doc_depend>doxygen</doc_depend>\n"
             "<export><build_type>ament_cmake</build_type></export>\n</package>\n");
  tree.write("src/lib/package.xml", package_xml("lib"));
  tree.write("src/tools/package.xml", package_xml("tools"));
  const auto packages = discovered(tree, "src");
  ASSERT_EQ(packages.size(), 3U);
  EXPECT_EQ(packages[0].xml.format, 2);
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  EXPECT_EQ(order->needs[0], std::vector<std::size_t>{1});  // tools are for running only
  ASSERT_EQ(order->external.size(), 1U);
  EXPECT_EQ(order->external[0].match_spec, "ros-jazzy-geometry-msgs");
}

TEST(BuildOrder, CirclesAndTwinsAreErrors) {
  const TemporaryTree tree;
  tree.write("src/a/package.xml", package_xml("a", "<build_depend>b</build_depend>\n"));
  tree.write("src/b/package.xml", package_xml("b", "<depend>a</depend>\n"));
  const auto circle = order_packages(discovered(tree, "src"), "jazzy");
  ASSERT_FALSE(circle);
  EXPECT_EQ(circle.errors().front().code.text(), "R2W0512");
  EXPECT_EQ(circle.errors().front().why.front(), "`a` needs `b` needs `a`");
  const TemporaryTree twins;
  twins.write("src/x/package.xml", package_xml("same"));
  twins.write("src/y/package.xml", package_xml("same"));
  const auto twice = order_packages(discovered(twins, "src"), "jazzy");
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.errors().front().code.text(), "R2W0511");
}

TEST(ChannelRequest, EverythingMissingAtOnceWithItsLine) {
  const TemporaryTree tree;
  tree.write("src/a/package.xml", package_xml("a",
                                              "<depend>std_mgs</depend>\n<depend>pcl_ros</depend>\n"
                                              "<exec_depend>slam_toolbox</exec_depend>\n"));
  const auto packages = discovered(tree, "src");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  const auto request =
      channel_request(Manifest{}, packages, {}, {.names = {"ros-jazzy-std-msgs"}}, "3.1.6");
  ASSERT_FALSE(request);
  ASSERT_EQ(request.errors().size(), 2U);  // slam_toolbox is a warning only
  EXPECT_EQ(request.errors()[0].code, "R2W0513");
  EXPECT_EQ(request.errors()[0].span->line, 8U);
  EXPECT_EQ(request.errors()[1].span->line, 7U);
  ASSERT_EQ(request.errors()[1].why.size(), 3U);
  EXPECT_EQ(request.errors()[1].why[1], "a channel has `ros-jazzy-std-msgs`");
}

TEST(ChannelRequest, HasPackagesNodesAndTheCompiler) {
  const TemporaryTree tree;
  tree.write(
      "src/a/package.xml",
      package_xml("a", "<depend>std_msgs</depend>\n<exec_depend>slam_toolbox</exec_depend>\n"));
  const auto packages = discovered(tree, "src");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  Manifest manifest;
  manifest.dependencies = {entry("nav_msgs >=5"), entry("zlib"), entry("ros-jazzy-std-msgs")};
  NodeEntry node;
  node.package.value = "demo_nodes";
  manifest.nodes.push_back(node);
  const auto request =
      channel_request(manifest, packages, {},
                      {.names = {"emscripten-abi", "ros-jazzy-demo-nodes", "ros-jazzy-nav-msgs",
                                 "ros-jazzy-ros2wasm-core", "ros-jazzy-ros2wasm-std",
                                 "ros-jazzy-std-msgs", "zlib"}},
                      "3.1.6");
  ASSERT_TRUE(request);
  std::vector<std::string> texts;
  for (const RequestedSpec& spec : request->specs) texts.push_back(spec.text);
  EXPECT_EQ(texts,
            (std::vector<std::string>{"emscripten-abi 3.1.6.*", "ros-jazzy-demo-nodes",
                                      "ros-jazzy-nav-msgs >=5", "ros-jazzy-ros2wasm-core",
                                      "ros-jazzy-ros2wasm-std", "ros-jazzy-std-msgs", "zlib"}));
  ASSERT_EQ(request->warnings.size(), 1U);
  EXPECT_EQ(request->warnings[0].severity, Severity::kWarning);
}

TEST(ChannelRequest, OnlyNamesOfRosPackagesAreTakenForSuch) {
  const auto spec = [](const std::string& text) {
    return dependency_spec(text, "jazzy", {"_openmp_mutex", "ros-jazzy-nav-msgs"});
  };
  EXPECT_EQ(spec("nav_msgs >=5"), "ros-jazzy-nav-msgs >=5");
  EXPECT_EQ(spec("my_nodes"), "ros-jazzy-my-nodes");
  EXPECT_EQ(spec("nlohmann-json-dev >=3"), "nlohmann_json >=3");
  EXPECT_EQ(spec("libyaml-cpp-dev"), "yaml-cpp");
  EXPECT_EQ(spec("liborocos-kdl-dev"), "orocos-kdl");
  EXPECT_EQ(spec("orocos_kdl"), "orocos-kdl");
  EXPECT_EQ(spec("libboost-all-dev"), "libboost-headers");
  EXPECT_EQ(spec("geographiclib >=2"), "geographiclib-cpp >=2");
  for (const std::string same :
       {"_openmp_mutex", "https://host/c/noarch/more-1.0-h_0.conda", "more-1.0-h_0.conda",
        "./here/noarch/more-1.0-h_0.tar.bz2", "./my_channel::lib", "numpy"})
    EXPECT_EQ(spec(same), same);
}

TEST(ChannelRequest, WhatALockLacksIsAskedForAllTheSame) {
  const TemporaryTree tree;
  tree.write("src/a/package.xml",
             package_xml("a", "<depend>other</depend>\n<exec_depend>slam_toolbox</exec_depend>\n"));
  const auto packages = discovered(tree, "src");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  const auto request =
      channel_request(Manifest{}, packages, {}, {.names = {}, .of_lock = true}, "3.1.6");
  ASSERT_TRUE(request);
  ASSERT_EQ(request->specs.size(), 1U);
  EXPECT_EQ(request->specs[0].text, "ros-jazzy-other");
  ASSERT_EQ(request->warnings.size(), 1U);
  EXPECT_EQ(request->warnings[0].message,
            "the lock has no `slam_toolbox`, and the workspace has not either");
}

TEST(LeftOut, WhatLacksSomethingAndWhatNeedsIt) {
  const TemporaryTree tree;
  tree.write("src/arm/package.xml", package_xml("arm", "<depend>std_msgs</depend>\n"));
  tree.write("src/lab/package.xml",
             package_xml("lab", "<depend>sim</depend>\n<depend>std_msgs</depend>\n"));
  tree.write("src/menu/package.xml", package_xml("menu", "<exec_depend>sim</exec_depend>\n"));
  tree.write("src/sim/package.xml",
             package_xml("sim",
                         "<depend>std_mgs</depend>\n<build_depend>gazebo_ros</build_depend>\n"
                         "<exec_depend>slam_toolbox</exec_depend>\n"));
  const auto packages = discovered(tree, "src");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  const std::vector<std::string> types = {"ament_cmake"};
  const KnownNames known{.names = {"ros-jazzy-std-msgs"}};
  const auto left_out = left_out_packages(packages, *order, known, "jazzy", types);
  EXPECT_EQ(
      chains_by_name(packages, left_out),
      (LeftOutChains{{"lab",
                      {"it needs `sim`, which is skipped",
                       "`sim` is skipped: no channel has `std_mgs`, `gazebo_ros`, which it needs "
                       "(shown/src/sim/package.xml:7)"}},
                     {"sim",
                      {"no channel has `std_mgs`, `gazebo_ros`, which it needs "
                       "(shown/src/sim/package.xml:7)"}}}));
  EXPECT_EQ(left_out.at(3).warning.code, "R2W0519");
  EXPECT_EQ(left_out.at(3).warning.severity, Severity::kWarning);
  EXPECT_EQ(left_out.at(3).warning.why.front(), "a channel has `ros-jazzy-std-msgs`");

  // Skipped packages request nothing, and the lock stores the names that no channel has.
  const auto request = channel_request(Manifest{}, packages, left_out, known, "");
  ASSERT_TRUE(request);
  ASSERT_EQ(request->specs.size(), 1U);
  EXPECT_EQ(request->specs[0].text, "ros-jazzy-std-msgs");
  EXPECT_EQ(request->absent,
            (std::vector<std::string>{"ros-jazzy-gazebo-ros", "ros-jazzy-std-mgs"}));
  const KnownNames locked{.names = known.names, .of_lock = true, .absent = request->absent};
  EXPECT_EQ(left_out_packages(packages, *order, locked, "jazzy", types).size(), 2U);
  // A name that the lock does not know may be in a channel by now.
  EXPECT_TRUE(
      left_out_packages(packages, *order, {.names = known.names, .of_lock = true}, "jazzy", types)
          .empty());
}

TEST(LeftOut, NotWhatCanBePackedWithoutANameOfItsPackageXml) {
  const TemporaryTree tree;
  const std::string wants = "<depend>gazebo_ros</depend>\n<depend>std_msgs</depend>\n";
  std::string python = package_xml("arm", wants);
  python.replace(python.find("ament_cmake"), 11, "ament_python");
  tree.write("src/arm/package.xml", python);
  tree.write("src/model/package.xml", package_xml("model", wants));
  tree.write("src/model/CMakeLists.txt",
             "find_package(ament_cmake REQUIRED)\ninstall(DIRECTORY urdf DESTINATION share)\n");
  // This one compiles something, and does not ask for it.
  tree.write("src/arm_driver/package.xml", package_xml("arm_driver", wants));
  tree.write("src/arm_driver/CMakeLists.txt", "add_executable(driver driver.cpp)\n");
  // These ask CMake for it, or nothing tells what they ask for.
  tree.write("src/plugin/package.xml", package_xml("plugin", wants));
  tree.write("src/plugin/CMakeLists.txt",
             "find_package(gazebo_ros REQUIRED)\ninstall(DIRECTORY urdf DESTINATION share)\n");
  tree.write("src/sim/package.xml", package_xml("sim", wants));
  const auto packages = discovered(tree, "src");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  const std::vector<std::string> types = {"ament_cmake", "ament_python"};
  const KnownNames known{.names = {"ros-jazzy-std-msgs"}};
  const auto left_out = left_out_packages(packages, *order, known, "jazzy", types);
  std::vector<std::string> out;
  for (const auto& [index, reason] : left_out) out.push_back(packages[index].xml.name.value);
  EXPECT_EQ(out, (std::vector<std::string>{"plugin", "sim"}));

  const Lacks lacks = packages_with_lacks(packages, left_out, known, "jazzy");
  ASSERT_EQ(lacks.size(), 2U);  // arm_driver and model
  for (const auto& [index, lack] : lacks) {
    ASSERT_EQ(lack.reason.chain.size(), 1U);
    EXPECT_TRUE(lack.reason.chain.front().starts_with(
        "no channel has `gazebo_ros`, which it needs (shown/src/"));
    ASSERT_EQ(lack.missing.size(), 1U);
    EXPECT_EQ(lack.missing[0].code, "R2W0513");
    EXPECT_EQ(lack.missing[0].severity, Severity::kError);
  }

  const auto request = channel_request(Manifest{}, packages, left_out, known, "");
  ASSERT_TRUE(request);
  ASSERT_EQ(request->specs.size(), 1U);
  EXPECT_EQ(request->specs[0].text, "ros-jazzy-std-msgs");
  ASSERT_EQ(request->warnings.size(), 1U);
  EXPECT_EQ(request->warnings[0].message,
            "no channel has `gazebo_ros`, and the workspace has not either");
  EXPECT_EQ(request->absent, std::vector<std::string>{"ros-jazzy-gazebo-ros"});

  // The lock says the same; what it never heard of may be in a channel by now, and is asked for.
  const KnownNames locked{.names = known.names, .of_lock = true, .absent = request->absent};
  const auto again =
      channel_request(Manifest{}, packages,
                      left_out_packages(packages, *order, locked, "jazzy", types), locked, "");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->specs.size(), 1U);
  EXPECT_EQ(again->absent, request->absent);
  const auto asked =
      channel_request(Manifest{}, packages, {}, {.names = known.names, .of_lock = true}, "");
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->specs.size(), 2U);
}

TEST(LeftOut, NoneWhenNothingWouldRemain) {
  const TemporaryTree tree;
  tree.write("src/lab/package.xml", package_xml("lab", "<depend>sim</depend>\n"));
  tree.write("src/sim/package.xml", package_xml("sim", "<depend>gazebo_ros</depend>\n"));
  const auto packages = discovered(tree, "src");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  EXPECT_TRUE(left_out_packages(packages, *order, {}, "jazzy", {"ament_cmake"}).empty());
  const auto request = channel_request(Manifest{}, packages, {}, {}, "");
  ASSERT_FALSE(request);
  EXPECT_EQ(request.errors()[0].code, "R2W0513");
}

TEST(ChannelRequest, PythonModulesComeFromPackagesOfOtherNames) {
  const TemporaryTree tree;
  tree.write("src/a/package.xml", package_xml("a", "<depend>tf2_ros</depend>\n"));
  tree.write("src/a/a/node.py", "import numpy, yaml\nfrom tf2_ros import Buffer\n");
  tree.write("src/b/package.xml", package_xml("b", "<depend>tf2_geometry_msgs</depend>\n"));
  tree.write("src/b/b/node.py", "import tf2_geometry_msgs\n");
  const auto packages = discovered(tree, "src/*");
  const auto order = order_packages(packages, "jazzy");
  ASSERT_TRUE(order);
  const KnownNames known = {.names = {"numpy", "pyyaml", "ros-jazzy-tf2-geometry-msgs",
                                      "ros-jazzy-tf2-ros", "ros-jazzy-tf2-ros-py"}};
  const auto request = channel_request(Manifest{}, packages, {}, known, "");
  ASSERT_TRUE(request);
  std::vector<std::string> asked;
  for (const RequestedSpec& one : request->specs) asked.push_back(one.text);
  EXPECT_EQ(asked, known.names);
  // That tf2_geometry_msgs needs more for Python is not the user's concern.
  ASSERT_EQ(request->warnings.size(), 1U);
  EXPECT_EQ(request->warnings[0].fix.front(),
            "add `<depend>python3-numpy</depend><depend>python3-yaml</depend>"
            "<depend>tf2_ros_py</depend>` to package.xml");
}

TEST(BuildOrder, EveryVersionLimitCountsOnce) {
  const TemporaryTree tree;
  const auto limited = [](const std::string& limits) {
    return "<depend " + limits + ">other</depend>\n";
  };
  tree.write("src/a/package.xml", package_xml("a", limited("version_lt=\"1.5\"")));
  tree.write("src/b/package.xml", package_xml("b", limited("version_lt=\"1\"")));
  tree.write("src/c/package.xml", package_xml("c", limited("version_lt=\"1.5\"")));
  const auto order = order_packages(discovered(tree, "src"), "jazzy");
  ASSERT_TRUE(order);
  ASSERT_EQ(order->external.size(), 1U);
  EXPECT_EQ(order->external[0].match_spec, "ros-jazzy-other <1.5,<1");
}

TEST(HostPackages, ToolsOfTheMachineNeedNoChannel) {
  EXPECT_FALSE(host_package_reason("ament_cmake").empty());
  EXPECT_FALSE(host_package_reason("ament_lint_common").empty());
  EXPECT_TRUE(host_package_reason("rclcpp").empty());
  EXPECT_TRUE(host_package_reason("ament_index_cpp").empty());
}

TEST(DefaultManifest, IsNamedAfterTheFolder) {
  EXPECT_EQ(default_manifest("/home/me/My ROS-2 ws").name.value, "my_ros_2_ws");
  EXPECT_EQ(default_manifest("/home/me/2024").name.value, "workspace");
  const std::vector<InstalledPackage> local = {
      {.name = "a",
       .programs = {{.package = "a", .executable = "run.py", .kind = ProgramKind::kNone},
                    {.package = "a", .executable = "talker", .kind = ProgramKind::kWasm}}}};
  const auto nodes = default_nodes(local);
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_EQ(nodes[0].executable.value, "talker");
}

}  // namespace
}  // namespace ros2wasm
