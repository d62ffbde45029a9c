// Any text as a launch file in XML or in YAML, with what it makes the evaluation do: substitutions,
// expressions, loops, includes of itself, xacro.
#include "bundler/launch/launch_evaluation.hpp"
#include "bundler/launch/launch_tree.hpp"
#include "tests/fuzz/require.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of(data, size));
  LaunchWorld world;
  world.environment = {{"ROS_DISTRO", "jazzy"}};
  world.prefix_of = [](const std::string& package) -> std::optional<std::string> {
    return package == "demo" ? std::optional<std::string>("/opt/ros/jazzy") : std::nullopt;
  };
  world.read = [&](const std::string& path) -> Outcome<std::string> {
    if (path.starts_with("/f/")) return text;
    return Diagnostic{.code = "R2W0413", .message = "there is no " + path};
  };
  world.names_in = [](const std::string&) { return std::vector<std::string>{"a.launch", "b"}; };
  for (const char* file : {"/f/a.launch.xml", "/f/a.launch.yaml"}) {
    const auto description = evaluate_launch(file, {{"given", "1"}}, world);
    if (description) {
      (void)launch_tree(*description);
      fuzz::require(!launch_json(*description).empty(), "a description can be written");
      continue;
    }
    fuzz::require(!description.errors().empty(), "a refusal has a reason");
    for (const Diagnostic& error : description.errors())
      fuzz::require(error.code.starts_with("R2W"), "a reason has a code");
  }
  return 0;
}
