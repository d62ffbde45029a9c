// See direct_link.hpp.
#include "bundler/build/direct_link.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "bundler/archive/wasm_module.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Raise it when the driver is asked otherwise.
constexpr std::string_view kFormat = "5";

constexpr std::string_view kLinkerOption = "-Wl,";

/// The optimizer's level and, in its place, passes. Ours and users' objects are optimized one by
/// one when they are compiled, so what is left for the linked program is what only a whole one
/// shows: functions that are equal, zeros of the memory, what nobody uses; and locals, of which
/// clang leaves too many. All of -O2 takes six times as long for 3 % less.
constexpr std::string_view kLevel = "-O2";
constexpr std::array<std::string_view, 9> kPasses = {
    "--optimize-level=2", "--shrink-level=1",  "--duplicate-function-elimination",
    "--memory-packing",   "--simplify-locals", "--vacuum",
    "--coalesce-locals",  "--reorder-locals",  "--remove-unused-module-elements"};

/// Options for the driver only: they say how to compile, optimize or debug, which the calls have
/// already.
constexpr std::array<std::string_view, 7> kIgnoredPrefixes = {"-O", "-g",   "-f",       "-m",
                                                              "-W", "-std", "-pedantic"};

void add_parts(std::vector<std::string>& arguments, std::string_view list) {
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    arguments.emplace_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
}

std::string as_text(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Changes with all that the driver is told, and with what is compiled into a program.
std::string key_of(const DirectLink& link) {
  const LinkLine nothing{.compiler = link.line.compiler,
                         .output = {},
                         .arguments = {},
                         .thread_support = link.line.thread_support};
  std::string key = std::string(kFormat) + "\n" + as_text(link_command(nothing, link.kind, {}));
  if (link.kind == LinkKind::kThreads) {
    if (const auto source = read_file(link.line.thread_support, kMostOfData)) key += *source;
  }
  return sha256_hex(key).substr(0, 16);
}

/// The object that the loader's needs come from, compiled once where it has a source.
std::optional<std::string> marker_of(const DirectLink& link, const Cancellation& cancellation) {
  if (link.kind == LinkKind::kSingle) return link.stem + kSingleLinkObjectSuffix;
  const fs::path object = link.kept / (key_of(link) + ".o");
  std::error_code error;
  if (fs::exists(object, error)) return object.string();
  const std::string fresh = link.stem + ".thread_support.o";
  const auto compiled =
      run_process({.arguments = {link.line.compiler, "-O2", "-pthread", "-fwasm-exceptions", "-c",
                                 link.line.thread_support, "-o", fresh},
                   .environment = link.environment},
                  cancellation);
  if (!compiled || compiled->exit_code != 0) return std::nullopt;
  fs::rename(fresh, object, error);  // of two that do this at once, either will do
  return error ? std::nullopt : std::optional(object.string());
}

/// Blocks of lines, with an empty line after each.
std::string as_text(const ToolCalls& calls) {
  return as_text(calls.linker) + "\n" + as_text(calls.after) + "\n" + as_text(calls.optimizer) +
         "\n";
}

std::optional<ToolCalls> calls_from(const std::string& text) {
  ToolCalls calls;
  const std::array<std::vector<std::string>*, 3> blocks = {&calls.linker, &calls.after,
                                                           &calls.optimizer};
  std::size_t block = 0;
  std::istringstream lines(text);
  for (std::string line; block < blocks.size() && std::getline(lines, line);) {
    if (line.empty()) {
      ++block;
    } else {
      blocks.at(block)->push_back(line);
    }
  }
  if (block < blocks.size()) return std::nullopt;
  return calls;
}

/// The calls that the driver prints for a program of the marker alone. Cached as text.
std::optional<ToolCalls> tool_calls(const DirectLink& link, const std::string& marker,
                                    const Cancellation& cancellation) {
  const fs::path kept = link.kept / key_of(link);
  if (const auto known = read_file(kept, kMostOfData)) {
    if (auto calls = calls_from(*known)) return calls;
  }
  LinkLine probe{.compiler = link.line.compiler,
                 .output = {},
                 // The loader calls these; the driver itself looks whether a program's objects do.
                 .arguments = {"-v", "-Wl,--export-if-defined=malloc,--export-if-defined=free"},
                 .thread_support = marker};
  const auto said = run_process(
      {.arguments = link_command(probe, link.kind, link.stem), .environment = link.environment},
      cancellation);
  if (!said || said->exit_code != 0) return std::nullopt;
  auto found = parse_tool_calls(said->output, marker, link.stem + ".wasm");
  if (!found) return std::nullopt;
  // Not kept is only slower.
  (void)write_file(kept, as_text(*found));
  return found;
}

/// The call that a line shows, without the files: the tool, then its arguments. `rest` gets what
/// follows the marker.
std::vector<std::string> call_of(const std::vector<std::string>& words, std::string_view marker,
                                 std::string_view output, std::vector<std::string>* rest) {
  std::vector<std::string> result;
  std::vector<std::string>* part = &result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "-o" && i + 1 < words.size() && words[i + 1] == output) {
      ++i;
    } else if (rest != nullptr && words[i] == marker) {
      part = rest;
    } else if (words[i] != output) {
      part->push_back(words[i]);
    }
  }
  return result;
}

bool says_features(const std::string& argument) {
  return argument == "--mvp-features" || argument.starts_with("--enable-");
}

void put_passes(std::vector<std::string>& optimizer) {
  const auto level = std::find(optimizer.begin(), optimizer.end(), kLevel);
  if (level == optimizer.end()) return;
  const auto next = optimizer.erase(level);
  optimizer.insert(next, kPasses.begin(), kPasses.end());
}

/// Runs the linker, or the optimizer after it. Its output when it succeeded, else nothing.
std::optional<std::string> printed_by(std::vector<std::string> command, const DirectLink& link,
                                      const Cancellation& cancellation) {
  // A name without a folder is looked for where the driver looks: other programs may have it too.
  const auto path = link.environment.find("PATH");
  if (path != link.environment.end()) {
    const auto tool = find_program(command.front(), path->second);
    if (!tool) return std::nullopt;
    command.front() = tool->string();
  }
  auto done =
      run_process({.arguments = std::move(command), .environment = link.environment}, cancellation);
  if (!done || done->exit_code != 0) return std::nullopt;
  return std::move(done->output);
}

}  // namespace

std::optional<ToolCalls> parse_tool_calls(std::string_view printed, std::string_view marker,
                                          std::string_view output) {
  ToolCalls calls;
  std::size_t linkers = 0;
  std::size_t optimizers = 0;
  std::istringstream lines{std::string(printed)};
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> words = split_response_file(line);
    if (words.empty()) continue;
    const std::string tool = fs::path(words.front()).filename().string();
    if (tool.starts_with("wasm-ld") && std::count(words.begin(), words.end(), marker) == 1) {
      ++linkers;
      calls.linker = call_of(words, marker, output, &calls.after);
    } else if (tool == "wasm-opt") {
      ++optimizers;
      calls.optimizer = call_of(words, marker, output, nullptr);
      std::erase_if(calls.optimizer, says_features);
      put_passes(calls.optimizer);
      // A program has no need to say what it uses.
      calls.optimizer.emplace_back("--strip-target-features");
    }
  }
  if (linkers != 1 || optimizers != 1) return std::nullopt;
  return calls;
}

std::optional<std::vector<std::string>> linker_arguments(
    const std::vector<std::string>& driver_arguments) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < driver_arguments.size(); ++i) {
    const std::string& argument = driver_arguments[i];
    const bool source = argument.ends_with(".c") || argument.ends_with(".cpp") ||
                        argument.ends_with(".cc") || argument.ends_with(".cxx");
    if (argument == "-Xlinker" && i + 1 < driver_arguments.size()) {
      result.push_back(driver_arguments[++i]);
    } else if (argument.starts_with(kLinkerOption)) {
      add_parts(result, std::string_view(argument).substr(kLinkerOption.size()));
    } else if (!argument.starts_with('-') && !source) {
      result.push_back(argument);
    } else if (argument.starts_with("-L") || argument.starts_with("-l")) {
      result.push_back(argument);
    } else if (std::none_of(kIgnoredPrefixes.begin(), kIgnoredPrefixes.end(),
                            [&](auto prefix) { return argument.starts_with(prefix); })) {
      return std::nullopt;
    }
  }
  return result;
}

fs::path tool_calls_folder(const fs::path& build_cache, const Compiler& compiler) {
  return build_cache / "tool-calls" / sha256_hex(compiler.identity).substr(0, 16);
}

std::optional<std::string> link_directly(const DirectLink& link, const Cancellation& cancellation) {
  const auto own = linker_arguments(link.line.arguments);
  if (!own) return std::nullopt;
  if (!make_directories(link.kept)) return std::nullopt;
  const auto marker = marker_of(link, cancellation);
  const auto calls = marker ? tool_calls(link, *marker, cancellation) : std::nullopt;
  if (!calls) return std::nullopt;
  const std::string program = link.stem + ".wasm";
  std::vector<std::string> command = calls->linker;
  command.insert(command.end(), {"-o", program, *marker});
  command.insert(command.end(), own->begin(), own->end());
  command.insert(command.end(), calls->after.begin(), calls->after.end());
  return printed_by(std::move(command), link, cancellation);
}

bool optimize_directly(const DirectLink& link, const Cancellation& cancellation) {
  const auto marker = marker_of(link, cancellation);
  const auto calls = marker ? tool_calls(link, *marker, cancellation) : std::nullopt;
  if (!calls) return false;
  const std::string program = link.stem + ".wasm";
  const auto bytes = read_file(program, kMostOfData);
  const auto stripped = bytes ? without_debug_data(*bytes) : std::nullopt;
  if (!stripped || !write_file(program, *stripped)) return false;
  std::vector<std::string> command = calls->optimizer;
  command.insert(command.end(), {program, "-o", program});
  return printed_by(std::move(command), link, cancellation).has_value();
}

}  // namespace ros2wasm
