// Diagnostics as text, byte for byte, and as JSON.
#include "cli/diagnostic_text.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

Diagnostic example() {
  return Diagnostic{
      .code = "R2W0402",
      .message = "package `demo_nodes_cpp` has no executable `talkr`",
      .span = SourceSpan{.file = "workspace.yaml",
                         .line = 12,
                         .column = 17,
                         .length = 5,
                         .line_text = "    executable: talkr"},
      .label = "no such executable in demo_nodes_cpp 0.20.5",
      .why = {"its executables are: listener, talker, add_two_ints_server (and 4 more)"},
      .fix = {"write `executable: talker`"}};
}

std::string text(const Diagnostic& diagnostic, std::size_t width = 100) {
  return diagnostic_text(diagnostic, {.color = false, .width = width});
}

/// The drawn source line and its carets.
std::string excerpt(SourceSpan span, std::size_t width = 100) {
  span.file = "f";
  span.line = 1;
  const std::string all = text(Diagnostic{.code = "R2W0101", .message = "m", .span = span}, width);
  const std::size_t begin = all.find("\n1 |") + 1;
  return all.substr(begin);
}

TEST(DiagnosticText, TheFormOfTheDesign) {
  EXPECT_EQ(text(example()),
            "error[R2W0402]: package `demo_nodes_cpp` has no executable `talkr`\n"
            "  --> workspace.yaml:12:17\n"
            "12 |     executable: talkr\n"
            "   |                 ^^^^^ no such executable in demo_nodes_cpp 0.20.5\n"
            "   = why: its executables are: listener, talker, add_two_ints_server (and 4 more)\n"
            "   = fix: write `executable: talker`\n");
}

TEST(DiagnosticText, WithoutAPlace) {
  EXPECT_EQ(
      text(Diagnostic{.code = "R2W0901", .message = "no command was given", .why = {"a", "b"}}),
      "error[R2W0901]: no command was given\n   = why: a\n   = why: b\n");
}

TEST(DiagnosticText, AFileWithoutALine) {
  EXPECT_EQ(
      text(Diagnostic{.code = "R2W0210", .message = "m", .span = SourceSpan{.file = "a.txt"}}),
      "error[R2W0210]: m\n  --> a.txt\n");
  EXPECT_EQ(text(Diagnostic{.code = "R2W0210",
                            .message = "m",
                            .span = SourceSpan{.file = "a.txt", .line = 3},
                            .label = "x"}),
            "error[R2W0210]: m\n --> a.txt:3\n  = here: x\n");
}

TEST(DiagnosticText, SeveralLinesInFixAndDetail) {
  EXPECT_EQ(text(Diagnostic{.code = "R2W0501",
                            .severity = Severity::kWarning,
                            .message = "m",
                            .fix = {"a:\n  - b"},
                            .detail = "one\n\n  two\n"}),
            "warning[R2W0501]: m\n"
            "   = fix: a:\n"
            "            - b\n"
            "    one\n"
            "\n"
            "      two\n");
}

TEST(DiagnosticText, CaretsUnderTabsAndWideCharacters) {
  EXPECT_EQ(excerpt({.column = 2, .length = 1, .line_text = "\tx"}), "1 |     x\n  |     ^\n");
  EXPECT_EQ(excerpt({.column = 4, .length = 1, .line_text = "ab\tx"}), "1 | ab  x\n  |     ^\n");
  EXPECT_EQ(excerpt({.column = 4, .length = 3, .line_text = "\xE5\xB1\xB1\xE7\x94\xB0"}),
            "1 | \xE5\xB1\xB1\xE7\x94\xB0\n  |   ^^\n");
  EXPECT_EQ(excerpt({.column = 4, .length = 1, .line_text = "e\xCC\x81x"}),
            "1 | e\xCC\x81x\n  |  ^\n");
}

TEST(DiagnosticText, CaretBehindTheLine) {
  EXPECT_EQ(excerpt({.column = 3, .length = 1, .line_text = "a:"}), "1 | a:\n  |   ^\n");
  EXPECT_EQ(excerpt({.column = 99, .length = 9, .line_text = "a:"}), "1 | a:\n  |   ^\n");
}

TEST(DiagnosticText, LongLinesAreCutAroundTheCaret) {
  const std::string line = std::string(200, 'a') + "X" + std::string(200, 'b');
  const std::string middle = excerpt({.column = 201, .length = 1, .line_text = line}, 60);
  for (std::size_t begin = 0; begin < middle.size();) {
    const std::size_t end = middle.find('\n', begin);
    // An ellipsis is one column and three bytes.
    EXPECT_LE(end - begin, 60U + 4U) << middle;
    begin = end + 1;
  }
  EXPECT_NE(middle.find("aX"), std::string::npos);
  const std::string start = excerpt({.column = 1, .length = 3, .line_text = line}, 60);
  EXPECT_TRUE(start.starts_with("1 | aaa")) << start;
  const std::string end = excerpt({.column = 401, .length = 1, .line_text = line}, 60);
  EXPECT_NE(end.find("b\xE2\x80\xA6"), 0U) << end;
  EXPECT_TRUE(end.find("bbb\n") != std::string::npos) << end;
}

TEST(DiagnosticText, FilesDoNotSteerTheTerminal) {
  EXPECT_EQ(text(Diagnostic{.code = "R2W0101", .message = "a\x1b[31mb\nc\xE2\x80\xAE"}),
            "error[R2W0101]: a<1B>[31mb<0A>c<202E>\n");
  EXPECT_EQ(excerpt({.column = 1, .length = 1, .line_text = "\x1b[2J"}),
            "1 | \xEF\xBF\xBD[2J\n  | ^\n");
  const std::string detail =
      text(Diagnostic{.code = "R2W0501", .message = "m", .detail = "\x1b[31mred"});
  EXPECT_EQ(detail, "error[R2W0501]: m\n    <1B>[31mred\n");
}

TEST(DiagnosticText, ColourAddsOnlyColour) {
  const std::string colored = diagnostic_text(example(), {.color = true, .width = 100});
  EXPECT_NE(colored, text(example()));
  std::string bare;
  for (std::size_t i = 0; i < colored.size(); ++i) {
    if (colored[i] == '\x1b') {
      i = colored.find('m', i);
    } else {
      bare += colored[i];
    }
  }
  EXPECT_EQ(bare, text(example()));
}

TEST(DiagnosticJson, HasAllMembers) {
  EXPECT_EQ(
      diagnostic_json(example()),
      R"({"event":"diagnostic","code":"R2W0402","severity":"error","kind":"user_input",)"
      R"("message":"package `demo_nodes_cpp` has no executable `talkr`",)"
      R"("span":{"file":"workspace.yaml","line":12,"column":17,"length":5,"line_text":"    executable: talkr"},)"
      R"("label":"no such executable in demo_nodes_cpp 0.20.5",)"
      R"~("why":["its executables are: listener, talker, add_two_ints_server (and 4 more)"],)~"
      R"("fix":["write `executable: talker`"],"detail":""})");
  EXPECT_NE(
      diagnostic_json(Diagnostic{.code = "R2W0901", .message = "\xFF"}).find(R"("span":null)"),
      std::string::npos);
}

}  // namespace
}  // namespace ros2wasm
