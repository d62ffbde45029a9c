// Which regular expressions checks take: those that std::regex and JavaScript read alike, and that
// end soon.
#include "workspace_schema/schema/check_pattern.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace ros2wasm {
namespace {

TEST(CheckPattern, TakesTheCommonForm) {
  for (const char* text :
       {"I heard", "I heard: 'Hello, world! \\d+'", "^a.c$", "[a-z_]+\\.txt", "[^0-9]", "a|b|",
        "(?:ab|cd)+", "\\bword\\b", "x{2}y{1,3}z{2,}?", "a*?b+?c??", "[\\w\\-.]+",
        "\\(\\)\\[\\]\\{\\}\\/\\|", "(\\d{3})+", "(?:a|b)*c", "[]]", "\xC3\xA9t\xC3\xA9",
        "[\xC3\xA9\xC3\xA0]", "(a)(b)", "goal .* reached .* in .* s"}) {
    const auto fault = check_pattern_fault(text);
    if (std::string_view(text) == "[]]") {
      EXPECT_TRUE(fault) << "an empty class in JavaScript, `]` in POSIX";
      continue;
    }
    EXPECT_FALSE(fault) << text << ": " << (fault ? fault->why : "");
    EXPECT_NO_THROW(std::regex(text, std::regex::ECMAScript)) << text;
  }
}

TEST(CheckPattern, RefusesWhatIsNoExpression) {
  for (const char* text :
       {"",      "*a",     "a**",   "a{2}{3}", "(a", "a)", "[a", "a\\", "{",    "a}", "]",
        "a{,2}", "a{2,1}", "[z-a]", "[\\d-z]", "[]", "+",  "(?", "^*",  "\\b+", "a|*"})
    EXPECT_TRUE(check_pattern_fault(text)) << text;
}

TEST(CheckPattern, RefusesWhatOneOfTheTwoReadsOtherwise) {
  for (const char* text : {"(?=a)", "(?!a)", "(?<=a)b", "(?<name>a)", "(a)\\1", "\\p{L}", "\\u0041",
                           "\\x41", "\\cA", "\\a", "\\-", "[[:alpha:]]", "(?i)a", "\\0"})
    EXPECT_TRUE(check_pattern_fault(text)) << text;
}

TEST(CheckPattern, RefusesWhatCanTakeForEver) {
  for (const char* text :
       {"(a+)+", "(a*)*b", "(?:a?){50}", "(\\w+\\s?)*", "(a|a)*", "(a|ab)+", "(\\d|[0-9])*x",
        "(?:a|)*", "((a){1,2})+", "a{101}", ".*.*.*.*.*.*", "([^x]|y)*", "(?:\\S|\\W)*"})
    EXPECT_TRUE(check_pattern_fault(text)) << text;
  EXPECT_TRUE(check_pattern_fault(std::string(257, 'a')));
  EXPECT_TRUE(check_pattern_fault(std::string(17, '(') + "a" + std::string(17, ')')));
}

std::string times(std::size_t count, std::string_view text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

// Guarantee, hostile input: an expression of a check that could be tried in exponentially many ways
// is refused
TEST(CheckPattern, BoundsTheWhole) {
  for (const std::string& text :
       {times(30, "a?") + times(30, "a"), times(20, "(a|a)"), times(10, "(a{0,99})") + "b",
        times(9, "(?:x|(a|ab)?)c?"),
        std::string("(((((a{1,50})?b){0,1}){1,1}c){0,1}[a-c]{1,100}){0,1}d{0,99}e{1,9}")}) {
    const auto fault = check_pattern_fault(text);
    ASSERT_TRUE(fault) << text;
  }
  const auto fault = check_pattern_fault(times(30, "a?") + times(30, "a"));
  EXPECT_EQ(fault->why,
            "it can be tried in more than 100000 ways: too much of it varies in length");
  EXPECT_EQ(fault->offset, 0U);
  EXPECT_EQ(fault->length, 90U);
  for (const std::string& text :
       {std::string("^\\d{1,3}\\.\\d{1,3}\\.\\d{1,3}\\.\\d{1,3}$"), times(40, "(a|b)"),
        times(60, "a{2}"), std::string("x=-?\\d+\\.\\d+ y=-?\\d+\\.\\d+ z=-?\\d+"), times(16, "a?"),
        times(16, "(ab|ac)")})
    EXPECT_FALSE(check_pattern_fault(text)) << text;
}

TEST(CheckPattern, NamesThePlace) {
  const auto fault = check_pattern_fault("ab(c+)*d");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->offset, 2U);
  EXPECT_EQ(fault->length, 5U);
  EXPECT_EQ(fault->why, "what repeats with different counts cannot be repeated again");
  EXPECT_EQ(check_pattern_fault("ab\\1")->offset, 2U);
}

}  // namespace
}  // namespace ros2wasm
