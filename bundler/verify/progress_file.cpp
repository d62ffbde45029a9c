// See progress_file.hpp.
#include "bundler/verify/progress_file.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "bundler/io/base64.hpp"
#include "bundler/io/ed25519.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/hash_text.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/text_encoding.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kFormat = "ros2wasm progress";
constexpr std::int64_t kSchema = 1;
/// Stands before the record in what is signed, so that no other signature of the key fits.
constexpr std::string_view kSignedAs = "ros2wasm progress 1\n";
constexpr std::size_t kMostLabs = 1000;
/// In all labs together: each task becomes a row of the CSV, with the texts of its lab.
constexpr std::size_t kMostTasks = 5000;
constexpr std::size_t kLongestText = 1000;  ///< bytes
constexpr std::size_t kKeyDigits = 16;

Diagnostic no_progress(const std::string& shown, std::string why) {
  return Diagnostic{.code = "R2W0670",
                    .message = "`" + shown + "` is not a file that a student hands in",
                    .why = {std::move(why)},
                    .fix = {}};
}

/// Characters that a terminal or a table does not show as they are: control characters, line
/// separators, byte order marks and changes of the writing direction.
bool steers(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
}

/// As the page writes a title into the file: a space for each such character.
std::string as_handed_in(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character character = decode_utf8(text, i);
    if (steers(character.code_point))
      plain += ' ';
    else
      plain += text.substr(i, character.length);
    i += character.length;
  }
  return plain;
}

/// One line that a terminal and a table show as it is.
bool is_plain(std::string_view text) {
  if (text.size() > kLongestText) return false;
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character character = decode_utf8(text, i);
    if (steers(character.code_point)) return false;
    i += character.length;
  }
  return true;
}

/// `2026-11-28T09:00:00.000Z`, with or without the fraction.
bool is_time(std::string_view text) {
  constexpr std::string_view kForm = "dddd-dd-ddTdd:dd:dd";
  if (!text.ends_with('Z') || text.size() <= kForm.size()) return false;
  for (std::size_t i = 0; i < kForm.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    if (kForm[i] == 'd' ? !digit : text[i] != kForm[i]) return false;
  }
  std::string_view rest = text.substr(kForm.size(), text.size() - kForm.size() - 1);
  if (rest.empty()) return true;
  return rest.size() == 4 && rest.front() == '.' &&
         rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

/// Takes an optional member. False when its type or its form is wrong.
bool take(const JsonValue& from, std::string_view key, bool (*good)(std::string_view),
          std::string& target) {
  const JsonValue* found = from.find(key);
  if (found == nullptr) return true;
  if (found->string() == nullptr || !good(*found->string())) return false;
  target = *found->string();
  return true;
}

std::optional<HandedTask> read_task(const JsonValue& json) {
  HandedTask task;
  const bool good = take(json, "title", is_plain, task.title) &&
                    take(json, "done_at", is_time, task.done_at) &&
                    take(json, "hint_at", is_time, task.hint_at) &&
                    take(json, "solution_at", is_time, task.solution_at);
  if (!good || task.title.empty()) return std::nullopt;
  return task;
}

std::optional<HandedLab> read_lab(const JsonValue& json) {
  HandedLab lab;
  const JsonValue* tasks = json.find("tasks");
  if (!take(json, "title", is_plain, lab.title) ||
      !take(json, "sha256", is_sha256_text, lab.sha256) || lab.sha256.empty() || tasks == nullptr ||
      !tasks->is_array())
    return std::nullopt;
  for (const JsonValue& one : tasks->items()) {
    auto task = read_task(one);
    if (!task) return std::nullopt;
    lab.tasks.push_back(*std::move(task));
  }
  return lab;
}

/// Nothing when the record is not of the form.
std::optional<ProgressFile> read_record(const JsonValue& json) {
  ProgressFile file;
  const JsonValue* labs = json.find("labs");
  if (!take(json, "student", is_plain, file.student) || file.student.empty() ||
      !take(json, "exported_at", is_time, file.exported_at) || file.exported_at.empty() ||
      !take(json, "course", is_plain, file.course) || labs == nullptr || !labs->is_array() ||
      labs->items().empty() || labs->items().size() > kMostLabs)
    return std::nullopt;
  std::size_t tasks = 0;
  for (const JsonValue& one : labs->items()) {
    auto lab = read_lab(one);
    if (!lab || lab->tasks.size() > kMostTasks - tasks) return std::nullopt;
    tasks += lab->tasks.size();
    file.labs.push_back(*std::move(lab));
  }
  return file;
}

/// Spreadsheets run a text that begins like a formula, some of them behind spaces and in full
/// width.
bool begins_like_formula(std::string_view text) {
  constexpr auto kSpaces = std::to_array<std::string_view>({" ", "\u00A0", "\u3000"});
  constexpr auto kSigns =
      std::to_array<std::string_view>({"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"});
  const auto begins = [&](std::string_view with) { return text.starts_with(with); };
  const auto space = [&] { return std::find_if(kSpaces.begin(), kSpaces.end(), begins); };
  for (auto found = space(); found != kSpaces.end(); found = space())
    text.remove_prefix(found->size());
  return std::any_of(kSigns.begin(), kSigns.end(), begins);
}

std::string cell(std::string_view text) {
  std::string quoted = begins_like_formula(text) ? "\"'" : "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + "\"";
}

Diagnostic other_site(std::string message, std::string why) {
  Diagnostic made{.code = "R2W0672", .message = std::move(message), .why = {}, .fix = {}};
  if (!why.empty()) made.why.push_back(std::move(why));
  return made;
}

bool is_name_of(const std::string& title, const AskedTasks& site) {
  return std::any_of(site.names.begin(), site.names.end(),
                     [&](const std::string& name) { return as_handed_in(name) == title; });
}

/// A course may list one site twice, under two titles. Null: it is none of these.
const AskedTasks* site_of(const HandedLab& lab, const std::vector<AskedTasks>& sites) {
  const AskedTasks* found = nullptr;
  for (const AskedTasks& one : sites) {
    if (one.sha256 != lab.sha256) continue;
    if (is_name_of(lab.title, one)) return &one;
    if (found == nullptr) found = &one;
  }
  return found;
}

/// R2W0672: the lab is not called or has not the tasks that this site of its sha256 has.
Diagnostics check_lab(const HandedLab& lab, const AskedTasks& site, const std::string& shown) {
  Diagnostics faults;
  if (!is_name_of(lab.title, site))
    faults.push_back(
        other_site("`" + shown + "` has another title for the lab `" + site.names.back() + "`",
                   "it says `" + lab.title + "`"));
  std::vector<std::string> handed;
  std::vector<std::string> wanted;
  for (const HandedTask& task : lab.tasks) handed.push_back(task.title);
  for (const std::string& title : site.titles) wanted.push_back(as_handed_in(title));
  if (handed != wanted)
    faults.push_back(
        other_site("`" + shown + "` has other tasks than the site `" + site.names.back() + "`",
                   "it lists " + std::to_string(handed.size()) + " tasks, the site has " +
                       std::to_string(wanted.size())));
  return faults;
}

}  // namespace

Outcome<ProgressFile> read_progress_file(std::string_view text, const std::string& shown) {
  const auto json = parse_json(text, shown, "R2W0670");
  if (!json) return json.errors();
  if (json->text_of("format") != kFormat)
    return no_progress(shown, "its `format` is not `" + std::string(kFormat) + "`");
  const JsonValue* schema = json->find("schema");
  if (schema == nullptr || schema->integer() != kSchema)
    return no_progress(shown, "its `schema` is not 1, the one that this ros2wasm reads");
  const JsonValue* record = json->find("record");
  const auto key = base64_read(json->text_of("key"));
  const auto signature = base64_read(json->text_of("signature"));
  if (record == nullptr || record->string() == nullptr || !key ||
      key->size() != kEd25519PublicBytes || !signature ||
      signature->size() != kEd25519SignatureBytes)
    return no_progress(shown, "it has no record, key and signature");
  if (!ed25519_verify(std::string(kSignedAs) + *record->string(), *signature, *key))
    return Diagnostic{.code = "R2W0671",
                      .message = "`" + shown + "` was changed after it was signed",
                      .why = {"its signature is not that of its record and its key"},
                      .fix = {}};
  const auto inner = parse_json(*record->string(), shown + " (record)", "R2W0670");
  if (!inner) return inner.errors();
  auto file = read_record(*inner);
  if (!file)
    return no_progress(shown, "its record is signed, but not of the form that the page writes");
  file->key = sha256_hex(*key).substr(0, kKeyDigits);
  return *std::move(file);
}

Outcome<AskedTasks> asked_tasks(std::string_view site_json, const std::string& shown) {
  const auto json = parse_json(site_json, shown, "R2W0605");
  if (!json) return json.errors();
  AskedTasks asked{.sha256 = sha256_hex(site_json), .titles = {}, .names = {}, .course = {}};
  // Without a title, the page shows the name.
  const std::string title = json->text_of("title");
  asked.names.push_back(title.empty() ? json->text_of("name") : title);
  if (const JsonValue* tasks = json->find("tasks"))
    for (const JsonValue& task : tasks->items()) asked.titles.push_back(task.text_of("title"));
  return asked;
}

Diagnostics check_progress(const ProgressFile& file, const std::vector<AskedTasks>& sites,
                           const std::string& shown) {
  Diagnostics faults;
  std::set<std::pair<std::string, std::string>> seen;
  std::set<std::string> courses;
  for (const HandedLab& lab : file.labs) {
    const AskedTasks* site = site_of(lab, sites);
    if (site == nullptr) {
      faults.push_back(
          other_site("`" + shown + "` is of another site: `" + lab.title + "`",
                     "its sha256 is " + lab.sha256 + ", which none of the given sites has"));
      continue;
    }
    if (!seen.emplace(lab.sha256, lab.title).second)
      faults.push_back(
          other_site("`" + shown + "` has the lab `" + lab.title + "` more than once", {}));
    if (!site->course.empty()) courses.insert(as_handed_in(site->course));
    append(faults, check_lab(lab, *site, shown));
  }
  if (!file.course.empty() && !courses.empty() && !courses.contains(file.course))
    faults.push_back(other_site("`" + shown + "` is of another course: `" + file.course + "`",
                                "its labs are of `" + *courses.begin() + "`"));
  return faults;
}

std::optional<Diagnostic> lacking_labs(const ProgressFile& file,
                                       const std::vector<AskedTasks>& sites,
                                       const std::string& shown) {
  if (file.course.empty()) return std::nullopt;
  Diagnostic warning{.code = "R2W0674",
                     .severity = Severity::kWarning,
                     .message = "`" + shown + "` lacks labs of the course `" + file.course + "`",
                     .why = {},
                     .fix = {}};
  for (const AskedTasks& site : sites) {
    if (as_handed_in(site.course) != file.course || site.titles.empty()) continue;
    // An earlier version has another sha256 and, most likely, the same title.
    const bool there = std::any_of(file.labs.begin(), file.labs.end(), [&](const HandedLab& lab) {
      return lab.sha256 == site.sha256 || is_name_of(lab.title, site);
    });
    if (!there) warning.why.push_back(site.names.back());
  }
  if (warning.why.empty()) return std::nullopt;
  return warning;
}

std::string progress_csv_head() {
  return "student,course,lab,task,done_at,hint_at,solution_at,exported_at,key,sha256,file\n";
}

std::string progress_csv(const ProgressFile& file, const std::string& shown) {
  std::string rows;
  for (const HandedLab& lab : file.labs) {
    for (const HandedTask& task : lab.tasks) {
      const std::array<std::string_view, 11> cells{
          file.student,     file.course,      lab.title, task.title, task.done_at, task.hint_at,
          task.solution_at, file.exported_at, file.key,  lab.sha256, shown};
      for (std::size_t i = 0; i < cells.size(); ++i) rows += (i == 0 ? "" : ",") + cell(cells[i]);
      rows += "\n";
    }
  }
  return rows;
}

}  // namespace ros2wasm
