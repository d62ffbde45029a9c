// See site_json.hpp. The keys and their order are part of the format.
#include "bundler/render/site_json.hpp"

#include "bundler/io/sha256.hpp"
#include "bundler/launch/launch_tree.hpp"
#include "bundler/render/citation.hpp"
#include "bundler/render/site_node_json.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/schema/check_json.hpp"

namespace ros2wasm {
namespace {

constexpr int kSiteSchema = 1;
constexpr int kProtocol = 1;

void write_checks(JsonWriter& json, const std::vector<CheckEntry>& checks) {
  if (checks.empty()) return;
  json.key("checks").begin_array();
  for (const CheckEntry& check : checks) {
    json.begin_object();
    write_check_fields(json, check);
    write_site_source(json, check.span);
    json.end_object();
  }
  json.end_array();
}

/// Hints and solutions too: the page shows them when it is asked to.
void write_tasks(JsonWriter& json, const std::vector<TaskEntry>& tasks) {
  if (tasks.empty()) return;
  json.key("tasks").begin_array();
  for (const TaskEntry& task : tasks) {
    json.begin_object();
    write_task_texts(json, task);
    json.key("checks").begin_array();
    for (const CheckEntry& check : task.checks) {
      json.begin_object();
      write_check_aim(json, check);
      write_site_source(json, check.span);
      json.end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
}

void write_sources(JsonWriter& json, const std::vector<PlannedSource>& sources) {
  if (sources.empty()) return;
  json.key("sources").begin_object().field("archive", kWorkspaceArchive).key("files").begin_array();
  for (const PlannedSource& source : sources) {
    json.begin_object().field("path", source.path).field("file", source.file);
    json.field("sha256", source.sha256).end_object();
  }
  json.end_array().end_object();
}

void write_ui(JsonWriter& json, const SitePlan& plan, const Manifest& manifest) {
  json.key("ui").begin_object();
  for (const auto& [key, value] : manifest.ui) {
    if (value == "true" || value == "false") {
      json.field_boolean(key, value == "true");
    } else {
      json.field(key, value);
    }
  }
  if (!manifest.ui_layout.empty()) json.key("layout").raw_value(manifest.ui_layout);
  if (manifest.ui_text) json.field("text", page_text_path(manifest.ui_text->value));
  if (!manifest.ui_bags.empty()) {
    json.key("bags").begin_array();
    for (const auto& bag : manifest.ui_bags) json.string(page_bag_path(bag.value));
    json.end_array();
  }
  if (!plan.panels.empty()) {
    json.key("opens").begin_array();
    for (const auto& [panel, file] : plan.panels) {
      json.begin_object().field("panel", panel);
      if (!file.empty()) json.field("file", file);
      json.end_object();
    }
    json.end_array();
  }
  json.end_object();
}

void write_parts(JsonWriter& json, const std::vector<FilePart>& parts) {
  if (parts.empty()) return;
  json.key("parts").begin_array();
  for (const FilePart& part : parts) {
    json.begin_object().key("size").unsigned_integer(part.size);
    json.field("sha256", part.sha256).end_object();
  }
  json.end_array();
}

void write_embed(JsonWriter& json, const Manifest& manifest) {
  if (manifest.site_embed.empty()) return;
  json.key("embed").begin_array();
  for (const auto& origin : manifest.site_embed) json.string(origin.value);
  json.end_array();
}

void write_notebook(JsonWriter& json, const PlannedNotebook& notebook) {
  json.key("notebook").begin_object().field("file", notebook.file);
  json.field("program", notebook.program).key("archives").begin_array();
  for (const std::string& archive : notebook.archives) json.string(archive);
  json.end_array();
  if (!notebook.load.empty()) {
    json.key("libraries").begin_array();
    for (const std::string& path : notebook.load) json.string(path);
    json.end_array();
  }
  json.end_object();
}

void write_launch(JsonWriter& json, const PlannedLaunch& launch) {
  json.key("launch_file").begin_object().field("data", launch.data);
  json.field("evaluator", launch.evaluator).key("arguments").begin_array();
  for (const LaunchArgument& one : launch.arguments) write_launch_argument(json, one);
  json.end_array();
  if (launch.asks_python) {
    const auto list = [&](const char* key, const std::vector<std::string>& texts) {
      json.key(key).begin_array();
      for (const std::string& one : texts) json.string(one);
      json.end_array();
    };
    json.key("python").begin_object();
    list("tried", launch.tried);
    if (!launch.python.empty()) {
      json.field("program", kPythonProgram);
      list("archives", launch.python);
    }
    json.end_object();
  }
  json.end_object();
}

}  // namespace

std::string site_json(const Manifest& manifest, const SitePlan& plan) {
  JsonWriter json;
  json.begin_object().field_integer("schema", kSiteSchema).field_integer("protocol", kProtocol);
  json.field("generator", std::string(kSiteGenerator) + " " ROS2WASM_VERSION);
  json.field("name", manifest.name.value);
  json.field("title", manifest.title.empty() ? manifest.name.value : manifest.title);
  json.field("version", manifest.version)
      .field("distro", manifest.distro)
      .field("license", manifest.license);
  json.key("authors").begin_array();
  for (const Author& author : manifest.authors) {
    const PersonName name = person_name(author.name);
    json.begin_object().field("name", author.name).field("family", name.family);
    if (!name.given.empty()) json.field("given", name.given);
    if (!author.email.empty()) json.field("email", author.email);
    if (!author.orcid.empty()) json.field("orcid", author.orcid);
    if (!author.affiliation.empty()) json.field("affiliation", author.affiliation);
    json.end_object();
  }
  json.end_array();
  if (manifest.citation) {
    json.key("citation").begin_object().field("date_released", manifest.citation->date_released);
    json.field("doi", manifest.citation->doi).field("repository", manifest.citation->repository);
    json.end_object();
  }
  json.key("nodes").begin_array();
  for (const PlannedNode& node : plan.nodes) write_site_node(json, node);
  json.end_array();
  if (!plan.programs.empty()) {
    json.key("programs").begin_array();
    for (const PlannedNode& program : plan.programs) write_site_program(json, program);
    json.end_array();
  }
  if (manifest.launch_file) {
    json.key("launch").begin_object().field("file", manifest.launch_file->value);
    if (!plan.launch_package.empty()) json.field("package", plan.launch_package);
    write_launch_steps(json, plan.steps);
    json.end_object();
  }
  json.field("interfaces", "interfaces.json");
  // The hash of the page of `pack -o NAME.html` without the files, for `ros2wasm verify`.
  json.field("carried_page_sha256", sha256_hex(plan.carried_page));
  if (plan.launch) write_launch(json, *plan.launch);
  json.key("packages").begin_array();
  for (const std::string& package : plan.packages) json.string(package);
  json.end_array();
  write_sources(json, plan.sources);
  write_checks(json, plan.checks);
  write_tasks(json, plan.tasks);
  if (plan.notebook) write_notebook(json, *plan.notebook);
  write_ui(json, plan, manifest);
  if (!plan.store.objects.empty()) {
    json.key("store").begin_object().field("objects", plan.store.objects);
    json.field("scripts", plan.store.scripts).end_object();
  }
  write_embed(json, manifest);
  json.key("files").begin_array();
  for (const PlannedFile& file : plan.files) {
    json.begin_object().field("path", file.path);
    json.key("size").unsigned_integer(file.bytes.size());
    json.field("sha256", file.sha256).field("reason", file.reason);
    const std::string_view kept = plan.store.objects.empty() ? "" : word_of(file.kept);
    if (!kept.empty()) json.field("kept", kept);
    write_parts(json, file.parts);
    json.end_object();
  }
  json.end_array().end_object();
  return json.text() + "\n";
}

}  // namespace ros2wasm
