// See course_page.hpp.
#include "bundler/render/course_page.hpp"

#include <algorithm>
#include <utility>

#include "bundler/io/sha256.hpp"
#include "bundler/render/html_text.hpp"
#include "bundler/render/site_json.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/names.hpp"

namespace ros2wasm {
namespace {

constexpr int kCourseSchema = 1;
constexpr const char* kPage = "index.html";
constexpr const char* kStyle = "course.css";
constexpr const char* kScript = "course.js";

constexpr std::string_view kHead =
    R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'self'; )";
constexpr std::string_view kScriptPolicy = "script-src 'self'; ";
constexpr std::string_view kPolicyEnd = R"(base-uri 'none'; form-action 'none'">
)";

constexpr std::string_view kSheet = R"(:root { color-scheme: light dark; }
body {
  max-width: 44rem; margin: 0 auto; padding: 2rem 1rem;
  font: 1rem/1.5 system-ui, sans-serif; overflow-wrap: anywhere;
  color: #1b2430; background: #f3f5f8;
}
ol { padding-left: 1.5rem; }
li { margin: 1rem 0; }
li p { margin: 0.25rem 0 0; }
a { color: #0b57b5; font-weight: 600; }
.progress { color: #535e6e; font-size: 0.875rem; }
.done .progress { color: #12703b; }
.hand-in { margin-top: 2rem; padding-top: 1rem; border-top: 1px solid #7f8a99; }
.hand-in input, .hand-in button { display: block; margin-top: 0.25rem; padding: 0.25rem 0.5rem; font: inherit; }
.hand-in input { width: 100%; box-sizing: border-box; }
@media (prefers-color-scheme: dark) {
  body { color: #dfe5ee; background: #0e1116; }
  a { color: #7db4ff; }
  .progress { color: #a3aebd; }
  .done .progress { color: #63d696; }
}
)";

/// Paragraphs have empty lines between them.
std::string paragraphs(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("\n\n"), text.size());
    const std::string_view one = text.substr(0, end);
    if (one.find_first_not_of(" \t\r\n") != std::string_view::npos)
      html += "<p>" + html_text(one) + "</p>\n";
    text.remove_prefix(end);
    while (text.starts_with('\n')) text.remove_prefix(1);
  }
  return html;
}

bool has_tasks(const std::vector<PackedLab>& labs) {
  return std::any_of(labs.begin(), labs.end(),
                     [](const PackedLab& lab) { return !lab.tasks.empty(); });
}

/// Attributes for course.js: the lab's folder, the sha256 of its site, the titles of its tasks as
/// JSON.
std::string task_data(const PackedLab& lab) {
  JsonWriter titles;
  titles.begin_array();
  for (const std::string& title : lab.tasks) titles.string(title);
  titles.end_array();
  return " data-lab=\"" + html_text(lab.name) + "\" data-sha256=\"" + html_text(lab.sha256) +
         "\" data-tasks=\"" + html_text(titles.text()) + "\"";
}

std::string page_of(const Course& course, const std::vector<PackedLab>& labs) {
  std::string html(kHead);
  if (has_tasks(labs)) html += kScriptPolicy;
  html += kPolicyEnd;
  html += "<title>" + html_text(course.title) + "</title>\n";
  html +=
      "<link rel=\"stylesheet\" href=\"" + std::string(kStyle) + "\">\n</head>\n<body>\n<main>\n";
  html += "<h1>" + html_text(course.title) + "</h1>\n" + paragraphs(course.text) + "<ol>\n";
  for (const PackedLab& lab : labs) {
    // To a page and not to a folder: some hosts list folders.
    html += lab.tasks.empty() ? "<li>" : "<li" + task_data(lab) + ">";
    html += "<a href=\"" + html_text(lab.name) + "/index.html\">" + html_text(lab.title) +
            "</a>\n" + paragraphs(lab.description) + "</li>\n";
  }
  html += "</ol>\n</main>\n";
  if (has_tasks(labs)) html += "<script src=\"" + std::string(kScript) + "\"></script>\n";
  return html + "</body>\n</html>\n";
}

PlannedFile file(const char* path, const char* reason, std::string bytes) {
  std::string hash = sha256_hex(bytes);
  return {.path = path, .reason = reason, .bytes = std::move(bytes), .sha256 = std::move(hash)};
}

Diagnostic no_course(const std::string& shown, std::string why) {
  return Diagnostic{.code = "R2W0605",
                    .message = "`" + shown + "` is not the course.json of a course",
                    .why = {std::move(why)},
                    .fix = {}};
}

}  // namespace

std::vector<PlannedFile> course_files(const Course& course, const std::vector<PackedLab>& labs,
                                      const std::string& script) {
  std::vector<PlannedFile> files;
  files.push_back(file(kStyle, "looks of the list", std::string(kSheet)));
  files.push_back(file(kPage, "list of the labs", page_of(course, labs)));
  if (has_tasks(labs)) files.push_back(file(kScript, "progress in the labs' tasks", script));
  JsonWriter json;
  json.begin_object().field_integer("schema", kCourseSchema);
  json.field("generator", std::string(kSiteGenerator) + " " ROS2WASM_VERSION);
  json.field("name", course.name).field("title", course.title);
  json.key("labs").begin_array();
  for (const PackedLab& lab : labs) {
    json.begin_object().field("name", lab.name).field("title", lab.title);
    json.field("description", lab.description).field("sha256", lab.sha256);
    if (!lab.tasks.empty()) json.key("tasks").unsigned_integer(lab.tasks.size());
    json.end_object();
  }
  json.end_array().key("files").begin_array();
  for (const PlannedFile& one : files) {
    json.begin_object().field("path", one.path).key("size").unsigned_integer(one.bytes.size());
    json.field("sha256", one.sha256).field("reason", one.reason).end_object();
  }
  json.end_array().end_object();
  files.push_back(file(kCourseJsonName, "which labs there are", json.text() + "\n"));
  return files;
}

Outcome<CourseList> read_course_list(std::string_view text, const std::string& shown) {
  const auto json = parse_json(text, shown, "R2W0605");
  if (!json) return json.errors();
  CourseList list{.hash = sha256_hex(text),
                  .generator = json->text_of("generator"),
                  .title = json->text_of("title"),
                  .labs = {},
                  .sizes = {},
                  .files = {}};
  if (!list.generator.starts_with(kSiteGenerator))
    return no_course(shown, "its `generator` is not ros2wasm");
  const JsonValue* labs = json->find("labs");
  const JsonValue* files = json->find("files");
  if (labs == nullptr || files == nullptr) return no_course(shown, "it lists no labs");
  for (const JsonValue& one : labs->items()) {
    list.labs.push_back({.name = one.text_of("name"),
                         .title = one.text_of("title"),
                         .description = one.text_of("description"),
                         .sha256 = one.text_of("sha256")});
    // Also no path: it names a folder of the course.
    if (workspace_name_fault(list.labs.back().name))
      return no_course(shown, "`" + list.labs.back().name + "` is not a name of a lab");
  }
  for (const JsonValue& one : files->items()) {
    const JsonValue* size = one.find("size");
    const auto bytes = size == nullptr ? std::nullopt : size->unsigned_integer();
    list.files.push_back(one.text_of("path"));
    if (!bytes || workspace_name_fault(list.files.back()))
      return no_course(shown, "`" + list.files.back() + "` is not a file of a course");
    list.sizes.push_back({.size = *bytes, .sha256 = one.text_of("sha256")});
  }
  if (list.labs.empty()) return no_course(shown, "it lists no labs");
  if (std::find(list.files.begin(), list.files.end(), "index.html") == list.files.end())
    return no_course(shown, "it does not list the page index.html");
  return list;
}

}  // namespace ros2wasm
