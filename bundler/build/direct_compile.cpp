// See direct_compile.hpp.
#include "bundler/build/direct_compile.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "bundler/build/link_line.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Raise it when the driver is asked otherwise.
constexpr std::string_view kFormat = "1";

constexpr std::array<std::string_view, 6> kSourceEndings = {".cpp", ".cc", ".cxx",
                                                            ".c++", ".C",  ".c"};
/// The driver hands these on, with the word that follows.
constexpr std::array<std::string_view, 11> kPairs = {"-MT",      "-MF",        "-MQ",         "-I",
                                                     "-isystem", "-iquote",    "-D",          "-U",
                                                     "-include", "-idirafter", "-include-pch"};
/// And these, however they go on.
constexpr std::array<std::string_view, 6> kBeginnings = {
    "-I", "-D", "-U", "-ffile-prefix-map=", "-fmacro-prefix-map=", "-fdiagnostics-color"};
constexpr std::array<std::string_view, 3> kWords = {"-c", "-MD", "-MMD"};
/// Options with which the command does more than compile, or does not compile.
constexpr std::array<std::string_view, 7> kForeign = {"-E", "-S", "-M", "-MM", "-x", "-v", "-###"};

template <std::size_t N>
bool is_one_of(std::string_view text, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool is_warning(std::string_view argument) {
  return argument.starts_with("-W") && argument.substr(0, argument.find(',')) == argument;
}

/// One word a line.
std::string as_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + "\n";
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) result.push_back(line);
  return result;
}

/// Asks the driver with an empty source; empty when it hands arguments on changed. Nothing when it
/// could not be asked.
std::optional<std::vector<std::string>> asked(const std::string& driver, const CompileWords& words,
                                              const fs::path& folder,
                                              const std::map<std::string, std::string>& environment,
                                              const Cancellation& cancellation) {
  const auto place = TemporaryDirectory::make(folder, "ask-");
  if (!place) return std::nullopt;
  const std::string source =
      (place->path() / "empty").string() + fs::path(words.source).extension().string();
  const std::string output = (place->path() / "empty.o").string();
  if (!write_file(source, "")) return std::nullopt;
  std::vector<std::string> command = {driver, "-v"};
  command.insert(command.end(), words.manner.begin(), words.manner.end());
  command.insert(command.end(), {"-c", source, "-o", output});
  const auto said = run_process({.arguments = command, .environment = environment}, cancellation);
  if (!said || said->exit_code != 0) return std::nullopt;
  return parse_compiler_call(said->output, words.manner, source, output)
      .value_or(std::vector<std::string>());
}

}  // namespace

std::optional<CompileWords> compile_words(const std::vector<std::string>& command) {
  CompileWords words;
  bool compiles = false;
  for (std::size_t i = 1; i < command.size(); ++i) {
    const std::string& argument = command[i];
    const bool has_next = i + 1 < command.size();
    if (argument.empty() || argument.starts_with('@') || is_one_of(argument, kForeign) ||
        argument.find('\n') != std::string::npos)
      return std::nullopt;
    if (argument == "-o" && has_next) {
      if (!words.output.empty()) return std::nullopt;
      words.output = command[++i];
    } else if (is_one_of(argument, kPairs) && has_next) {
      ++i;
    } else if (!argument.starts_with('-')) {
      if (!words.source.empty()) return std::nullopt;
      words.source = argument;
    } else if (is_one_of(argument, kWords)) {
      compiles = compiles || argument == "-c";
    } else if (!is_warning(argument) &&
               std::none_of(kBeginnings.begin(), kBeginnings.end(),
                            [&](auto beginning) { return argument.starts_with(beginning); })) {
      words.manner.push_back(argument);
    }
  }
  if (!compiles || words.output.empty() ||
      !is_one_of(fs::path(words.source).extension().string(), kSourceEndings))
    return std::nullopt;
  return words;
}

std::optional<std::vector<std::string>> parse_compiler_call(std::string_view printed,
                                                            const std::vector<std::string>& manner,
                                                            std::string_view source,
                                                            std::string_view output) {
  std::vector<std::string> rest = {"-v"};
  rest.insert(rest.end(), manner.begin(), manner.end());
  rest.insert(rest.end(), {"-c", std::string(source), "-o", std::string(output)});
  std::istringstream lines{std::string(printed)};
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> words = split_response_file(line);
    if (words.size() <= rest.size() ||
        !fs::path(words.front()).filename().string().starts_with("clang"))
      continue;
    const auto own = words.end() - static_cast<std::ptrdiff_t>(rest.size());
    if (!std::equal(own, words.end(), rest.begin())) continue;
    words.erase(own, words.end());
    return words;
  }
  return std::nullopt;
}

std::vector<std::string> direct_compile_command(
    const std::vector<std::string>& command, const fs::path& kept,
    const std::map<std::string, std::string>& environment, const Cancellation& cancellation) {
  const auto words = kept.empty() ? std::nullopt : compile_words(command);
  if (!words) return command;
  std::vector<std::string> question = {std::string(kFormat), command.front(),
                                       fs::path(words->source).extension().string()};
  question.insert(question.end(), words->manner.begin(), words->manner.end());
  const fs::path answer = kept / (sha256_hex(as_text(question)).substr(0, 16) + ".compile");
  std::vector<std::string> call;
  if (const auto known = read_file(answer, kMostOfData)) {
    call = lines_of(*known);
  } else {
    if (!make_directories(kept)) return command;
    auto said = asked(command.front(), *words, kept, environment, cancellation);
    if (!said) return command;
    (void)write_file(answer, as_text(*said));  // not kept is only slower
    call = std::move(*said);
  }
  if (call.empty()) return command;
  call.insert(call.end(), command.begin() + 1, command.end());
  return call;
}

}  // namespace ros2wasm
