// See quick_link.hpp.
#include "bundler/build/quick_link.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "bundler/io/files.hpp"
#include "bundler/io/process.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Raise it when the driver is asked otherwise.
constexpr std::string_view kFormat = "1";

constexpr std::string_view kLinkerOption = "-Wl,";

/// Of the driver only: they say how to compile, optimize or debug, which a quick link does not.
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
std::string key_of(const QuickLink& link) {
  const LinkLine nothing{.compiler = link.line.compiler,
                         .output = {},
                         .arguments = {},
                         .thread_support = link.line.thread_support};
  std::string key = as_text(link_command(nothing, link.kind, {}));
  if (link.kind == LinkKind::kThreads) {
    if (const auto source = read_file(link.line.thread_support)) key += *source;
  }
  return sha256_hex(key).substr(0, 16);
}

/// The object that the loader's needs come from, compiled once where it has a source.
std::optional<std::string> marker_of(const QuickLink& link, const Cancellation& cancellation) {
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

/// What the driver says for a program of the marker alone. Kept as it was printed.
std::optional<LinkerCall> linker_call(const QuickLink& link, const std::string& marker,
                                      const Cancellation& cancellation) {
  const fs::path kept = link.kept / key_of(link);
  const auto known = read_file(kept);
  std::istringstream lines(known ? *known : std::string());
  LinkerCall call;
  std::vector<std::string>* part = &call.before;
  for (std::string line; std::getline(lines, line);) {
    if (call.linker.empty()) {
      call.linker = line;
    } else if (line.empty()) {
      part = &call.after;
    } else {
      part->push_back(line);
    }
  }
  if (!call.linker.empty()) return call;

  LinkLine probe{.compiler = link.line.compiler,
                 .output = {},
                 // The loader calls these; the driver itself looks whether a program's objects do.
                 .arguments = {"-v", "-Wl,--export-if-defined=malloc,--export-if-defined=free"},
                 .thread_support = marker};
  const auto said = run_process(
      {.arguments = link_command(probe, link.kind, link.stem), .environment = link.environment},
      cancellation);
  if (!said || said->exit_code != 0) return std::nullopt;
  auto found = parse_linker_call(said->output, marker, link.stem + ".wasm");
  if (!found) return std::nullopt;
  // Not kept is only slower.
  (void)write_file(kept,
                   found->linker + "\n" + as_text(found->before) + "\n" + as_text(found->after));
  return found;
}

}  // namespace

std::optional<LinkerCall> parse_linker_call(std::string_view printed, std::string_view marker,
                                            std::string_view output) {
  std::istringstream lines{std::string(printed)};
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> words = split_response_file(line);
    if (words.empty() || words.front().find("wasm-ld") == std::string::npos) continue;
    LinkerCall call{.linker = words.front(), .before = {}, .after = {}};
    std::vector<std::string>* part = &call.before;
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i] == "-o" && i + 1 < words.size() && words[i + 1] == output) {
        ++i;
      } else if (words[i] == marker) {
        part = &call.after;
      } else {
        part->push_back(words[i]);
      }
    }
    if (part == &call.after) return call;
  }
  return std::nullopt;
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

fs::path quick_links_folder(const fs::path& build_cache, const Compiler& compiler) {
  const std::string key = std::string(kFormat) + "\n" + compiler.identity;
  return build_cache / "quick-links" / sha256_hex(key).substr(0, 16);
}

std::optional<std::string> link_quickly(const QuickLink& link, const Cancellation& cancellation) {
  const auto own = linker_arguments(link.line.arguments);
  if (!own) return std::nullopt;
  if (!make_directories(link.kept)) return std::nullopt;
  const auto marker = marker_of(link, cancellation);
  const auto call = marker ? linker_call(link, *marker, cancellation) : std::nullopt;
  if (!call) return std::nullopt;
  std::vector<std::string> command = {call->linker, "-o", link.stem + ".wasm"};
  command.insert(command.end(), call->before.begin(), call->before.end());
  command.push_back(*marker);
  command.insert(command.end(), own->begin(), own->end());
  command.insert(command.end(), call->after.begin(), call->after.end());
  auto linked = run_process({.arguments = command, .environment = link.environment}, cancellation);
  if (!linked || linked->exit_code != 0) return std::nullopt;
  return std::move(linked->output);
}

}  // namespace ros2wasm
