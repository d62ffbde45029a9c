// The environment hooks of packages, and what they add to the environment of a launch file.
#include "bundler/workspace/environment_hooks.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

using Variables = std::map<std::string, std::string>;

Variables applied(const EnvironmentHook& hook, Variables variables = {}) {
  apply_hook(
      hook, "/p", [](const std::string& path) { return path == "share/d/models"; }, variables);
  return variables;
}

TEST(EnvironmentHooks, ListsPrependAppendAndSet) {
  const EnvironmentHook hook{
      "prepend-non-duplicate;MODELS;share/d/models\r\n"
      "append-non-duplicate;MODELS;/abs\n"
      "prepend-non-duplicate;MODELS;share/d/models\n"
      "prepend-non-duplicate-if-exists;MODELS;share/d/none\n"
      "prepend-non-duplicate;HERE;\n"
      "set;KIND;burger\nset;FOLDER;share/d/models\nset-if-unset;KIND;waffle\n"
      "source;share/d/local.sh\nprepend-non-duplicate;PATH;bin\nprepend-non-duplicate\n"};
  EXPECT_EQ(applied(hook, {{"MODELS", "/mine"}}),
            (Variables{{"MODELS", "/p/share/d/models:/mine:/abs"},
                       {"HERE", "/p"},
                       {"KIND", "burger"},
                       {"FOLDER", "/p/share/d/models"}}));
}

TEST(EnvironmentHooks, ScriptsAreReadAsFarAsTheyAreLists) {
  const EnvironmentHook hook{
      "# a comment\n"
      "ament_prepend_unique_value MODELS \"$AMENT_CURRENT_PREFIX/share/d/models\"\n"
      "export WORLDS=$COLCON_CURRENT_PREFIX/share/d/worlds:${WORLDS}\n"
      "export MADE=`date`\nexport PATH=/tmp\nexport\nif [ -n \"$MODELS\" ]; then\n",
      false};
  EXPECT_EQ(applied(hook, {{"WORLDS", "/w"}}),
            (Variables{{"MODELS", "/p/share/d/models"}, {"WORLDS", "/p/share/d/worlds:/w"}}));
}

TEST(EnvironmentHooks, APackageHasThemInItsShareFolder) {
  const testing::TemporaryTree tree;
  tree.write("share/demo/environment/demo.dsv", "prepend-non-duplicate;MODELS;share/demo/models\n");
  tree.write("share/demo/environment/demo.sh", "export MODELS=wrong\n");
  tree.write("share/demo/hook/other.sh", "export OTHER=right\n");
  tree.write("share/demo/environment/readme.md", "export OTHER=wrong\n");
  const InstalledPackage package{
      .name = "demo", .version = "1", .prefix = tree.root(), .programs = {}};
  EXPECT_EQ(
      with_environment_hooks({{"A", "b"}}, {package}, "/opt/ros/jazzy"),
      (Variables{{"A", "b"}, {"MODELS", "/opt/ros/jazzy/share/demo/models"}, {"OTHER", "right"}}));
}

}  // namespace
}  // namespace ros2wasm
