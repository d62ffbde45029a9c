// The command line: what is read, what is refused, and with which words.
#include "cli/arguments.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "cli/command_table.hpp"

namespace ros2wasm {
namespace {

struct Seen {
  std::string input;
  std::optional<std::string> out;
  int port = 8000;
  bool force = false;
  std::string mode = "a";
  std::vector<std::string> defines;
  std::vector<std::string> updates;
  std::vector<std::string> rest;
};
std::shared_ptr<Seen> last_seen;  // of the command that was declared last; only in this test

CommandBody demo_command(Arguments& arguments) {
  const auto seen = std::make_shared<Seen>();
  last_seen = seen;
  arguments.optional("INPUT", seen->input, "input");
  arguments.value("-o,--output", seen->out, "FOLDER", "output");
  arguments.number("--port", seen->port, "PORT", 1, 65535, "port");
  arguments.flag("--force", seen->force, "force");
  arguments.choice("--mode", seen->mode, {"a", "b"}, "mode");
  arguments.values("-D,--define", seen->defines, "NAME", "define");
  arguments.values_if_any("--update", seen->updates, "NAME", "update");
  return [seen](Context&) { return 7; };
}

CommandBody rest_command(Arguments& arguments) {
  const auto seen = std::make_shared<Seen>();
  last_seen = seen;
  arguments.rest("WORDS", seen->rest, "words");
  return [seen](Context&) { return 0; };
}

CommandBody raw_command(Arguments& arguments) {
  const auto seen = std::make_shared<Seen>();
  last_seen = seen;
  arguments.choice("--mode", seen->mode, {"a", "b"}, "mode");
  arguments.required("INPUT", seen->input, "input");
  arguments.raw_rest(seen->rest);
  return [seen](Context&) { return 0; };
}

constexpr auto kDemo =
    std::to_array<CommandRow>({{.name = "demo", .help = "Demo", .declare = demo_command}});
constexpr auto kRest =
    std::to_array<CommandRow>({{.name = "rest", .help = "Rest", .declare = rest_command}});

constexpr auto kRaw =
    std::to_array<CommandRow>({{.name = "raw", .help = "Raw", .declare = raw_command},
                               {.name = "run", .help = "Run", .declare = rest_command}});

ParsedCommandLine parse(const std::vector<std::string>& words) {
  return parse_command_line(words, kDemo);
}

Diagnostic error_of(const std::vector<std::string>& words) {
  const auto parsed = parse(words);
  if (parsed.invocation.ok()) {
    ADD_FAILURE() << "accepted";
    return {};
  }
  EXPECT_EQ(parsed.invocation.errors()[0].kind, FailureKind::kCommandLine);
  return parsed.invocation.errors()[0];
}

TEST(Arguments, LeavesTheWordsOfAnotherProgramAsTheyAre) {
  const std::vector<std::string> words = {"run", "--mode", "--json", "-1", "--help", "--", "x y"};
  std::vector<std::string> line = {"raw", "--mode", "b", "site"};
  line.insert(line.end(), words.begin(), words.end());
  // The command that is declared last is another one.
  const auto parsed = parse_command_line(line, std::span(kRaw).first(1));
  ASSERT_TRUE(parsed.invocation.ok()) << parsed.invocation.errors()[0].message;
  EXPECT_EQ(parsed.invocation->command, "raw");
  EXPECT_EQ(last_seen->input, "site");
  EXPECT_EQ(last_seen->mode, "b");
  EXPECT_EQ(last_seen->rest, words);
  EXPECT_EQ(parse_command_line(line, kRaw).invocation->command, "raw");
}

TEST(Arguments, ReadsAllKinds) {
  const auto parsed = parse({"demo", "x.yaml", "-o", "site", "--port", "80", "--force", "--mode=b",
                             "-D", "A", "-D", "B"});
  ASSERT_TRUE(parsed.invocation.ok()) << parsed.invocation.errors()[0].message;
  EXPECT_EQ(parsed.invocation->command, "demo");
  EXPECT_TRUE(parsed.invocation->body);
  EXPECT_EQ(last_seen->input, "x.yaml");
  EXPECT_EQ(last_seen->out, "site");
  EXPECT_EQ(last_seen->port, 80);
  EXPECT_TRUE(last_seen->force);
  EXPECT_EQ(last_seen->mode, "b");
  EXPECT_EQ(last_seen->defines, (std::vector<std::string>{"A", "B"}));
}

TEST(Arguments, ValuesOfListsTakeOneWordEach) {
  const auto parsed = parse({"demo", "-D", "A", "x.yaml"});
  ASSERT_TRUE(parsed.invocation.ok()) << parsed.invocation.errors()[0].message;
  EXPECT_EQ(last_seen->defines, std::vector<std::string>{"A"});
  EXPECT_EQ(last_seen->input, "x.yaml");
}

TEST(Arguments, AListsOptionMayStandAlone) {
  ASSERT_TRUE(parse({"demo", "--update", "a", "x.yaml", "--update"}).invocation.ok());
  EXPECT_EQ(last_seen->updates, (std::vector<std::string>{"a", ""}));
  EXPECT_EQ(last_seen->input, "x.yaml");
  ASSERT_TRUE(parse({"demo", "--update"}).invocation.ok());
  EXPECT_EQ(last_seen->updates, std::vector<std::string>{""});
}

TEST(Arguments, DefaultsStay) {
  ASSERT_TRUE(parse({"demo"}).invocation.ok());
  EXPECT_EQ(last_seen->port, 8000);
  EXPECT_EQ(last_seen->out, std::nullopt);
}

TEST(Arguments, GlobalOptionsStandAnywhere) {
  const auto before = parse({"--json", "--color", "never", "demo"});
  ASSERT_TRUE(before.invocation.ok());
  EXPECT_TRUE(before.global.json);
  EXPECT_EQ(before.global.color, ColorMode::kNever);
  const auto behind = parse({"demo", "-q", "--color", "always"});
  ASSERT_TRUE(behind.invocation.ok());
  EXPECT_TRUE(behind.global.quiet);
  EXPECT_EQ(behind.global.color, ColorMode::kAlways);
}

TEST(Arguments, JsonIsKnownEvenWhenTheRestIsWrong) {
  EXPECT_TRUE(parse({"dmo", "--json"}).global.json);
}

TEST(Arguments, HelpAndVersionAreTexts) {
  for (const auto& words :
       {std::vector<std::string>{"--help"}, {"demo", "--help"}, {"--version"}}) {
    const auto parsed = parse(words);
    ASSERT_TRUE(parsed.invocation.ok());
    EXPECT_FALSE(parsed.invocation->body);
    EXPECT_FALSE(parsed.invocation->text.empty());
  }
  EXPECT_NE(parse({"demo", "--help"}).invocation->text.find("--port PORT"), std::string::npos);
}

TEST(Arguments, UnknownCommand) {
  const Diagnostic error = error_of({"dmeo"});
  EXPECT_EQ(error.code, "R2W0901");
  EXPECT_EQ(error.fix, std::vector<std::string>{"ros2wasm demo"});
  EXPECT_EQ(error_of({}).code, "R2W0901");
}

TEST(Arguments, UnknownOption) {
  const Diagnostic error = error_of({"demo", "--outptu", "x"});
  EXPECT_EQ(error.code, "R2W0902");
  EXPECT_EQ(error.fix, std::vector<std::string>{"write `--output`"});
  EXPECT_EQ(error_of({"demo", "--jsn"}).fix, std::vector<std::string>{"write `--json`"});
}

TEST(Arguments, BadValues) {
  EXPECT_NE(error_of({"demo", "--port", "0"}).message.find("--port"), std::string::npos);
  EXPECT_EQ(error_of({"demo", "--port", "x"}).code, "R2W0902");
  EXPECT_EQ(error_of({"demo", "--mode", "c"}).code, "R2W0902");
  EXPECT_EQ(error_of({"demo", "-o"}).code, "R2W0902");
  EXPECT_EQ(error_of({"demo", "--color", "pink"}).code, "R2W0902");
  EXPECT_NE(error_of({"demo", "a", "b"}).message.find("`b`"), std::string::npos);
}

TEST(Arguments, WordsBehindTwoDashesAreTakenAsTheyAre) {
  const auto parsed = parse_command_line({"rest", "--", "-o", "x", "--json", "--", "-q"}, kRest);
  ASSERT_TRUE(parsed.invocation.ok()) << parsed.invocation.errors()[0].message;
  EXPECT_FALSE(parsed.global.json);
  EXPECT_FALSE(parsed.global.quiet);
  EXPECT_EQ(last_seen->rest, (std::vector<std::string>{"-o", "x", "--json", "--", "-q"}));
}

TEST(Arguments, EveryRealCommandCanBeDeclared) {
  for (const CommandRow& row : command_table()) {
    const auto parsed = parse_command_line({std::string(row.name), "--help"}, command_table());
    ASSERT_TRUE(parsed.invocation.ok()) << row.name;
    EXPECT_NE(parsed.invocation->text.find(row.help), std::string::npos) << row.name;
  }
}

}  // namespace
}  // namespace ros2wasm
