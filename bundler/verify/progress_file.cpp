// See progress_file.hpp.
#include "bundler/verify/progress_file.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "bundler/io/base64.hpp"
#include "bundler/io/ed25519.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/json_reader.hpp"
#include "workspace_schema/text_encoding.hpp"

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

/// One line that a terminal and a table show as it is: no control characters, line separators, byte
/// order marks or changes of the writing direction.
bool is_plain(std::string_view text) {
  if (text.size() > kLongestText) return false;
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character character = decode_utf8(text, i);
    const char32_t c = character.code_point;
    if (c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x2028 && c <= 0x202E) ||
        (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF)
      return false;
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

bool is_sha256(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
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
  if (!take(json, "title", is_plain, lab.title) || !take(json, "sha256", is_sha256, lab.sha256) ||
      lab.sha256.empty() || tasks == nullptr || !tasks->is_array())
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
  AskedTasks asked{.sha256 = sha256_hex(site_json), .titles = {}};
  if (const JsonValue* tasks = json->find("tasks"))
    for (const JsonValue& task : tasks->items()) asked.titles.push_back(task.text_of("title"));
  return asked;
}

Diagnostics check_progress(const ProgressFile& file, const std::vector<AskedTasks>& sites,
                           const std::string& shown) {
  Diagnostics faults;
  for (const HandedLab& lab : file.labs) {
    const auto site = std::find_if(sites.begin(), sites.end(),
                                   [&](const AskedTasks& one) { return one.sha256 == lab.sha256; });
    if (site == sites.end()) {
      faults.push_back(
          Diagnostic{.code = "R2W0672",
                     .message = "`" + shown + "` is of another site: `" + lab.title + "`",
                     .why = {"its sha256 is " + lab.sha256 + ", which none of the given sites has"},
                     .fix = {}});
      continue;
    }
    std::vector<std::string> titles;
    for (const HandedTask& task : lab.tasks) titles.push_back(task.title);
    if (titles == site->titles) continue;
    faults.push_back(
        Diagnostic{.code = "R2W0672",
                   .message = "`" + shown + "` has other tasks than the site `" + lab.title + "`",
                   .why = {"it lists " + std::to_string(titles.size()) + " tasks, the site has " +
                           std::to_string(site->titles.size())},
                   .fix = {}});
  }
  return faults;
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
