// The name rules of ROS 2 and of the site, and that every offered name passes the rule it broke.
#include "workspace_schema/base/names.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ros2wasm {
namespace {

struct Case {
  std::string text;
  std::string better;  ///< "" when none is offered
};

void expect_good(std::optional<NameFault> (*check)(std::string_view),
                 const std::vector<std::string>& names) {
  for (const std::string& name : names) EXPECT_FALSE(check(name).has_value()) << name;
}

void expect_bad(std::optional<NameFault> (*check)(std::string_view),
                const std::vector<Case>& cases) {
  for (const Case& bad : cases) {
    const auto fault = check(bad.text);
    ASSERT_TRUE(fault.has_value()) << bad.text;
    EXPECT_EQ(fault->better.value_or(""), bad.better) << bad.text;
    EXPECT_LE(fault->offset + fault->length, std::max<std::size_t>(bad.text.size(), 1)) << bad.text;
    const std::string better = fault->better.value_or("");
    EXPECT_TRUE(better.empty() || !check(better).has_value()) << better;
  }
}

TEST(Names, Node) {
  expect_good(node_name_fault, {"talker", "_hidden", "n1", "Talker_2", std::string(255, 'a')});
  expect_bad(node_name_fault, {{"", ""},
                               {"my-node", "my_node"},
                               {"2talker", "_2talker"},
                               {"a/b", "a_b"},
                               {"a b", "a_b"},
                               {"t\xC3\xA4lker", "t_lker"},
                               {"---", ""},
                               {std::string(256, 'a'), ""}});
}

TEST(Names, Namespace) {
  expect_good(namespace_fault, {"/", "/robot1", "robot1", "/a/b_c", "a/b"});
  expect_bad(namespace_fault, {{"", ""},
                               {"/robot1/", "/robot1"},
                               {"//robot1", "/robot1"},
                               {"/a//b", "/a/b"},
                               {"/1a", "/_1a"},
                               {"robot-1", "robot_1"},
                               {"{ns}/a", "ns/a"}});
}

TEST(Names, Topic) {
  expect_good(topic_name_fault,
              {"chatter", "/chatter", "~/x", "~", "{node}/x", "/a/{ns}/b", "_hidden/x"});
  expect_bad(topic_name_fault, {{"", ""},
                                {"/", ""},
                                {"cmd vel", "cmd_vel"},
                                {"/a/", "/a"},
                                {"a~b", "a_b"},
                                {"~x", "~/x"},
                                {"{robot}/x", "robot/x"},
                                {"/1", "/_1"},
                                {"{node", "node"}});
}

TEST(Names, PackageAndWorkspace) {
  expect_good(package_name_fault, {"demo", "Demo_2", "a-b"});
  expect_bad(package_name_fault,
             {{"", ""}, {"2d", "d"}, {"my package", "my_package"}, {"_a", "a"}, {"a.b", "a_b"}});
  expect_good(channel_package_name_fault,
              {"numpy", "_openmp_mutex", "r-base64enc", "7zip", "a.b", "c++"});
  expect_bad(channel_package_name_fault,
             {{"", ""}, {"NumPy", ""}, {"a >=1", ""}, {"x::a", ""}, {"-a", ""}, {"a*", ""}});
  expect_good(workspace_name_fault, {"talker_listener", "lab-1.2", "2d"});
  expect_bad(workspace_name_fault,
             {{"", ""}, {"My Lab!", "My_Lab"}, {"../up", "up"}, {".", ""}, {".git", "git"}});
}

TEST(Names, ExecutableAndParameter) {
  expect_good(executable_name_fault, {"talker", "talker.py", "my-node", "t\xC3\xA4lker"});
  expect_bad(executable_name_fault, {{"", ""}, {"a/b", ""}, {"..", ""}, {"a b", ""}});
  expect_good(parameter_name_fault, {"rate", "qos_overrides./chatter.publisher.depth", "a.b-c"});
  expect_bad(parameter_name_fault, {{"", ""}, {".a", ""}, {"a.", ""}, {"a..b", ""}, {"a b", ""}});
}

TEST(Names, StrongTypesHaveOneDoor) {
  const auto good = NodeName::parse("talker");
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(good->text(), "talker");
  const auto bad = NodeName::parse("my-node");
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.errors()[0].code, "R2W0104");
  EXPECT_EQ(bad.errors()[0].fix, std::vector<std::string>{"write `my_node`"});
}

}  // namespace
}  // namespace ros2wasm
