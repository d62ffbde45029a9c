// Tests of the output on stdout and stderr, and of the exit code for a set of errors.
#include "cli/console.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace ros2wasm {
namespace {

Diagnostic of_kind(FailureKind kind, Severity severity = Severity::kError) {
  return Diagnostic{.code = "R2W0101", .severity = severity, .kind = kind, .message = "m"};
}

struct Streams {
  std::ostringstream out;
  std::ostringstream err;
  Console console;

  explicit Streams(ConsoleOptions options)
      : console(options, out, err, [] { return std::int64_t{0}; }) {}
};

TEST(Console, ResultsGoToStdoutAndTheRestToStderr) {
  Streams streams({});
  streams.console.result("result");
  streams.console.result_text("as it is");
  streams.console.remark("remark");
  streams.console.report(of_kind(FailureKind::kUserInput, Severity::kWarning));
  EXPECT_EQ(streams.out.str(), "result\nas it is");
  EXPECT_EQ(streams.err.str(), "remark\nwarning[R2W0101]: m\n\n");
}

TEST(Console, QuietKeepsErrors) {
  Streams streams({.quiet = true});
  streams.console.remark("remark");
  streams.console.progress({.step = "fetch", .done = 1, .total = 1});
  EXPECT_EQ(streams.console.fail(of_kind(FailureKind::kUserInput)), 1);
  EXPECT_EQ(streams.err.str(), "error[R2W0101]: m\n\n");
}

TEST(Console, JsonIsOneObjectALine) {
  Streams streams({.json = true});
  streams.console.remark("a\nb");
  streams.console.progress({.step = "fetch", .item = "x", .done = 1, .total = 2, .unit = "bytes"});
  EXPECT_EQ(streams.console.fail(of_kind(FailureKind::kEnvironment)), 3);
  streams.console.end(3);
  std::istringstream lines(streams.err.str());
  std::vector<std::string> events;
  for (std::string line; std::getline(lines, line);)
    events.push_back(line.substr(0, line.find(',')));
  EXPECT_EQ(events, (std::vector<std::string>{R"({"event":"remark")", R"({"event":"progress")",
                                              R"({"event":"diagnostic")", R"({"event":"end")"}));
  EXPECT_EQ(streams.out.str(), "");
}

TEST(Console, CountsErrors) {
  Streams streams({});
  EXPECT_EQ(streams.console.fail(Diagnostics{of_kind(FailureKind::kUserInput),
                                             of_kind(FailureKind::kUserInput),
                                             of_kind(FailureKind::kUserInput, Severity::kWarning)}),
            1);
  EXPECT_TRUE(streams.err.str().ends_with("2 errors; `ros2wasm explain R2W0101` says more\n"));
}

TEST(Console, TheBarIsWipedBeforeOtherLines) {
  Streams streams({.live_progress = true, .terminal_width = 80});
  streams.console.progress({.step = "fetch", .done = 1, .total = 2});
  streams.console.remark("remark");
  EXPECT_EQ(streams.err.str().find("\r\x1b[2Kremark\n"),
            streams.err.str().size() - std::string("\r\x1b[2Kremark\n").size());
}

TEST(ExitCode, WhatWins) {
  EXPECT_EQ(exit_code_of({of_kind(FailureKind::kUserInput), of_kind(FailureKind::kBug)}), 70);
  EXPECT_EQ(exit_code_of({of_kind(FailureKind::kBug), of_kind(FailureKind::kInterrupted)}), 130);
  EXPECT_EQ(exit_code_of({of_kind(FailureKind::kUserInput, Severity::kWarning),
                          of_kind(FailureKind::kEnvironment)}),
            3);
  EXPECT_EQ(exit_code_of({of_kind(FailureKind::kCommandLine)}), 2);
  EXPECT_EQ(exit_code_of({}), 1);
}

}  // namespace
}  // namespace ros2wasm
