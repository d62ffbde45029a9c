// See compiler_warnings.hpp.
#include "bundler/build/compiler_warnings.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <tuple>

#include "bundler/build/long_width.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kOfCommands = "command-findings.json";
constexpr const char* kOfPackage = ".build-findings.json";
constexpr std::size_t kLongestLine = 4000;  // longer ones are no message

/// Ends what a message says: another one, or the compiler's count.
bool begins_another(const std::string& line) {
  static const std::regex kBegin(
      R"(^(?:.+?:\d+:\d+: (?:warning|(?:fatal )?error): .*|In file included from .*|\d+ warnings?(?: and \d+ errors?)? generated\.)$)");
  return line.size() <= kLongestLine && std::regex_match(line, kBegin);
}

using Identity = std::tuple<std::string, std::string, std::uint32_t, std::uint32_t, std::string>;

Identity identity_of(const Diagnostic& one) {
  const SourceSpan span = one.span.value_or(SourceSpan());
  return {one.code.text(), span.file, span.line, span.column, one.message};
}

Diagnostics each_once(const Diagnostics& findings) {
  std::set<Identity> known;
  Diagnostics result;
  for (const Diagnostic& one : findings)
    if (known.insert(identity_of(one)).second) result.push_back(one);
  return result;
}

/// The file that a command makes, from the line that ninja prints for it: "Building CXX object
/// a.cpp.o".
std::string output_of(const std::string& ninja_line) {
  constexpr auto kKinds = std::to_array<std::string_view>({" object ", " executable "});
  for (const std::string_view kind : kKinds)
    if (const auto at = ninja_line.find(kind); at != std::string::npos)
      return ninja_line.substr(at + kind.size());
  return {};
}

}  // namespace

Diagnostics compiler_warnings(std::string_view text, const BuildPlace& place) {
  static const std::regex kWarning(R"(^(.+?):(\d+):(\d+): warning: (.*)$)");
  BuildPlace below = place;  // what is kept must not depend on how the folder was named
  below.display.clear();
  const auto lines = output_lines(text);
  Diagnostics result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (lines[i].size() > kLongestLine || !std::regex_match(lines[i], match, kWarning) ||
        !is_worth_saying(match[4]))
      continue;
    Diagnostic warning{.code = kCompilerWarning,
                       .severity = Severity::kWarning,
                       .message = match[4],
                       .span = SourceSpan{.file = display_file(match[1], below),
                                          .line = printed_number(match[2].str()),
                                          .column = printed_number(match[3].str()),
                                          .length = 1}};
    if (i + 2 < lines.size() && lines[i + 2].find('^') != std::string::npos) {
      warning.span->line_text = lines[i + 1];
      i += 2;
    }
    bool is_of_our_header =
        false;  // where the check of a format is written, its user need not know
    while (i + 1 < lines.size() && !begins_another(lines[i + 1])) {
      const std::string& more = lines[++i];
      if (more.find(": note: ") != std::string::npos)
        is_of_our_header = more.find("from 'diagnose_if' attribute") != std::string::npos ||
                           more.find("macro 'ROS2WASM_") != std::string::npos;
      if (is_of_our_header) continue;
      const bool is_part_of_picture = more.find_first_not_of(" ~^") == std::string::npos;
      if (!warning.detail.empty() || !is_part_of_picture) warning.detail += more + "\n";
    }
    explain_long_width(warning);
    if (fs::path(warning.span->file).is_relative()) result.push_back(std::move(warning));
  }
  return each_once(result);
}

CommandFindings command_findings(std::string_view ninja_output, const BuildPlace& place) {
  CommandFindings result;
  std::string output;
  std::string text;
  const auto close = [&] {
    if (!output.empty()) result[output] = compiler_warnings(text, place);
    text.clear();
  };
  for (const std::string& line : output_lines(ninja_output)) {
    if (!is_ninja_line(line)) {
      text += line + "\n";
      continue;
    }
    close();
    output = output_of(line);
  }
  close();
  return result;
}

CommandFindings current_findings(CommandFindings earlier, CommandFindings fresh,
                                 std::string_view build_ninja) {
  fresh.merge(earlier);
  std::erase_if(fresh, [&](const auto& one) {
    return one.second.empty() || build_ninja.find("build " + one.first + ":") == build_ninja.npos;
  });
  return fresh;
}

Diagnostics all_findings(const CommandFindings& findings) {
  Diagnostics all;
  for (const auto& [output, diagnostics] : findings) append(all, diagnostics);
  return each_once(all);
}

CommandFindings read_command_findings(const fs::path& work) {
  CommandFindings result;
  const auto text = read_file(work / kOfCommands, kMostOfList);
  const auto json = text ? parse_json(*text, kOfCommands, "R2W0506") : text.errors();
  if (!json) return result;
  for (const JsonValue& item : json->items()) {
    const LinkFindings one = link_findings_from_json(item.text_of("findings"));
    result[one.output] = one.diagnostics;
  }
  return result;
}

Outcome<Done> write_command_findings(const fs::path& work, const CommandFindings& findings) {
  JsonWriter json;
  json.begin_array();
  for (const auto& [output, diagnostics] : findings) {
    json.begin_object();
    json.field("findings", link_findings_to_json(
                               {.output = output, .program = {}, .diagnostics = diagnostics}));
    json.end_object();
  }
  json.end_array();
  return write_file(work / kOfCommands, json.text());
}

Outcome<Done> keep_findings(const fs::path& prefix, const Diagnostics& findings) {
  if (findings.empty()) return Done{};
  return write_file(prefix / kOfPackage, diagnostics_to_json(findings));
}

Diagnostics kept_findings(const fs::path& prefix, const BuildPlace& place) {
  std::error_code error;
  if (!fs::exists(prefix / kOfPackage, error)) return {};
  const auto text = read_file(prefix / kOfPackage, kMostOfList);
  if (!text) return text.errors();
  Diagnostics result = diagnostics_from_json(*text);
  for (Diagnostic& one : result)
    if (one.span && !place.display.empty()) one.span->file = place.display + "/" + one.span->file;
  return result;
}

}  // namespace ros2wasm
