// Names: what is refused, where, and how short forms expand.
#include "ros2wasm/names.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(NodeName, AcceptsWordsAndRefusesTheRest) {
  EXPECT_FALSE(check_node_name("talker_1"));
  EXPECT_EQ(check_node_name("")->index, 0u);
  EXPECT_EQ(check_node_name("a b")->index, 1u);
  EXPECT_STREQ(check_node_name("1a")->message, "node name must not start with a number");
  EXPECT_TRUE(check_node_name(std::string(256, 'a')));
}

TEST(Namespace, IsAbsoluteWithoutTrailingOrRepeatedSlash) {
  EXPECT_FALSE(check_namespace("/"));
  EXPECT_FALSE(check_namespace("/a/b_2"));
  EXPECT_TRUE(check_namespace(""));
  EXPECT_TRUE(check_namespace("a"));
  EXPECT_EQ(check_namespace("/a/")->index, 2u);
  EXPECT_EQ(check_namespace("/a//b")->index, 3u);
  EXPECT_EQ(check_namespace("/a/2b")->index, 3u);
  EXPECT_EQ(check_namespace("/a.b")->index, 2u);
}

TEST(TopicName, KnowsTildeAndSubstitutions) {
  for (const char* name : {"chatter", "/chatter", "~", "~/x", "{node}/x", "a/{ns}", "a_1/b"}) {
    EXPECT_FALSE(check_topic_name(name)) << name;
  }
  for (const char* name :
       {"", "a/", "a~b", "~x", "a b", "{node", "node}", "{no/de}", "1a", "a/1b", "{1a}", "a-b"}) {
    EXPECT_TRUE(check_topic_name(name)) << name;
  }
  EXPECT_EQ(check_topic_name("ab~")->index, 2u);
}

TEST(FullTopicName, IsAbsolute) {
  EXPECT_FALSE(check_full_topic_name("/a/b"));
  for (const char* name : {"", "a", "/", "/a/", "/a//b", "/1", "/a b"}) {
    EXPECT_TRUE(check_full_topic_name(name)) << name;
  }
}

TEST(Expansion, FollowsNodeAndNamespace) {
  EXPECT_EQ(expand_topic_name("x", "n", "/"), "/x");
  EXPECT_EQ(expand_topic_name("x", "n", "/ns"), "/ns/x");
  EXPECT_EQ(expand_topic_name("/x", "n", "/ns"), "/x");
  EXPECT_EQ(expand_topic_name("~", "n", "/ns"), "/ns/n");
  EXPECT_EQ(expand_topic_name("~/x", "n", "/"), "/n/x");
  EXPECT_EQ(expand_topic_name("{node}/x", "n", "/ns"), "/ns/n/x");
  EXPECT_EQ(expand_topic_name("{ns}/x", "n", "/ns"), "/ns/x");
  EXPECT_EQ(expand_topic_name("{other}/x", "n", "/ns"), "");
}

}  // namespace
}  // namespace ros2wasm
