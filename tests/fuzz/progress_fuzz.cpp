// Any text as a file that a student hands in, and as the record in one that is signed: refused, or
// read; what is read can be printed, and fits the site that its tasks are of.
#include <algorithm>

#include "bundler/io/base64.hpp"
#include "bundler/io/ed25519.hpp"
#include "bundler/verify/progress_file.hpp"
#include "tests/fuzz/require.hpp"
#include "workspace_schema/base/json_writer.hpp"

using namespace ros2wasm;

namespace {

/// A file with this record, signed as a student's browser would.
std::string signed_file(std::string_view record) {
  const std::string seed(32, 's');
  static const std::string public_key = ed25519_public(seed + std::string(32, '\0'));
  const std::string signature =
      ed25519_sign("ros2wasm progress 1\n" + std::string(record), seed + public_key);
  JsonWriter json;
  json.begin_object().field("format", "ros2wasm progress").field_integer("schema", 1);
  json.field("record", record).field("key", base64(public_key));
  json.field("signature", base64(signature)).end_object();
  return json.text();
}

bool is_one_line(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < 0x20 || byte == 0x7F;
  });
}

/// Each cell is quoted; two quotes are one of its text.
bool has_formula(std::string_view rows) {
  bool inside = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] != '"') continue;
    const bool opens = !inside;
    inside = opens;
    if (opens && std::string_view("=+-@").find(rows[i + 1]) != std::string_view::npos &&
        (i == 0 || rows[i - 1] != '"'))
      return true;
  }
  return false;
}

/// The sites that it is of, if it is honest.
std::vector<AskedTasks> sites_of(const ProgressFile& file) {
  std::vector<AskedTasks> sites;
  for (const HandedLab& lab : file.labs) {
    AskedTasks site{
        .sha256 = lab.sha256, .titles = {}, .names = {lab.title}, .course = file.course};
    for (const HandedTask& task : lab.tasks) site.titles.push_back(task.title);
    sites.push_back(std::move(site));
  }
  return sites;
}

void check_file(const ProgressFile& file) {
  std::size_t tasks = 0;
  fuzz::require(is_one_line(file.student) && is_one_line(file.course), "one line");
  for (const HandedLab& lab : file.labs) {
    tasks += lab.tasks.size();
    fuzz::require(is_one_line(lab.title), "one line");
    for (const HandedTask& task : lab.tasks) fuzz::require(is_one_line(task.title), "one line");
  }
  const std::string rows = progress_csv(file, "ada.json");
  fuzz::require(static_cast<std::size_t>(std::count(rows.begin(), rows.end(), '\n')) == tasks,
                "a row for each task");
  fuzz::require(!has_formula(rows), "no cell is a formula");
  const std::vector<AskedTasks> sites = sites_of(file);
  for (const Diagnostic& fault : check_progress(file, sites, "ada.json"))
    fuzz::require(fault.code == "R2W0672", "compared with the sites");
  fuzz::require(!lacking_labs(file, sites, "ada.json"), "it lacks no lab of its own");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  if (const auto file = read_progress_file(text, "ada.json")) check_file(*file);
  if (const auto file = read_progress_file(signed_file(text), "ada.json")) check_file(*file);
  static_cast<void>(asked_tasks(text, "site.json"));
  return 0;
}
