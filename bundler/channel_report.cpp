// The report of `ros2wasm channel build` (channel_build.hpp). Pure.
#include <algorithm>
#include <map>

#include "bundler/channel_build.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

std::string_view word_of(ChannelPackageState state) {
  switch (state) {
    case ChannelPackageState::kAdded:
      return "added";
    case ChannelPackageState::kUnchanged:
      return "unchanged";
    case ChannelPackageState::kFailed:
      return "failed";
    case ChannelPackageState::kSkipped:
      return "skipped";
  }
  return {};
}

std::size_t count_of(const ChannelBuildReport& report, ChannelPackageState state) {
  return static_cast<std::size_t>(
      std::count_if(report.packages.begin(), report.packages.end(),
                    [state](const ChannelPackage& one) { return one.state == state; }));
}

/// A cell of a table: a bar would begin the next one.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '\\') result += '\\';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result;
}

std::string cause_of(const ChannelPackage& package) {
  if (!package.errors.empty()) return package.errors.front().message;
  return package.reason.empty() ? std::string() : package.reason.front();
}

/// Failures with the same code and message, and the packages that have them.
using Causes = std::map<std::pair<std::string, std::string>, std::vector<std::string>>;

Causes causes_of(const ChannelBuildReport& report) {
  Causes causes;
  for (const ChannelPackage& package : report.packages) {
    if (package.state != ChannelPackageState::kFailed) continue;
    for (const Diagnostic& error : package.errors) {
      auto& names = causes[{std::string(error.code.text()), error.message}];
      if (names.empty() || names.back() != package.name) names.push_back(package.name);
    }
  }
  return causes;
}

}  // namespace

std::string channel_report_markdown(const ChannelBuildReport& report) {
  std::string text = "# Packages of the channel\n\n";
  for (const auto state : {ChannelPackageState::kAdded, ChannelPackageState::kUnchanged,
                           ChannelPackageState::kFailed, ChannelPackageState::kSkipped})
    text +=
        "- " + std::string(word_of(state)) + ": " + std::to_string(count_of(report, state)) + "\n";
  if (const Causes causes = causes_of(report); !causes.empty()) {
    text += "\n## Causes of failures\n\n| code | cause | packages |\n| --- | --- | --- |\n";
    for (const auto& [cause, names] : causes) {
      std::string list;
      for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
      text += "| " + cause.first + " | " + cell(cause.second) + " | " + list + " |\n";
    }
  }
  text +=
      "\n## Packages\n\n| package | version | state | archive or cause | source |\n"
      "| --- | --- | --- | --- | --- |\n";
  for (const ChannelPackage& one : report.packages) {
    text += "| " + one.name + " | " + one.version + " | " + std::string(word_of(one.state)) +
            " | " + cell(one.archive.empty() ? cause_of(one) : one.archive) + " | " +
            cell(one.origin) + " |\n";
  }
  return text;
}

std::string channel_report_json(const ChannelBuildReport& report) {
  JsonWriter json;
  json.begin_object();
  for (const auto state : {ChannelPackageState::kAdded, ChannelPackageState::kUnchanged,
                           ChannelPackageState::kFailed, ChannelPackageState::kSkipped})
    json.key(word_of(state)).unsigned_integer(count_of(report, state));
  json.key("causes").begin_array();
  for (const auto& [cause, names] : causes_of(report)) {
    json.begin_object().field("code", cause.first).field("message", cause.second);
    json.key("packages").begin_array();
    for (const std::string& name : names) json.string(name);
    json.end_array().end_object();
  }
  json.end_array().key("packages").begin_array();
  for (const ChannelPackage& one : report.packages) {
    json.begin_object().field("name", one.name).field("version", one.version);
    json.field("state", word_of(one.state));
    if (!one.archive.empty()) json.field("archive", one.archive);
    if (!one.origin.empty()) json.field("source", one.origin);
    if (one.archive.empty()) json.field("cause", cause_of(one));
    json.end_object();
  }
  return json.end_array().end_object().text();
}

}  // namespace ros2wasm
