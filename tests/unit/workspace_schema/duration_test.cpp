// `--for`: what is a duration and what is not.
#include "workspace_schema/base/duration.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {
using std::chrono::milliseconds;

TEST(ParseDuration, ReadsNumbersWithUnits) {
  EXPECT_EQ(parse_duration("500ms").value(), milliseconds(500));
  EXPECT_EQ(parse_duration("5s").value(), milliseconds(5000));
  EXPECT_EQ(parse_duration("1.5s").value(), milliseconds(1500));
  EXPECT_EQ(parse_duration("2m").value(), milliseconds(120'000));
  EXPECT_EQ(parse_duration("0.5h").value(), milliseconds(1'800'000));
  EXPECT_EQ(parse_duration("168h").value(), milliseconds(604'800'000));
}

TEST(ParseDuration, RefusesTheRest) {
  for (const char* text :
       {"",     "5",      "s",   "-5s",  "+5s",  "5 s",   " 5s",
        "5s ",  "5sec",   "5S",  "1e3s", "0s",   "0.4ms", "inf",
        "nan",  "1.2.3s", ".5s", "5.s",  "0x5s", "169h",  "999999999999999999999999h",
        "5s5s", "1m30s"}) {
    const auto duration = parse_duration(text);
    ASSERT_FALSE(duration.ok()) << text;
    EXPECT_EQ(duration.errors().front().code.text(), "R2W0621");
    EXPECT_EQ(duration.errors().front().kind, FailureKind::kCommandLine);
    EXPECT_FALSE(duration.errors().front().why.empty());
  }
}

TEST(ParseDuration, OffersTheUnitThatIsMissing) {
  EXPECT_EQ(parse_duration("30").errors().front().fix, std::vector<std::string>{"write `30s`"});
}

}  // namespace
}  // namespace ros2wasm
