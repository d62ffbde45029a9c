// The rules of twist_mux: priorities from 0 to 255, timeouts and locks.
#include <gtest/gtest.h>

#include "mux_rules.hpp"

namespace twist_mux {
namespace {

constexpr double kNow = 1000.0;
constexpr std::size_t kNavigation = 0;
constexpr std::size_t kJoystick = 1;
constexpr std::size_t kPause = 0;

MuxRules usual(std::vector<Input> locks = {}) {
  return {{{"topics.navigation", "nav_vel", 0.5, 10}, {"topics.joystick", "joy_vel", 0.5, 100}},
          std::move(locks)};
}

TEST(TwistMux, TheHigherPriorityWinsUntilItsMessageIsTooOld) {
  MuxRules rules = usual();
  EXPECT_TRUE(rules.receive(kNavigation, kNow));
  EXPECT_TRUE(rules.receive(kJoystick, kNow + 0.1));
  EXPECT_FALSE(rules.receive(kNavigation, kNow + 0.2));
  EXPECT_FALSE(rules.receive(kNavigation, kNow + 0.6));  // as old as the timeout
  EXPECT_TRUE(rules.receive(kNavigation, kNow + 0.7));
}

TEST(TwistMux, WithoutATimeoutATopicNeverExpires) {
  MuxRules rules({{"topics.a", "a", 0.0, 20}, {"topics.b", "b", 0.5, 10}}, {});
  EXPECT_FALSE(rules.receive(1, kNow));  // not even before its first message
  EXPECT_TRUE(rules.receive(0, kNow));
}

TEST(TwistMux, TheFirstOfEqualPrioritiesWins) {
  MuxRules rules({{"topics.a", "a", 0.5, 10}, {"topics.b", "b", 0.5, 10}}, {});
  EXPECT_TRUE(rules.receive(1, kNow));
  EXPECT_TRUE(rules.receive(0, kNow));
  EXPECT_FALSE(rules.receive(1, kNow));
}

TEST(TwistMux, PrioritiesAreClampedAndZeroNeverWins) {
  MuxRules rules({{"topics.low", "low", 0.5, -7}, {"topics.high", "high", 0.5, 1000}}, {});
  EXPECT_EQ(rules.topics()[0].priority, 0);
  EXPECT_EQ(rules.topics()[1].priority, 255);
  EXPECT_FALSE(rules.receive(0, kNow));
  EXPECT_TRUE(rules.receive(1, kNow));
}

TEST(TwistMux, ALockStopsTopicsBelowItsPriority) {
  MuxRules rules = usual({{"locks.pause", "pause", 0.0, 100}});
  EXPECT_EQ(rules.lock_priority(kNow), 0);
  rules.receive_lock(kPause, true, kNow);
  EXPECT_EQ(rules.lock_priority(kNow), 100);
  EXPECT_FALSE(rules.receive(kNavigation, kNow));
  EXPECT_TRUE(rules.receive(kJoystick, kNow));
  rules.receive_lock(kPause, false, kNow + 1);
  EXPECT_TRUE(rules.receive(kNavigation, kNow + 1));
}

TEST(TwistMux, ALockWithATimeoutHoldsWhileNobodyPublishesIt) {
  MuxRules rules = usual({{"locks.alive", "alive", 1.0, 255}});
  EXPECT_FALSE(rules.receive(kJoystick, kNow));
  rules.receive_lock(kPause, false, kNow);
  EXPECT_TRUE(rules.receive(kJoystick, kNow + 1.0));
  EXPECT_FALSE(rules.receive(kJoystick, kNow + 1.1));
}

TEST(TwistMux, TheHighestOfSeveralLocksCounts) {
  MuxRules rules = usual({{"locks.a", "a", 0.0, 50}, {"locks.b", "b", 0.0, 20}});
  rules.receive_lock(0, true, kNow);
  rules.receive_lock(1, true, kNow);
  EXPECT_EQ(rules.lock_priority(kNow), 50);
}

}  // namespace
}  // namespace twist_mux
