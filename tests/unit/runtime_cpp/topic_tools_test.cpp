// Which messages the tools of topic_tools let through, and the topics of mux and demux.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "flow_rules.hpp"
#include "topic_selection.hpp"

namespace topic_tools {
namespace {

constexpr int64_t kMs = 1'000'000;

TEST(MessageThrottle, PassesOneMessageInEachPeriod) {
  MessageThrottle throttle(100 * kMs, 0);
  EXPECT_FALSE(throttle.passes(99 * kMs));  // a period after the start at the earliest
  EXPECT_TRUE(throttle.passes(100 * kMs));
  EXPECT_FALSE(throttle.passes(199 * kMs));
  EXPECT_TRUE(throttle.passes(230 * kMs));
  EXPECT_FALSE(throttle.passes(329 * kMs));  // counted from the last message, not from a grid
  EXPECT_TRUE(throttle.passes(330 * kMs));
}

TEST(MessageThrottle, StartsAgainWhenTimeJumpsBack) {
  MessageThrottle throttle(100 * kMs, 5000 * kMs);
  EXPECT_FALSE(throttle.is_back_in_time(5000 * kMs));
  EXPECT_TRUE(throttle.is_back_in_time(10 * kMs));
  throttle.restart(10 * kMs);
  EXPECT_FALSE(throttle.passes(10 * kMs));
  EXPECT_TRUE(throttle.passes(110 * kMs));
}

TEST(ByteThrottle, PassesMessagesUntilTheWindowHasItsBytes) {
  ByteThrottle throttle(100, 1.0);
  EXPECT_TRUE(throttle.passes(0.0, 60));
  EXPECT_TRUE(throttle.passes(0.1, 60));  // 60 are fewer than 100
  EXPECT_FALSE(throttle.passes(0.2, 1));
  EXPECT_FALSE(throttle.passes(1.0, 1));  // the first one is as old as the window
  EXPECT_TRUE(throttle.passes(1.05, 40));
  EXPECT_FALSE(throttle.passes(1.06, 1));  // 60 + 40
}

TEST(DropRule, DropsTheFirstOfEverySoMany) {
  DropRule rule(2, 5);
  std::string passed;
  for (int i = 0; i < 10; ++i) passed += rule.passes() ? '1' : '0';
  EXPECT_EQ(passed, "0011100111");
}

TopicSelection selection(const std::string& initial = "") {
  return {{"a", "b"}, initial, [](const std::string& topic) {
            return topic.front() == '/' ? topic : "/" + topic;
          }};
}

TEST(TopicSelection, BeginsWithTheFirstTopicOrTheInitialOne) {
  EXPECT_EQ(selection().selected(), "a");
  EXPECT_EQ(selection("b").selected(), "b");
  EXPECT_FALSE(selection("__none").has_selected());
}

TEST(TopicSelection, SelectsByFullNames) {
  TopicSelection topics = selection();
  EXPECT_FALSE(topics.select("c"));
  EXPECT_EQ(topics.selected(), "a");
  EXPECT_TRUE(topics.select("/b"));
  EXPECT_EQ(topics.selected_of_topics(), "/b");
  EXPECT_TRUE(topics.select("__none"));
  EXPECT_EQ(topics.selected_of_topics(), "");
}

TEST(TopicSelection, AddsAndDeletes) {
  TopicSelection topics = selection();
  EXPECT_EQ(topics.add("__none"), TopicSelection::Added::kReserved);
  EXPECT_EQ(topics.add("a"), TopicSelection::Added::kKnown);
  EXPECT_EQ(topics.add("c"), TopicSelection::Added::kYes);
  EXPECT_EQ(topics.erase("/a"), TopicSelection::Deleted::kSelected);
  EXPECT_EQ(topics.erase("d"), TopicSelection::Deleted::kUnknown);
  EXPECT_EQ(topics.erase("/b"), TopicSelection::Deleted::kYes);
  EXPECT_EQ(topics.topics(), (std::vector<std::string>{"a", "c"}));
}

}  // namespace
}  // namespace topic_tools
