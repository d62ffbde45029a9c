// Nodes against what is installed, their command lines, parameter files.
#include <gtest/gtest.h>

#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/node_arguments.hpp"
#include "bundler/launch/parameter_file.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "bundler/workspace/share_tree.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

Spanned<std::string> spanned(const std::string& value) {
  return {.value = value, .span = {.file = "w", .line = 9}};
}

NodeEntry node(const std::string& package, const std::string& executable) {
  NodeEntry entry;
  entry.package = spanned(package);
  entry.executable = spanned(executable);
  return entry;
}

std::vector<InstalledPackage> installed() {
  return {{.name = "demo",
           .version = "1.2.3",
           .programs = {{.package = "demo",
                         .executable = "listener",
                         .file = "/p/listener.wasm",
                         .kind = ProgramKind::kWasm},
                        {.package = "demo",
                         .executable = "tool.py",
                         .file = "/p/tool.py",
                         .kind = ProgramKind::kNone},
                        {.package = "demo",
                         .executable = "talker",
                         .file = "/p/talker.wasm",
                         .kind = ProgramKind::kWasm}}},
          {.name = "std_msgs"}};
}

TEST(NodeArguments, AreThoseOfRos2Launch) {
  NodeEntry entry = node("demo", "talker");
  entry.arguments = {"--fast"};
  entry.name = spanned("chatter");
  entry.name_space = spanned("/a");
  entry.parameters = {{.name = "rate", .value = 2.0, .files_before = 1},
                      {.name = "sub.label", .value = std::string("it's"), .files_before = 1}};
  entry.remappings = {{"topic", "/b"}};
  EXPECT_EQ(node_arguments(entry, {{{.pattern = "/**", .name = "rate", .value = "1"}}}),
            (std::vector<std::string>{"--fast", "--ros-args", "-r", "__node:=chatter", "-r",
                                      "__ns:=/a", "-p", "/**:rate:=1", "-p", "/a/chatter:rate:=2.0",
                                      "-p", "/a/chatter:sub.label:='it''s'", "-r", "topic:=/b"}));
  EXPECT_EQ(node_label(entry), "/a/chatter");
  EXPECT_TRUE(node_arguments(node("demo", "talker"), {}).empty());
  EXPECT_EQ(node_label(node("demo", "talker")), "talker");
  entry.name.reset();
  EXPECT_EQ(node_label(entry), "talker (/a)");
}

TEST(NodeArguments, WhatComesLaterWins) {
  NodeEntry entry = node("demo", "talker");
  entry.parameters = {{.name = "a", .value = std::int64_t{1}, .files_before = 0},
                      {.name = "a", .value = std::int64_t{2}, .files_before = 2}};
  entry.parameter_files = {spanned("1.yaml"), spanned("2.yaml"), spanned("3.yaml")};
  const std::vector<FileRules> files = {{{.pattern = "/x", .name = "a", .value = "10"}},
                                        {{.pattern = "/**", .name = "a", .value = "20"}},
                                        {{.pattern = "/**", .name = "a", .value = "30"}}};
  EXPECT_EQ(node_arguments(entry, files),
            (std::vector<std::string>{"--ros-args", "-p", "a:=1", "-p", "/x:a:=10", "-p",
                                      "/**:a:=20", "-p", "a:=2", "-p", "/**:a:=30"}));
}

TEST(NodeArguments, ValuesKeepTheirTypes) {
  EXPECT_EQ(parameter_text(true), "true");
  EXPECT_EQ(parameter_text(std::int64_t{-3}), "-3");
  EXPECT_EQ(parameter_text(3.0), "3.0");
  EXPECT_EQ(parameter_text(1e300), "1.0e+300");
  EXPECT_EQ(parameter_text(0.1), "0.1");
  EXPECT_EQ(parameter_text(std::string("1")), "'1'");
  EXPECT_EQ(parameter_text(std::string("a\n\"b\"")), "\"a\\x0a\\\"b\\\"\"");
  EXPECT_EQ(parameter_text(std::vector<bool>{true, false}), "[true, false]");
  EXPECT_EQ(parameter_text(std::vector<double>{1.0, 2.5}), "[1.0, 2.5]");
  EXPECT_EQ(parameter_text(std::vector<std::string>{}), "[]");
}

TEST(ParameterFile, FollowsTheRulesOfRcl) {
  const auto rules = read_parameter_file(
      "/**:\n  ros__parameters:\n    use_sim_time: yes\n"
      "ns:\n  talker:\n    ros__parameters:\n      rate: 2.0\n      words: [a, '1']\n      deep: "
      "{x: 1}\n"
      "/*/other:\n  ros__parameters: {}\n",
      "p.yaml");
  ASSERT_TRUE(rules);
  ASSERT_EQ(rules->size(), 4U);
  EXPECT_EQ((*rules)[0].pattern, "/**");
  EXPECT_EQ((*rules)[0].value, "true");
  EXPECT_EQ((*rules)[1].pattern, "/ns/talker");
  EXPECT_EQ((*rules)[1].value, "2.0");
  EXPECT_EQ((*rules)[2].value, "['a', '1']");
  EXPECT_EQ((*rules)[3].name, "deep.x");
}

TEST(ParameterFile, AllMistakesAtOnce) {
  const auto rules = read_parameter_file(
      "talker:\n  ros__parameters:\n    mixed: [1, a]\n    nothing: ~\n    nested: [[1]]\nplain: "
      "3\n",
      "p.yaml");
  ASSERT_FALSE(rules);
  EXPECT_EQ(rules.errors().size(), 4U);
  for (const Diagnostic& error : rules.errors()) {
    EXPECT_EQ(error.code, "R2W0403");
    EXPECT_GT(error.span->line, 0U);
  }
  EXPECT_FALSE(read_parameter_file("ros__parameters: {a: 1}\n", "p.yaml"));
  EXPECT_EQ(read_parameter_file("a: [", "p.yaml").errors().front().code.text(), "R2W0403");
}

TEST(LaunchNodes, CountsOverAllNodesAsLaunchDoes) {
  const auto nodes = launch_nodes(
      {node("demo", "talker"), node("demo", "listener"), node("demo", "talker")}, installed(), {});
  ASSERT_TRUE(nodes);
  EXPECT_EQ((*nodes)[0].id, "talker-1");
  EXPECT_EQ((*nodes)[1].id, "listener-2");
  EXPECT_EQ((*nodes)[2].id, "talker-3");
  EXPECT_EQ((*nodes)[2].source.line, 9U);
}

TEST(LaunchNodes, SaysWhatThereIsInstead) {
  const auto nodes = launch_nodes({node("demo", "talkr"), node("dmo", "talker"),
                                   node("demo", "tool.py"), node("std_msgs", "x")},
                                  installed(), {});
  ASSERT_FALSE(nodes);
  ASSERT_EQ(nodes.errors().size(), 4U);
  const Diagnostic& executable = nodes.errors()[0];
  EXPECT_EQ(executable.code, "R2W0402");
  EXPECT_EQ(executable.message, "package `demo` has no executable `talkr`");
  EXPECT_EQ(executable.label, "no such executable in demo 1.2.3");
  EXPECT_EQ(executable.why.front(), "its executables are: listener, tool.py, talker");
  EXPECT_EQ(executable.fix.front(), "write `executable: talker`");
  EXPECT_EQ(nodes.errors()[1].code, "R2W0401");
  EXPECT_EQ(nodes.errors()[1].fix.front(), "write `package: demo`");
  EXPECT_EQ(nodes.errors()[2].code, "R2W0405");
  EXPECT_EQ(nodes.errors()[3].why.front(), "it installs nothing into lib/std_msgs");
}

TEST(InstalledTree, FindsProgramsAndDefinitions) {
  const testing::TemporaryTree tree;
  tree.write("share/demo/package.xml", "");
  tree.write("share/demo/msg/Num.msg", "int64 num\n");
  tree.write("share/demo/srv/Add.srv", "---\n");
  tree.write("share/demo/msg/Num.json", "{}");
  tree.write("share/notes/readme", "");
  tree.write("lib/demo/talker.wasm", "x");
  tree.write("lib/demo/talker.names", "x");
  tree.write("lib/demo/script.py", "x");
  const auto packages = installed_packages(tree.root());
  ASSERT_EQ(packages.size(), 1U);
  ASSERT_EQ(packages[0].programs.size(), 2U);
  EXPECT_EQ(packages[0].programs[0].executable, "script.py");
  EXPECT_EQ(packages[0].programs[0].kind, ProgramKind::kNone);
  EXPECT_EQ(packages[0].programs[1].executable, "talker");
  InterfaceTexts texts = {{"demo/srv/Add", "nearer"}};
  collect_interfaces(tree.root(), "demo", texts);
  EXPECT_EQ(texts, (InterfaceTexts{{"demo/msg/Num", "int64 num\n"}, {"demo/srv/Add", "nearer"}}));
}

TEST(ShareTree, HasWhatProgramsReadAndNothingFromOutside) {
  const testing::TemporaryTree tree;
  tree.write("outside", "secret");
  tree.write("prefix/share/demo/config/gains.yaml", "p: 1\n");
  tree.write("prefix/share/demo/srv/notes.txt", "mine");
  tree.write("prefix/share/demo/package.txt", "too");
  tree.write("prefix/share/demo/environment/room.yaml", "walls");
  tree.write("prefix/share/ament_index/resource_index/robots/demo", "arm");
  for (const char* const for_builds :
       {"demo/cmake/demoConfig.cmake", "demo/package.xml", "demo/local_setup.bash",
        "demo/msg/Num.msg", "demo/hook/path.sh", "ament_index/resource_index/packages/demo",
        "other/config/a.yaml"})
    tree.write(std::string("prefix/share/") + for_builds, "");
  std::filesystem::create_symlink("../../../outside", tree / "prefix/share/demo/out");
  std::filesystem::create_symlink("config/gains.yaml", tree / "prefix/share/demo/in");
  std::filesystem::create_directory_symlink("config", tree / "prefix/share/demo/same");
  tree.write("prefix/share/demo/a\\b", "");
  SharedFiles files = {{"share/demo/package.txt", "nearer"}};
  const auto left_out = collect_shared_files(tree / "prefix", "demo", files);
  ASSERT_TRUE(left_out);
  EXPECT_EQ(*left_out,
            (std::vector<std::string>{
                "share/demo/a\\b, whose name with a backslash is not an address",
                "share/demo/out, a link to a folder or out of the installed packages",
                "share/demo/same, a link to a folder or out of the installed packages"}));
  EXPECT_EQ(files, (SharedFiles{{"share/ament_index/resource_index/robots/demo", "arm"},
                                {"share/demo/config/gains.yaml", "p: 1\n"},
                                {"share/demo/environment/room.yaml", "walls"},
                                {"share/demo/in", "p: 1\n"},
                                {"share/demo/package.txt", "nearer"},
                                {"share/demo/srv/notes.txt", "mine"}}));
}

TEST(ShareTree, HasTheDescriptionOfPackagesWithPathsForGazebo) {
  const testing::TemporaryTree tree;
  for (const std::string name : {"gazebo_ros", "models"}) {
    const std::string export_of = name == "models" ? "<gazebo_ros\n  gazebo_model_path='m'/>" : "";
    tree.write("share/" + name + "/package.xml", "<name>" + name + "</name>" + export_of);
    SharedFiles files;
    ASSERT_TRUE(collect_shared_files(tree.root(), name, files));
    EXPECT_EQ(files.size(), name == "models" ? 1U : 0U);
  }
}

}  // namespace
}  // namespace ros2wasm
