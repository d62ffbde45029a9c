// Tests of the result of a site's launch file with other launch arguments, as the page's evaluator
// computes it.
#include "bundler/render/launch_start.hpp"

#include <gtest/gtest.h>

#include "bundler/launch/launch_paths.hpp"

namespace ros2wasm {
namespace {

std::string program(const std::string& name, const std::string& more) {
  return R"({"executable":")" + name + R"(","file":")" + name + R"(.wasm","kind":"cpp")" + more +
         "}";
}

/// A site whose container has components of two packages: one of three kinds is in it.
std::string answer(const std::string& given) {
  const std::string file = std::string(kLaunchWorkspace) + "/a.launch.xml";
  const std::string text =
      "<launch><arg name='kind' default='component_container'/><node_container "
      "pkg='rclcpp_components' exec='$(var kind)' name='box' namespace=''>"
      "<composable_node pkg='a' plugin='a::One'/><composable_node pkg='b' plugin='b::Two'/>"
      "</node_container></launch>";
  const std::string containers =
      program("component_container", "") + "," + program("component_container_mt", "");
  const std::string both =
      program("component_container-b", R"(,"program":"programs/a/component_container-b.wasm")");
  return evaluate_packed_launch(
      R"({"launch":{"file":")" + file + R"(","distro":"jazzy","texts":{")" + file + R"(":")" +
          text + R"("},"packages":[{"name":"a","version":"","programs":[)" + containers + "," +
          both + R"(]},{"name":"b","version":"","programs":[)" + containers +
          R"(]}]},"files":{},"given":{)" + given + R"(},"shared":[]})",
      {});
}

TEST(LaunchStart, AContainerOfSeveralPackagesHasItsProgram) {
  const std::string nodes = answer("");
  EXPECT_NE(nodes.find(R"("package":"a","executable":"component_container")"), nodes.npos) << nodes;
  EXPECT_NE(nodes.find(R"("program":"programs/a/component_container-b.wasm")"), nodes.npos)
      << nodes;
  EXPECT_NE(nodes.find("--component=b::Two"), nodes.npos) << nodes;
}

TEST(LaunchStart, OneThatWasNotPackedIsRefused) {
  const std::string refused = answer(R"("kind":"component_container_mt")");
  EXPECT_NE(refused.find("R2W0731"), refused.npos) << refused;
}

}  // namespace
}  // namespace ros2wasm
