// Programs in CMakeLists.txt files, and the manifest that `ros2wasm init --from` writes.
#include "bundler/workspace/manifest_draft.hpp"

#include <gtest/gtest.h>

#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {
using Names = std::vector<std::string>;

TEST(ManifestDraft, ConsoleScriptsOfSetupPyAndSetupCfg) {
  EXPECT_EQ(console_script_names(R"(
setup(name='demo', entry_points={
    'console_scripts': [
        'talk = demo.talk:main',  # 'not = this:one'
        "hear=demo.hear:main",
    ],
    'other': ['x = y:z'],
})
)",
                                 ""),
            (Names{"hear", "talk"}));
  EXPECT_EQ(console_script_names("setup()", R"([options.entry_points]
console_scripts =
  talk = demo.talk:main
  hear = demo.hear:main
other =
  x = y:z
)"),
            (Names{"hear", "talk"}));
  EXPECT_EQ(console_script_names("'console_scripts': ['a", ""), Names{});
  EXPECT_EQ(console_script_names("", "console_scripts"), Names{});
}

TEST(ManifestDraft, ScriptsThatCMakeInstalls) {
  EXPECT_EQ(installed_program_names(R"(
project(demo)
install(PROGRAMS scripts/talk.py scripts/hear DESTINATION lib/${PROJECT_NAME})
install(PROGRAMS tools/x.py DESTINATION share/demo)
)"),
            (Names{"hear", "talk.py"}));
}

TEST(InstalledProgramNames, SeesTheTutorialsForm) {
  EXPECT_EQ(installed_program_names(R"(
cmake_minimum_required(VERSION 3.8)
project(demo)
add_executable(talker src/talker.cpp)  # the first
ament_target_dependencies(talker rclcpp std_msgs)
add_executable(listener
  src/listener.cpp)
install(TARGETS
  talker
  listener
  DESTINATION lib/${PROJECT_NAME})
ament_package()
)"),
            (Names{"listener", "talker"}));
}

TEST(InstalledProgramNames, SeesOtherForms) {
  EXPECT_EQ(installed_program_names(R"(
project("demo" LANGUAGES CXX)
ADD_EXECUTABLE(${PROJECT_NAME}_node main.cpp)
add_executable(tool tool.cpp)
add_executable(inner inner.cpp)
add_library(core SHARED core.cpp)
rclcpp_components_register_node(core PLUGIN "demo::Node" EXECUTABLE composed)
install(TARGETS core ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
install(TARGETS "${PROJECT_NAME}_node" tool RUNTIME DESTINATION "lib/${PROJECT_NAME}")
)"),
            (Names{"composed", "demo_node", "tool"}));
}

TEST(InstalledProgramNames, LeavesOutWhatItCannotKnow) {
  EXPECT_EQ(installed_program_names(R"(
project(demo)
# add_executable(gone gone.cpp)
add_executable(${name} x.cpp)
add_executable(not_installed y.cpp)
install(TARGETS ${name} gone DESTINATION lib/demo)
install(DIRECTORY launch DESTINATION share/demo)
)"),
            Names{});
  EXPECT_EQ(installed_program_names(""), Names{});
  EXPECT_EQ(installed_program_names("add_executable(a"), Names{});
  EXPECT_EQ(installed_program_names("install(TARGETS \"a"), Names{});
}

DraftPackage package(const std::string& name, const std::string& folder, Names programs) {
  return {.name = name,
          .version = "1.2.0",
          .license = "Apache-2.0",
          .build_type = "ament_cmake",
          .folder = folder,
          .programs = std::move(programs)};
}

TEST(DraftManifest, IsReadBack) {
  const std::string text = draft_manifest(
      {.name = "ws",
       .title = "My: \"workspace\"",
       .packages = {package("a", "src/a", {"talker", "true"}), package("b", "src/x/b", {})},
       .launch_files = {"src/a/launch/demo.launch.py", "src/a/launch/other.launch.py"}});
  const auto manifest = read_manifest(text, "workspace.yaml");
  ASSERT_TRUE(manifest.ok()) << text;
  EXPECT_EQ(manifest->name.value, "ws");
  EXPECT_EQ(manifest->title, "My: \"workspace\"");
  EXPECT_EQ(manifest->version, "1.2.0");
  EXPECT_EQ(manifest->license, "Apache-2.0");
  ASSERT_EQ(manifest->packages.size(), 1U);
  EXPECT_EQ(manifest->packages[0].value, "src");
  ASSERT_EQ(manifest->nodes.size(), 2U);
  EXPECT_EQ(manifest->nodes[0].executable.value, "talker");
  EXPECT_EQ(manifest->nodes[1].executable.value, "true");
  EXPECT_NE(text.find("#   launch: src/a/launch/demo.launch.py\n"), std::string::npos);
}

TEST(DraftManifest, StartsTheOnlyLaunchFile) {
  const std::string text = draft_manifest({.name = "ws",
                                           .title = "ws",
                                           .packages = {package("a", "src/a", {"talker"})},
                                           .launch_files = {"src/a/launch/demo.launch.py"}});
  const auto manifest = read_manifest(text, "workspace.yaml");
  ASSERT_TRUE(manifest.ok()) << text;
  ASSERT_TRUE(manifest->launch_file);
  EXPECT_EQ(manifest->launch_file->value, "src/a/launch/demo.launch.py");
  EXPECT_TRUE(manifest->nodes.empty());
}

TEST(DraftManifest, NamesFoldersOutsideOfSrc) {
  const std::string text =
      draft_manifest({.name = "ws",
                      .title = "ws",
                      .packages = {package("a", "a", {"x"}), package("b", "src/b", {})},
                      .launch_files = {}});
  const auto manifest = read_manifest(text, "workspace.yaml");
  ASSERT_TRUE(manifest.ok()) << text;
  ASSERT_EQ(manifest->packages.size(), 2U);
  EXPECT_EQ(manifest->packages[0].value, "a");
  EXPECT_EQ(manifest->packages[1].value, "src/b");
}

TEST(DraftManifest, LeavesOutWhatThePackagesDoNotAgreeOn) {
  DraftPackage other = package("b", "src/b", {});
  other.license = "MIT";
  other.version = "2.0.0";
  const std::string text = draft_manifest({.name = "ws",
                                           .title = "ws",
                                           .packages = {package("a", "src/a", {}), other},
                                           .launch_files = {}});
  EXPECT_EQ(text.find("license"), std::string::npos);
  EXPECT_NE(text.find("version: \"0.1.0\""), std::string::npos);
}

}  // namespace
}  // namespace ros2wasm
