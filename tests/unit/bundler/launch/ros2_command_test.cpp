// Command lines of launch files: which a site runs, and what a shell makes of a line.
#include "bundler/launch/ros2_command.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

using Words = std::vector<std::string>;

TEST(Ros2Command, RunsWhatTheSiteKnows) {
  EXPECT_TRUE(runs_in_site({"ros2", "topic", "pub", "/x", "std_msgs/msg/String"}));
  EXPECT_TRUE(runs_in_site({"/opt/ros/jazzy/bin/ros2", "service", "call"}));
  EXPECT_FALSE(runs_in_site({"xros2", "topic", "list"}));
  EXPECT_FALSE(runs_in_site({"ros2", "topic"}));
  EXPECT_FALSE(runs_in_site({"ros2", "doctor", "--report"}));
  EXPECT_FALSE(runs_in_site({"ros2", "run", "demo", "talker"}));
  EXPECT_FALSE(runs_in_site({"ros2", "launch", "demo", "all.launch.py"}));
  EXPECT_FALSE(runs_in_site({"ros2 topic list"}));
}

TEST(Ros2Command, SplitsAsAShellDoes) {
  EXPECT_EQ(
      shell_words(R"(ros2 topic  pub /x T "{a: 'b c', d: \"e\", f: \n}" g\ h '' i'j'"k")"),
      (Words{"ros2", "topic", "pub", "/x", "T", R"({a: 'b c', d: "e", f: \n})", "g h", "", "ijk"}));
  EXPECT_EQ(shell_words("a '$HOME;|' # the rest | is a remark"), (Words{"a", "$HOME;|"}));
  EXPECT_EQ(shell_words("a#b {1..3} [0-9]* x~"), (Words{"a#b", "{1..3}", "[0-9]*", "x~"}));
  EXPECT_EQ(shell_words(" \t"), Words());
}

TEST(Ros2Command, LeavesMoreThanWordsToAShell) {
  for (const char* line : {"a | b", "a > b", "a < b", "a & b", "a && b", "a; b", "a $B", "a \"$B\"",
                           "a `b`", "a \"`b`\"", "(a)", "a\nb", "a ~/b", "a 'b", "a \"b"})
    EXPECT_FALSE(shell_words(line)) << line;
}

TEST(Ros2Command, ShowsALineThatIsSplitAgain) {
  const Words words{"ros2", "service", "call", "/s", "{a: 'b'}", "", "c;d", "~", "e#f"};
  EXPECT_EQ(shown_command(words), R"(ros2 service call /s '{a: '\''b'\''}' '' 'c;d' '~' 'e#f')");
  EXPECT_EQ(shell_words(shown_command(words)), words);
}

}  // namespace
}  // namespace ros2wasm
