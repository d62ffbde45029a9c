// ROS arguments: what is ROS', what is the program's, and which remap rule wins.

// Compatibility, works: log lines in rcutils' format, levels, macros; `--ros-args` names,
// remappings, parameters

#include "ros2wasm/arguments.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ros2wasm {
namespace {

Arguments parse(std::vector<std::string> arguments) {
  return parse_arguments(arguments);
}

TEST(Arguments, PartsRosFromTheRest) {
  const Arguments parsed =
      parse({"prog", "a", "--ros-args", "-r", "x:=y", "--", "b", "--ros-args", "-p", "n:=1"});
  EXPECT_EQ(parsed.other_arguments, (std::vector<std::string>{"prog", "a", "b"}));
  ASSERT_EQ(parsed.remaps.size(), 1u);
  ASSERT_EQ(parsed.parameters.size(), 1u);
  EXPECT_EQ(parsed.parameters[0].rule.name, "n");
  EXPECT_EQ(parsed.parameters[0].rule.value, "1");
  EXPECT_TRUE(parsed.unknown_ros_arguments.empty());
}

TEST(Arguments, NamesWhatItDoesNotKnow) {
  EXPECT_EQ(parse({"--ros-args", "--custom", "x"}).unknown_ros_arguments,
            (std::vector<std::string>{"--custom", "x"}));
}

TEST(Arguments, ReadsLogLevelsAndSwitches) {
  const Arguments parsed = parse({"--ros-args", "--log-level", "debug", "--log-level", "a.b:=WARN",
                                  "--disable-rosout-logs", "-e", "/x"});
  ASSERT_EQ(parsed.log_levels.size(), 2u);
  EXPECT_EQ(parsed.log_levels[0], std::make_pair(std::string(), 10));
  EXPECT_EQ(parsed.log_levels[1], std::make_pair(std::string("a.b"), 30));
  EXPECT_FALSE(parsed.log_rosout);
  EXPECT_TRUE(parsed.log_stdout);
  EXPECT_EQ(parsed.enclave, "/x");
}

TEST(Arguments, RefusesRulesThatCannotBe) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--ros-args", "-r"},
                                             {"--ros-args", "-r", "x"},
                                             {"--ros-args", "-r", ":=y"},
                                             {"--ros-args", "-r", "__node:=a/b"},
                                             {"--ros-args", "-r", "__ns:=relative"},
                                             {"--ros-args", "-r", "a b:=c"},
                                             {"--ros-args", "-p", "x"},
                                             {"--ros-args", "-p", ":x:=1"},
                                             {"--ros-args", "-p", "node::=1"},
                                             {"--ros-args", "-p", "/ns/node:x:y:=1"},
                                             {"--ros-args", "--log-level", "loud"}}) {
    EXPECT_THROW(parse_arguments(arguments), std::invalid_argument) << arguments.back();
  }
}

TEST(Remap, AppliesTheFirstRuleThatFits) {
  const Arguments global = parse({"--ros-args", "-r", "x:=first", "-r", "/x:=/second", "-r",
                                  "other:y:=z", "-r", "rosservice://s:=t"});
  EXPECT_EQ(remap_topic_or_service(nullptr, &global, "/x", false, "n", "/"), "/first");
  EXPECT_EQ(remap_topic_or_service(nullptr, &global, "/ns/x", false, "n", "/ns"), "/ns/first");
  EXPECT_EQ(remap_topic_or_service(nullptr, &global, "/y", false, "n", "/"), "/y");
  EXPECT_EQ(remap_topic_or_service(nullptr, &global, "/y", false, "other", "/"), "/z");
  EXPECT_EQ(remap_topic_or_service(nullptr, &global, "/s", false, "n", "/"), "/s");
  EXPECT_EQ(remap_topic_or_service(nullptr, &global, "/s", true, "n", "/"), "/t");
}

TEST(Remap, PrefersLocalRules) {
  const Arguments global = parse({"--ros-args", "-r", "x:=global", "-r", "__node:=g"});
  const Arguments local = parse({"--ros-args", "-r", "x:=local", "-r", "__ns:=/here"});
  EXPECT_EQ(remap_topic_or_service(&local, &global, "/x", false, "n", "/"), "/local");
  EXPECT_EQ(remap_node_name(&local, &global, "n"), "g");
  EXPECT_EQ(remap_node_namespace(&local, &global, "n", "/"), "/here");
}

TEST(Remap, MeansOneNodeWhenItSaysSo) {
  const Arguments global = parse({"--ros-args", "-r", "a:__node:=b", "-r", "a:__ns:=/q"});
  EXPECT_EQ(remap_node_name(nullptr, &global, "a"), "b");
  EXPECT_EQ(remap_node_name(nullptr, &global, "c"), "c");
  EXPECT_EQ(remap_node_namespace(nullptr, &global, "c", "/"), "/");
}

TEST(Parameters, KeepTheNodePatternApart) {
  const Arguments parsed =
      parse({"--ros-args", "-p", "/**:a:='x:=y'", "-p", "n:b:=[1, 2]", "--params-file", "f.yaml",
             "-p", "url:=http://h:80/p", "-p", "/ns/*:qos_overrides./t.publisher.depth:=a:b"});
  ASSERT_EQ(parsed.parameters.size(), 5u);
  EXPECT_EQ(parsed.parameters[0].rule.node, "/**");
  EXPECT_EQ(parsed.parameters[0].rule.name, "a");
  EXPECT_EQ(parsed.parameters[0].rule.value, "'x:=y'");
  EXPECT_EQ(parsed.parameters[1].rule.node, "n");
  EXPECT_TRUE(parsed.parameters[2].is_file);
  EXPECT_EQ(parsed.parameters[2].file, "f.yaml");
  EXPECT_EQ(parsed.parameters[3].rule.node, "");
  EXPECT_EQ(parsed.parameters[3].rule.name, "url");
  EXPECT_EQ(parsed.parameters[3].rule.value, "http://h:80/p");
  EXPECT_EQ(parsed.parameters[4].rule.node, "/ns/*");
  EXPECT_EQ(parsed.parameters[4].rule.name, "qos_overrides./t.publisher.depth");
  EXPECT_EQ(parsed.parameters[4].rule.value, "a:b");
}

}  // namespace
}  // namespace ros2wasm
