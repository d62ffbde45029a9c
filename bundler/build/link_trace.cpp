// See link_trace.hpp.
#include "bundler/build/link_trace.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "bundler/build/browser_limits.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kReference = ": reference to ";
constexpr std::string_view kDefinition = ": definition of ";
constexpr std::string_view kLazyDefinition = ": lazy definition of ";
constexpr std::string_view kSystemLibraries = "/wasm32-emscripten/";

/// The symbols of one limit that a program uses -> the objects that use them, which may be unknown.
using Uses = std::map<std::string, std::set<std::string>>;

std::set<std::string> own_objects(const TracedProgram& program, const std::string& symbol) {
  std::set<std::string> result;
  const auto found = program.trace.references.find(symbol);
  if (found == program.trace.references.end()) return result;
  for (const std::string& path : found->second)
    if (!is_given_object(path, program.channel_prefix)) result.insert(path);
  return result;
}

/// A program's own function of such a name has nothing to do with it.
bool defines_itself(const TracedProgram& program, const std::string& symbol) {
  const auto found = program.trace.definitions.find(symbol);
  return found != program.trace.definitions.end() &&
         std::any_of(found->second.begin(), found->second.end(), [&](const std::string& path) {
           return !is_given_object(path, program.channel_prefix);
         });
}

Diagnostic finding(const TracedProgram& program, const BrowserLimit& limit, const Uses& uses,
                   bool is_undefined) {
  const bool only_warns = limit.only_fails && !is_undefined;
  Diagnostic result{.code = only_warns ? DiagnosticCode("R2W0524") : DiagnosticCode("R2W0523"),
                    .severity = only_warns ? Severity::kWarning : Severity::kError,
                    .message = program.shown + (only_warns ? " asks for " : " needs ") +
                               std::string(limit.what) + ", which no browser has",
                    .label = std::string(limit.what)};
  std::map<std::string, std::vector<std::string>> by_object;
  for (const auto& [symbol, objects] : uses) {
    if (objects.empty()) by_object["something in it"].push_back("`" + symbol + "`");
    for (const std::string& object : objects)
      by_object[shown_object(object)].push_back("`" + symbol + "`");
  }
  for (const auto& [object, symbols] : by_object)
    result.why.push_back(object + " refers to " + name_list(symbols));
  result.why.push_back("instead: " + std::string(limit.instead));
  if (!only_warns)
    result.why.emplace_back("code between `#ifndef __EMSCRIPTEN__` and `#endif` is skipped");
  return result;
}

}  // namespace

std::vector<std::string> trace_options(const std::vector<std::string>& symbols) {
  std::vector<std::string> result;
  result.reserve(symbols.size());
  for (const std::string& symbol : symbols) result.push_back("-Wl,--trace-symbol=" + symbol);
  return result;
}

LinkTrace read_link_trace(std::string_view printed) {
  LinkTrace result;
  std::istringstream lines{std::string(printed)};
  for (std::string line; std::getline(lines, line);) {
    if (const auto at = line.find(kReference); at != std::string::npos) {
      result.references[line.substr(at + kReference.size())].insert(line.substr(0, at));
    } else if (const auto made = line.find(kDefinition); made != std::string::npos) {
      result.definitions[line.substr(made + kDefinition.size())].insert(line.substr(0, made));
    }
  }
  return result;
}

std::string without_trace(std::string_view printed) {
  std::string result;
  std::istringstream lines{std::string(printed)};
  for (std::string line; std::getline(lines, line);)
    if (line.find(kReference) == line.npos && line.find(kDefinition) == line.npos &&
        line.find(kLazyDefinition) == line.npos)
      result += line + "\n";
  return result;
}

std::string shown_object(const std::string& path) {
  constexpr std::string_view kOfTarget = ".dir/";
  std::string object = path;
  std::string archive;
  if (const auto open = path.rfind('('); open != std::string::npos && path.ends_with(')')) {
    archive = fs::path(path.substr(0, open)).filename().string();
    object = path.substr(open + 1, path.size() - open - 2);
  }
  const auto below = object.find(kOfTarget);
  object = below == std::string::npos ? fs::path(object).filename().string()
                                      : object.substr(below + kOfTarget.size());
  if (object.ends_with(".o")) object.resize(object.size() - 2);
  return archive.empty() ? object : object + " of " + archive;
}

bool is_given_object(const std::string& path, const std::string& channel_prefix) {
  return path.find(kSystemLibraries) != std::string::npos ||
         (!channel_prefix.empty() && path.starts_with(channel_prefix + "/"));
}

Diagnostics limit_findings(const TracedProgram& program) {
  std::map<const BrowserLimit*, Uses> used;
  std::map<const BrowserLimit*, Uses> undefined;
  for (const std::string& symbol : program.undefined)
    if (const BrowserLimit* limit = limit_of_symbol(symbol))
      undefined[limit][symbol] = own_objects(program, symbol);
  for (const auto& [symbol, unused] : program.trace.references) {
    const BrowserLimit* limit = limit_of_symbol(symbol);
    std::set<std::string> objects = own_objects(program, symbol);
    if (limit == nullptr || objects.empty() || defines_itself(program, symbol)) continue;
    used[limit][symbol] = std::move(objects);
  }
  // Sorted by what they say: addresses of rows tell nothing.
  Diagnostics result;
  for (const auto& [limit, uses] : undefined) {
    Uses all = uses;
    if (const auto more = used.find(limit); more != used.end()) {
      all.insert(more->second.begin(), more->second.end());
      used.erase(more);
    }
    result.push_back(finding(program, *limit, all, true));
  }
  for (const auto& [limit, uses] : used) result.push_back(finding(program, *limit, uses, false));
  std::sort(result.begin(), result.end(),
            [](const Diagnostic& a, const Diagnostic& b) { return a.message < b.message; });
  return result;
}

std::string need_of(const Diagnostic& limit) {
  return limit.label + " (" + limit.why.front() + ")";
}

Diagnostic left_out_for_limit(Diagnostic limit) {
  constexpr std::string_view kNeeds = " needs ";
  limit.severity = Severity::kWarning;
  if (const auto at = limit.message.find(kNeeds); at != std::string::npos)
    limit.message.replace(at, kNeeds.size(), " is skipped: it needs ");
  return limit;
}

}  // namespace ros2wasm
