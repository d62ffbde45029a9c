// The states of a bond, and parts of nav2_util below ROS.
#include <gtest/gtest.h>

#include "bondcpp/detail/bond_state.hpp"
#include "nav2_util/array_parser.hpp"
#include "nav2_util/line_iterator.hpp"
#include "nav2_util/string_utils.hpp"

namespace bond {
namespace detail {
namespace {

constexpr BondState kStates[] = {BondState::kWaitingForSister, BondState::kAlive,
                                 BondState::kAwaitSisterDeath, BondState::kDead};
constexpr BondEvent kEvents[] = {BondEvent::kSisterAlive,       BondEvent::kSisterDead,
                                 BondEvent::kConnectTimeout,    BondEvent::kHeartbeatTimeout,
                                 BondEvent::kDisconnectTimeout, BondEvent::kDie};

TEST(BondState, TheFirstStatusFormsTheBondAndLaterOnesAreHeartbeats) {
  const BondStep first = next_step(BondState::kWaitingForSister, BondEvent::kSisterAlive);
  EXPECT_EQ(first.state, BondState::kAlive);
  EXPECT_TRUE(first.forms);
  EXPECT_FALSE(first.hears_beat);
  const BondStep second = next_step(BondState::kAlive, BondEvent::kSisterAlive);
  EXPECT_EQ(second.state, BondState::kAlive);
  EXPECT_FALSE(second.forms);
  EXPECT_TRUE(second.hears_beat);
}

TEST(BondState, SilenceOrTheSistersEndBreaksIt) {
  const BondStep silent = next_step(BondState::kAlive, BondEvent::kHeartbeatTimeout);
  EXPECT_EQ(silent.state, BondState::kDead);
  EXPECT_TRUE(silent.breaks);
  EXPECT_FALSE(silent.sister_left);
  const BondStep left = next_step(BondState::kAlive, BondEvent::kSisterDead);
  EXPECT_EQ(left.state, BondState::kDead);
  EXPECT_TRUE(left.breaks);
  EXPECT_TRUE(left.sister_left);
  const BondStep alone = next_step(BondState::kWaitingForSister, BondEvent::kConnectTimeout);
  EXPECT_EQ(alone.state, BondState::kDead);
  EXPECT_TRUE(alone.breaks);
}

TEST(BondState, ItsOwnEndWaitsForAnAnswer) {
  const BondStep dying = next_step(BondState::kAlive, BondEvent::kDie);
  EXPECT_EQ(dying.state, BondState::kAwaitSisterDeath);
  EXPECT_TRUE(dying.starts_dying);
  EXPECT_FALSE(dying.breaks);
  for (const BondEvent end : {BondEvent::kSisterDead, BondEvent::kDisconnectTimeout}) {
    EXPECT_EQ(next_step(BondState::kAwaitSisterDeath, end).state, BondState::kDead);
    EXPECT_TRUE(next_step(BondState::kAwaitSisterDeath, end).breaks);
  }
  EXPECT_EQ(next_step(BondState::kAwaitSisterDeath, BondEvent::kSisterAlive).state,
            BondState::kAwaitSisterDeath);
}

TEST(BondState, IsFormedOnceAndBrokenOnce) {
  for (const BondState state : kStates) {
    for (const BondEvent event : kEvents) {
      const BondStep step = next_step(state, event);
      EXPECT_EQ(step.breaks, step.state == BondState::kDead && state != BondState::kDead);
      EXPECT_EQ(step.forms,
                state == BondState::kWaitingForSister &&
                    (event == BondEvent::kSisterAlive || event == BondEvent::kSisterDead));
    }
  }
}

}  // namespace
}  // namespace detail
}  // namespace bond

namespace nav2_util {
namespace {

using Lists = std::vector<std::vector<float>>;

TEST(ArrayParser, ReadsListsOfLists) {
  std::string error = "before";
  EXPECT_EQ(parseVVF("[[1, 2.5],[ -3e1 ], []]", error), (Lists{{1, 2.5}, {-30}, {}}));
  EXPECT_EQ(error, "");
}

TEST(ArrayParser, SaysWhatIsWrong) {
  std::string error;
  parseVVF("[[[1]]]", error);
  EXPECT_EQ(error, "Array depth greater than 2");
  parseVVF("[[1]]]", error);
  EXPECT_EQ(error, "More close ] than open [");
  parseVVF("[1, 2]", error);
  EXPECT_EQ(error, "Numbers at depth other than 2. Char was '1'.");
  parseVVF("[[1, 2]", error);
  EXPECT_EQ(error, "Unterminated vector string.");
  parseVVF("[[one]]", error);
  EXPECT_EQ(error, "Unterminated vector string.");
}

TEST(StringUtils, SplitsAndStrips) {
  EXPECT_EQ(split("a::b", ':'), (Tokens{"a", "", "b"}));
  EXPECT_EQ(split("", ':'), (Tokens{""}));
  EXPECT_EQ(strip_leading_slash("/map"), "map");
  EXPECT_EQ(strip_leading_slash("map"), "map");
}

TEST(LineIterator, VisitsEachColumnOfAFlatLine) {
  std::string visited;
  for (LineIterator line(0, 0, 4, -2); line.isValid(); line.advance()) {
    visited += "(" + std::to_string(line.getX()) + "," + std::to_string(line.getY()) + ")";
  }
  EXPECT_EQ(visited, "(0,0)(1,-1)(2,-1)(3,-2)(4,-2)");
}

}  // namespace
}  // namespace nav2_util
