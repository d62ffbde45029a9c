// See setup_plan.hpp.
#include "bundler/build/setup_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

constexpr DiagnosticCode kCode = "R2W0516";
constexpr std::string_view kPrograms = "console_scripts";

Diagnostic refused(const BuildPlace& place, const std::string& file, std::uint32_t line,
                   std::string why) {
  return Diagnostic{
      .code = kCode,
      .message = file + " of package `" + place.package + "` fails",
      .span = SourceSpan{.file = (std::filesystem::path(place.display) / file).string(),
                         .line = line,
                         .line_text = {}},
      .why = {std::move(why)}};
}

/// Neither absolute nor out of its folder.
bool stays_below(const std::string& path) {
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  return !path.empty() && normal.is_relative() && *normal.begin() != ".." && normal != ".";
}

std::vector<SetupFile> files_of(const JsonValue& json, std::string_view key,
                                const BuildPlace& place, Diagnostics& errors) {
  std::vector<SetupFile> result;
  const JsonValue* list = json.find(key);
  if (list == nullptr) return result;
  for (const JsonValue& pair : list->items()) {
    const auto& items = pair.items();
    const std::string* from = items.size() == 2 ? items[0].string() : nullptr;
    const std::string* to = items.size() == 2 ? items[1].string() : nullptr;
    if (from == nullptr || to == nullptr) continue;
    for (const std::string* path : {from, to}) {
      if (!stays_below(*path))
        errors.push_back(refused(place, "setup.py", 0, "`" + *path + "` leads out of its folder"));
    }
    result.push_back({.from = *from, .to = *to});
  }
  return result;
}

std::vector<WrittenFile> written_of(const JsonValue& json, const BuildPlace& place,
                                    Diagnostics& errors) {
  std::vector<WrittenFile> result;
  const JsonValue* list = json.find("written");
  if (list == nullptr) return result;
  for (const JsonValue& pair : list->items()) {
    const auto& items = pair.items();
    const std::string* to = items.size() == 2 ? items[0].string() : nullptr;
    const std::string* text = items.size() == 2 ? items[1].string() : nullptr;
    if (to == nullptr || text == nullptr) continue;
    if (!stays_below(*to))
      errors.push_back(refused(place, "setup.py", 0, "`" + *to + "` leads out of its folder"));
    result.push_back({.to = *to, .text = *text});
  }
  return result;
}

Diagnostics warnings_of(const JsonValue& json, const BuildPlace& place) {
  Diagnostics result;
  const JsonValue* list = json.find("warnings");
  if (list == nullptr) return result;
  for (const JsonValue& one : list->items()) {
    const JsonValue* line = one.find("line");
    const std::string file = one.text_of("file");
    result.push_back(Diagnostic{
        .code = "R2W0527",
        .severity = Severity::kWarning,
        .message = "a line of " + file + " of package `" + place.package + "` is skipped",
        .span = SourceSpan{.file = file,
                           .line = line == nullptr
                                       ? 0U
                                       : static_cast<std::uint32_t>(line->integer().value_or(0)),
                           .line_text = {}},
        .why = {one.text_of("message")}});
  }
  return result;
}

/// Every keyword of setup() that setuptools passes over.
Diagnostics unknown_keywords(const JsonValue& json, const BuildPlace& place) {
  static const std::vector<std::string> kMeant = {
      "cmdclass",         "data_files",   "entry_points", "include_package_data",
      "install_requires", "package_data", "package_dir",  "packages",
      "py_modules",       "scripts",      "version"};
  Diagnostics result;
  const JsonValue* list = json.find("unknown");
  if (list == nullptr) return result;
  for (const JsonValue& one : list->items()) {
    const JsonValue* line = one.find("line");
    const std::string keyword = one.text_of("keyword");
    Diagnostic warning{
        .code = "R2W0527",
        .severity = Severity::kWarning,
        .message = "setup() of package `" + place.package + "` has no keyword `" + keyword + "`",
        .span = SourceSpan{.file = "setup.py",
                           .line = line == nullptr
                                       ? 0U
                                       : static_cast<std::uint32_t>(line->integer().value_or(0)),
                           .line_text = {}},
        .why = {"setuptools skips it too"}};
    if (const auto similar = nearest(keyword, kMeant))
      warning.fix.push_back("write `" + *similar + "=`");
    result.push_back(std::move(warning));
  }
  return result;
}

/// Whether all characters may be in a name or a version: both become part of a folder's name.
bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("._+!-").find(c) != std::string_view::npos;
  });
}

bool is_dotted_name(std::string_view text) {
  return !text.empty() && text.front() != '.' && text.back() != '.' &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return c == '_' || c == '.' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                  (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
         });
}

std::optional<EntryPoint> entry_point(const std::string& line) {
  const auto equals = line.find('=');
  if (equals == std::string::npos) return std::nullopt;
  std::string_view target = std::string_view(line).substr(equals + 1);
  target = target.substr(0, target.find('['));  // extras
  const auto colon = target.find(':');
  const bool has_function = colon != std::string_view::npos;
  EntryPoint entry{.name = std::string(trimmed(std::string_view(line).substr(0, equals))),
                   .module = std::string(trimmed(target.substr(0, colon))),
                   .function = {}};
  if (has_function) entry.function = std::string(trimmed(target.substr(colon + 1)));
  const bool is_file_name = stays_below(entry.name) && entry.name.find('/') == std::string::npos;
  if (!is_file_name || !is_dotted_name(entry.module) ||
      (has_function && !is_dotted_name(entry.function)))
    return std::nullopt;
  return entry;
}

}  // namespace

Outcome<SetupPlan> read_setup_plan(std::string_view json, const BuildPlace& place) {
  const auto parsed = parse_json(json, "what setup.py would install", kCode);
  if (!parsed) return parsed.errors();
  if (const JsonValue* error = parsed->find("error")) {
    const JsonValue* line = error->find("line");
    return refused(place, error->text_of("file"),
                   line == nullptr ? 0U : static_cast<std::uint32_t>(line->integer().value_or(0)),
                   error->text_of("message"));
  }
  Diagnostics errors;
  SetupPlan plan{.name = parsed->text_of("name"),
                 .version = parsed->text_of("version"),
                 .modules = files_of(*parsed, "modules", place, errors),
                 .data = files_of(*parsed, "data", place, errors),
                 .scripts = files_of(*parsed, "scripts", place, errors),
                 .written = written_of(*parsed, place, errors),
                 .script_folder = parsed->text_of("script_folder"),
                 .programs = {},
                 .entry_points = {},
                 .warnings = warnings_of(*parsed, place)};
  append(plan.warnings, unknown_keywords(*parsed, place));
  for (const auto& [what, text] : {std::pair("name", &plan.name), {"version", &plan.version}}) {
    if (is_plain(*text)) continue;
    errors.push_back(refused(place, "setup.py", 0,
                             "the " + std::string(what) + " `" + *text +
                                 "` has other characters than letters, digits and `._+!-`"));
  }
  if (!stays_below(plan.script_folder))
    errors.push_back(
        refused(place, "setup.cfg", 0, "`" + plan.script_folder + "` leads out of its folder"));
  if (const JsonValue* groups = parsed->find("entry_points")) {
    for (const auto& [group, lines] : groups->members()) {
      for (const JsonValue& item : lines.items()) {
        const std::string line = item.string() == nullptr ? "" : *item.string();
        plan.entry_points[group].push_back(line);
        if (group != kPrograms) continue;
        if (auto entry = entry_point(line)) {
          plan.programs.push_back(std::move(*entry));
        } else {
          errors.push_back(refused(
              place, "setup.py", 0,
              "the entry point `" + line + "` is not `NAME = MODULE:FUNCTION` or `NAME = MODULE`"));
        }
      }
    }
  }
  if (!errors.empty()) return errors;
  return plan;
}

std::string entry_point_script(const EntryPoint& entry, const std::string& package) {
  if (entry.function.empty()) {
    // As natively: the package installs, and the program fails when it runs.
    return "#!/usr/bin/env python3\n# The entry point `" + entry.name + " = " + entry.module +
           "` of " + package + ", which names no function.\nimport sys\n\nimport " + entry.module +
           "\n\nsys.exit(" + entry.module + "())\n";
  }
  const auto dot = entry.function.find('.');
  const std::string first = entry.function.substr(0, dot);
  return "#!/usr/bin/env python3\n# The entry point `" + entry.name + " = " + entry.module + ":" +
         entry.function + "` of " + package + ".\nimport sys\n\nfrom " + entry.module + " import " +
         first + "\n\nsys.exit(" + entry.function + "())\n";
}

std::string entry_points_text(const SetupPlan& plan) {
  std::string text;
  for (const auto& [group, lines] : plan.entry_points) {
    text += (text.empty() ? "[" : "\n[") + group + "]\n";
    for (const std::string& line : lines) text += line + "\n";
  }
  return text;
}

}  // namespace ros2wasm
