// See compile_errors.hpp.
#include "bundler/build/compile_errors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <regex>
#include <sstream>

#include "bundler/build/browser_limits.hpp"
#include "bundler/build/long_width.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

struct CompilerMessage {
  SourceSpan span;
  std::string text;
};

/// From line `from` on, the next "file:line:column: error: text" with the source line that clang
/// prints below it. `from` becomes the line behind.
std::optional<CompilerMessage> next_error(const std::vector<std::string>& lines,
                                          const BuildPlace& place, std::size_t& from) {
  static const std::regex kError(R"(^(.+?):(\d+):(\d+): (?:fatal )?error: (.*)$)");
  while (from < lines.size()) {
    const std::size_t i = from++;
    std::smatch match;
    if (lines[i].size() > 4000 || !std::regex_match(lines[i], match, kError)) continue;
    CompilerMessage result{.span = {.file = display_file(match[1], place),
                                    .line = printed_number(match[2].str()),
                                    .column = printed_number(match[3].str()),
                                    .length = 1},
                           .text = match[4]};
    if (i + 2 < lines.size() && lines[i + 2].find('^') != std::string::npos) {
      result.span.line_text = lines[i + 1];
    }
    return result;
  }
  return std::nullopt;
}

/// A feature that this compiler's C++ library lacks. `sign` in a message shows that it is the
/// reason.
struct MissingFeature {
  std::string_view sign;
  std::string_view name;
};
constexpr auto kMissingFeatures = std::to_array<MissingFeature>({
    {"'format' file not found", "<format>"},
    {"'expected' file not found", "<expected>"},
    {"'source_location' file not found", "<source_location>"},
    {"'memory_resource' file not found", "<memory_resource>"},
    {"'coroutine' file not found", "<coroutine>"},
    {"'stop_token' file not found", "<stop_token>"},
    {"'syncstream' file not found", "<syncstream>"},
    {"'execution' file not found", "<execution>"},
    {"named 'format' in namespace 'std'", "std::format"},
    {"named 'jthread' in namespace 'std'", "std::jthread"},
    {"named 'bit_cast' in namespace 'std'", "std::bit_cast"},
    {"named 'source_location' in namespace 'std'", "std::source_location"},
    {"no member named 'sort' in namespace 'std::ranges'", "std::ranges::sort"},
    {"no member named 'ranges' in namespace 'std'", "std::ranges"},
});

void explain_missing_features(Diagnostic& diagnostic, const BuildPlace& place) {
  for (const MissingFeature& feature : kMissingFeatures) {
    if (diagnostic.detail.find(feature.sign) == std::string::npos) continue;
    diagnostic.why.push_back("the C++ library of Emscripten " + place.compiler_version +
                             " has no " + std::string(feature.name) +
                             "; a newer Emscripten on PATH or in EMSDK may have it");
  }
}

/// A text that a tool prints when it has no memory, or when it was killed for that reason.
struct LackOfMemory {
  std::string_view sign;
  std::string_view reason;
};
constexpr std::string_view kNoMemory = "a tool of the compiler had not enough memory";
constexpr std::string_view kKilled =
    "a tool of the compiler was killed (SIGKILL), as systems do when memory runs out";
constexpr auto kLacksOfMemory = std::to_array<LackOfMemory>({
    {"LLVM ERROR: out of memory", kNoMemory},
    {"terminate called after throwing an instance of 'std::bad_alloc'", kNoMemory},
    {"annot allocate memory", kNoMemory},
    {"failed to map segment from shared object", kNoMemory},
    {"virtual memory exhausted", kNoMemory},
    {"\nMemoryError", kNoMemory},
    {"failed (received SIGKILL", kKilled},
    {"unable to execute command: Killed", kKilled},
    {"ended by signal 9 ", kKilled},
});

/// Adds reasons to the message for a missing header that no site can have.
void explain_limits(Diagnostic& diagnostic) {
  static const std::regex kHeader(R"('([^'\t\n]+)' file not found)");
  std::smatch match;
  if (!std::regex_search(diagnostic.message, match, kHeader)) return;
  for (std::string& line : told_of_header(match[1].str()))
    diagnostic.why.push_back(std::move(line));
}

/// A header of a package that is there, which the target does not name.
void explain_unnamed_package(Diagnostic& diagnostic, const FailedCommand& failed,
                             const BuildPlace& place) {
  static const std::regex kHeader(R"('([A-Za-z0-9_]+)/[^'\t\n]+' file not found)");
  static const std::regex kTarget(R"((?:^|/)CMakeFiles/([^/]+)\.dir/)");
  std::smatch header;
  std::smatch target;
  if (!std::regex_search(diagnostic.message, header, kHeader)) return;
  if (!std::regex_search(failed.output_file, target, kTarget)) return;
  const std::string package = header[1];
  const auto& known = place.channel_packages;
  if (package == place.package || !std::binary_search(known.begin(), known.end(), package)) return;
  diagnostic.why.push_back("package `" + package + "` has its headers, and the target `" +
                           target[1].str() + "` does not name it");
  diagnostic.fix.push_back("in CMakeLists.txt: `find_package(" + package +
                           " REQUIRED)` and `ament_target_dependencies(" + target[1].str() + " " +
                           package + ")`; in package.xml: `<depend>" + package + "</depend>`");
}

Diagnostic compile_error(const FailedCommand& failed, const BuildPlace& place) {
  const auto lines = output_lines(failed.text);
  std::size_t from = 0;
  const auto error = next_error(lines, place, from);
  if (std::string reason = lack_of_memory(failed.text); !error && !reason.empty()) {
    return out_of_memory("package `" + place.package + "` does not compile: " + failed.output_file,
                         std::move(reason));
  }
  Diagnostic result{.code = "R2W0502",
                    .message = "package `" + place.package + "` does not compile",
                    .detail = without_wrapper_lines(failed.text)};
  if (error) {
    result.message += ": " + error->text;
    result.span = error->span;
  } else {
    result.message += ": " + failed.output_file;
  }
  explain_missing_features(result, place);
  explain_limits(result);
  explain_long_width(result);
  explain_unnamed_package(result, failed, place);
  return result;
}

/// The place that a line of CMake's output names.
SourceSpan cmake_place(const std::string& named, const std::string& line, const BuildPlace& place) {
  const fs::path file = fs::path(named).is_absolute() ? fs::path(named) : place.source / named;
  return {.file = display_file(file.string(), place), .line = printed_number(line)};
}

bool is_of_package(const std::string& named, const BuildPlace& place) {
  const fs::path file(named);
  return file.is_relative() || !file.lexically_relative(place.source).native().starts_with("..");
}

/// The first error of CMake's output: its first paragraph and its place. An error within somebody
/// else's module has the place where the package called the module.
std::optional<CompilerMessage> first_cmake_error(const std::vector<std::string>& lines,
                                                 const BuildPlace& place) {
  static const std::regex kError(R"(^CMake Error at (.+?):(\d+).*$)");
  static const std::regex kCall(R"(^  (\S.*?):(\d+) \(.*\)$)");
  const auto matches = [](const std::string& line, std::smatch& match, const std::regex& regex) {
    return line.size() <= 4000 && std::regex_match(line, match, regex);
  };
  std::smatch match;
  auto line = std::find_if(lines.begin(), lines.end(),
                           [&](const std::string& one) { return matches(one, match, kError); });
  if (line == lines.end()) return std::nullopt;
  CompilerMessage result{.span = cmake_place(match[1], match[2], place), .text = {}};
  bool is_found = is_of_package(match[1], place);
  for (++line; line != lines.end() && line->empty();) ++line;
  for (; line != lines.end() && line->starts_with("  "); ++line)
    result.text += (result.text.empty() ? "" : " ") + line->substr(line->find_first_not_of(' '));
  if (result.text.ends_with(':'))  // the next paragraph has the subject
    for (; line != lines.end() && (line->empty() || line->starts_with("  ")); ++line) {
      if (line->empty()) continue;
      result.text += " " + line->substr(line->find_first_not_of(' '));
      break;
    }
  for (; line != lines.end() && !line->starts_with("CMake Error") && !is_found; ++line) {
    if (!matches(*line, match, kCall) || !is_of_package(match[1], place)) continue;
    result.span = cmake_place(match[1], match[2], place);
    is_found = true;
  }
  return result;
}

}  // namespace

std::uint32_t printed_number(std::string_view digits) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() && end == digits.data() + digits.size() ? number : 0;
}

std::vector<std::string> output_lines(std::string_view text) {
  std::vector<std::string> result;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    result.push_back(std::move(line));
  }
  return result;
}

bool is_ninja_line(const std::string& line) {
  return line.starts_with("ninja: ") || line.starts_with("FAILED: ") ||
         (line.starts_with('[') && line.find('/') != std::string::npos &&
          line.find("] ") != std::string::npos &&
          line.find_first_not_of("[0123456789/") == line.find(']'));
}

std::string display_file(const std::string& file, const BuildPlace& place) {
  const fs::path path(file);
  const std::string relative = path.lexically_relative(place.source).generic_string();
  if (path.is_relative() || relative.empty() || relative.starts_with("..")) return file;
  return place.display.empty() ? relative : place.display + "/" + relative;
}

bool is_link(const FailedCommand& failed) {
  return failed.command.find(" link-program ") != std::string::npos;
}

std::string without_wrapper_lines(std::string_view text) {
  std::string result;
  for (const std::string& line : output_lines(text)) {
    const bool wrapper =
        (line.starts_with("em++: error: '") || line.starts_with("emcc: error: '")) &&
        line.find("' failed (") != std::string::npos;
    if (!wrapper) result += line + "\n";
  }
  return result;
}

Diagnostics compiler_messages(std::string_view text, const BuildPlace& place) {
  const auto lines = output_lines(text);
  Diagnostics result;
  std::size_t from = 0;
  while (auto error = next_error(lines, place, from))
    result.push_back(
        {.code = "R2W0502", .message = std::move(error->text), .span = std::move(error->span)});
  return result;
}

std::string lack_of_memory(std::string_view text) {
  const auto* const seen =
      std::find_if(kLacksOfMemory.begin(), kLacksOfMemory.end(),
                   [&](const LackOfMemory& one) { return text.find(one.sign) != text.npos; });
  return std::string(seen == kLacksOfMemory.end() ? std::string_view() : seen->reason);
}

Diagnostic out_of_memory(std::string what, std::string reason) {
  return Diagnostic{
      .code = "R2W0521",
      .kind = FailureKind::kEnvironment,
      .message = "out of memory: " + std::move(what),
      .why = {std::move(reason)},
      .fix = {"compile fewer files at once: `-j 1`", "give this machine more memory"}};
}

std::vector<FailedCommand> failed_commands(std::string_view ninja_output) {
  const auto lines = output_lines(ninja_output);
  std::vector<FailedCommand> result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].starts_with("FAILED: ")) continue;
    FailedCommand failed{.output_file = lines[i].substr(8), .command = {}, .text = {}};
    while (failed.output_file.ends_with(' ')) failed.output_file.pop_back();
    if (i + 1 < lines.size()) failed.command = lines[++i];
    while (i + 1 < lines.size() && !is_ninja_line(lines[i + 1])) failed.text += lines[++i] + "\n";
    result.push_back(std::move(failed));
  }
  return result;
}

Diagnostics compile_errors(std::string_view ninja_output, const BuildPlace& place) {
  Diagnostics result;
  for (const FailedCommand& failed : failed_commands(ninja_output)) {
    if (is_link(failed)) continue;  // it speaks for itself
    if (failed.output_file.ends_with(".o")) {
      result.push_back(compile_error(failed, place));
    } else {
      const std::string made = failed.output_file.substr(0, failed.output_file.find(' '));
      std::string what =
          "package `" + place.package + "`: the command that makes `" + made + "` failed";
      if (std::string reason = lack_of_memory(failed.text); !reason.empty()) {
        result.push_back(out_of_memory(std::move(what), std::move(reason)));
        continue;
      }
      result.push_back(Diagnostic{.code = "R2W0506",
                                  .message = std::move(what),
                                  .why = {"the command was: " + failed.command},
                                  .detail = failed.text});
    }
  }
  return result;
}

Diagnostics configure_errors(std::string_view cmake_output, const BuildPlace& place) {
  static const std::regex kNotFound(R"rx(package configuration file provided by\s+"([^"]+)")rx");
  Diagnostic result{.code = "R2W0503",
                    .message = "CMakeLists.txt of package `" + place.package + "` failed",
                    .detail = std::string(cmake_output)};
  if (auto first = first_cmake_error(output_lines(cmake_output), place)) {
    if (!first->text.empty()) result.message += ": " + first->text;
    result.span = std::move(first->span);
  }
  std::smatch match;
  const std::string text(cmake_output.substr(0, 200'000));
  if (std::regex_search(text, match, kNotFound)) {
    const std::string wanted = match[1];
    result.code = "R2W0507";
    result.message =
        "package `" + place.package + "` asks CMake for `" + wanted + "`, which is not there";
    result.why.push_back("it is not among what the channels and the workspace brought");
    const auto& known = place.channel_packages;
    if (std::binary_search(known.begin(), known.end(), wanted)) {
      result.fix.push_back("add `<depend>" + wanted + "</depend>` to package.xml");
    } else if (const auto similar = nearest(wanted, known)) {
      result.why.push_back("the channels have `" + *similar + "`");
    }
  }
  return {result};
}

}  // namespace ros2wasm
