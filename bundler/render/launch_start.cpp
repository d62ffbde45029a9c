// See launch_start.hpp.
#include "bundler/render/launch_start.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "bundler/launch/given_arguments.hpp"
#include "bundler/launch/launch_evaluation.hpp"
#include "bundler/launch/launch_file_nodes.hpp"
#include "bundler/launch/launch_paths.hpp"
#include "bundler/launch/launch_tree.hpp"
#include "bundler/launch/packed_launch.hpp"
#include "bundler/render/site_node_json.hpp"
#include "bundler/render/site_plan.hpp"
#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kQuestion = "the launch file of the site";

using Texts = std::map<std::string, std::string>;

Texts texts_of(const JsonValue* json) {
  Texts result;
  if (json == nullptr) return result;
  for (const auto& [name, value] : json->members())
    if (const std::string* text = value.string()) result[name] = *text;
  return result;
}

std::vector<std::string> list_of(const JsonValue* json) {
  std::vector<std::string> result;
  if (json == nullptr) return result;
  for (const JsonValue& item : json->items())
    if (const std::string* text = item.string()) result.push_back(*text);
  return result;
}

bool is_true(const JsonValue& json, std::string_view key) {
  const JsonValue* value = json.find(key);
  return value != nullptr && value->boolean().value_or(false);
}

std::uint32_t count_of(const JsonValue& json, std::string_view key) {
  const JsonValue* value = json.find(key);
  return value == nullptr ? 0 : static_cast<std::uint32_t>(value->integer().value_or(0));
}

/// A launch file, and the programs of its packages by their place below the prefix: those with a
/// `program` are in the site.
struct Start {
  PackedLaunch launch;
  std::map<fs::path, PlannedNode> programs;
};

ProgramKind kind_of(const std::string& name) {
  return name == "cpp"      ? ProgramKind::kWasm
         : name == "python" ? ProgramKind::kPython
                            : ProgramKind::kNone;
}

InstalledProgram read_program(const JsonValue& json, const std::string& package, Start& start) {
  InstalledProgram result{.package = package,
                          .executable = json.text_of("executable"),
                          .file = fs::path("lib") / package / json.text_of("file"),
                          .kind = kind_of(json.text_of("kind")),
                          .left_out = json.text_of("left_out")};
  start.programs[result.file] = {.node = {},
                                 .program = json.text_of("program"),
                                 .names = json.text_of("names"),
                                 .threads = is_true(json, "threads"),
                                 .script = json.text_of("script"),
                                 .archives = list_of(json.find("archives"))};
  return result;
}

Start read_start(const JsonValue& json) {
  Start start{.launch = {.file = json.text_of("file"),
                         .from = {},
                         .given = texts_of(json.find("given")),
                         .variables = texts_of(json.find("variables")),
                         .distro = json.text_of("distro"),
                         .installed = {},
                         .left_out = {},
                         .texts = texts_of(json.find("texts")),
                         .python = read_python_exchanges(json.find("python")),
                         .arguments = {},
                         .tried = {},
                         .modules = {}},
              .programs = {}};
  if (const JsonValue* from = json.find("from")) {
    start.launch.from.file = from->text_of("file");
    start.launch.from.line = count_of(*from, "line");
    start.launch.from.column = count_of(*from, "column");
  }
  if (const JsonValue* left_out = json.find("left_out"))
    for (const auto& [name, chain] : left_out->members())
      start.launch.left_out[name] = list_of(&chain);
  if (const JsonValue* packages = json.find("packages")) {
    for (const JsonValue& one : packages->items()) {
      InstalledPackage package{.name = one.text_of("name"),
                               .version = one.text_of("version"),
                               .prefix = {},
                               .programs = {}};
      if (const JsonValue* programs = one.find("programs"))
        for (const JsonValue& program : programs->items())
          package.programs.push_back(read_program(program, package.name, start));
      start.launch.installed.push_back(std::move(package));
    }
  }
  return start;
}

/// The files of a site, of which some are fetched when they are asked for.
class SiteFiles {
 public:
  SiteFiles(const PackedLaunch& launch, const JsonValue& question, const LaunchPlace& place)
      : prefix_(launch_prefix(launch.distro)), texts_(launch.texts), file_(place.file) {
    for (const std::string& path : list_of(question.find("shared")))
      shared_.insert(prefix_ + "/" + path);
    for (auto& [path, text] : texts_of(question.find("files")))
      texts_[prefix_ + "/" + path] = std::move(text);
    for (const InstalledPackage& one : launch.installed) packages_.insert(one.name);
  }

  Outcome<std::string> read(const std::string& path) {
    const std::string normal = fs::path(path).lexically_normal().generic_string();
    if (const auto text = texts_.find(normal); text != texts_.end()) return text->second;
    if (shared_.contains(normal)) {
      const std::string below = normal.substr(prefix_.size() + 1);
      if (file_) {
        if (auto text = file_(below)) return texts_[normal] = std::move(*text);
        return unreadable_launch_path(path, "it cannot be had");
      }
      needs_.insert(below);
      return unreadable_launch_path(path, "it is not fetched yet");
    }
    const std::string share = prefix_ + "/share/";
    const bool is_ours = normal.starts_with(std::string(kLaunchWorkspace) + "/") ||
                         (normal.starts_with(share) &&
                          packages_.contains(normal.substr(
                              share.size(), normal.find('/', share.size()) - share.size())));
    if (is_ours) return unreadable_launch_path(path, kNoSuchLaunchFile);
    return no_launch_path(path, prefix_);
  }

  [[nodiscard]] std::vector<std::string> names_in(const std::string& folder) const {
    std::set<std::string> names;
    const auto add = [&](const std::string& path) {
      const fs::path below = fs::path(path).lexically_relative(fs::path(folder).lexically_normal());
      if (!below.empty() && *below.begin() != ".." && *below.begin() != ".")
        names.insert(below.begin()->string());
    };
    for (const auto& [path, text] : texts_) add(path);
    for (const std::string& path : shared_) add(path);
    return {names.begin(), names.end()};
  }

  [[nodiscard]] std::optional<std::string> prefix_of(const std::string& package) const {
    return packages_.contains(package) ? std::optional(prefix_) : std::nullopt;
  }

  [[nodiscard]] const std::string& prefix() const { return prefix_; }
  [[nodiscard]] const std::set<std::string>& needs() const { return needs_; }

 private:
  std::string prefix_;
  Texts texts_;
  std::function<std::optional<std::string>(const std::string&)> file_;
  std::set<std::string> shared_;
  std::set<std::string> packages_;
  std::set<std::string> needs_;
};

LaunchWorld world_of(SiteFiles& files, const std::string& distro) {
  LaunchWorld world;
  world.environment = launch_environment(distro);
  world.read = [&files](const std::string& path) { return files.read(path); };
  world.prefix_of = [&files](const std::string& package) { return files.prefix_of(package); };
  world.names_in = [&files](const std::string& folder) { return files.names_in(folder); };
  world.shown = [&files](const std::string& path) {
    return shown_launch_path(path, files.prefix());
  };
  return world;
}

void write_list(JsonWriter& json, const char* key, const std::vector<std::string>& texts) {
  json.key(key).begin_array();
  for (const std::string& one : texts) json.string(one);
  json.end_array();
}

void write_findings(JsonWriter& json, const char* key, const Diagnostics& findings) {
  json.key(key).begin_array();
  for (const Diagnostic& one : findings) {
    json.begin_object().field("code", one.code).field("message", one.message);
    if (one.span && !one.span->file.empty()) {
      json.key("source").begin_object().field("file", one.span->file);
      json.field_integer("line", one.span->line).field_integer("column", one.span->column);
      json.end_object();
    }
    write_list(json, "why", one.why);
    write_list(json, "fix", one.fix);
    json.end_object();
  }
  json.end_array();
}

std::string refused(const Diagnostics& errors, bool decided = false) {
  JsonWriter json;
  json.begin_object();
  write_findings(json, "errors", errors);
  return json.field_boolean("decided", decided).end_object().text();
}

/// As the command line and the address say them.
Diagnostics undeclared(const Texts& given, const std::vector<LaunchArgument>& declared) {
  std::vector<GivenArgument> all;
  for (const auto& [name, value] : given)
    all.push_back({.name = {.value = name, .span = {}}, .value = value});
  Diagnostics errors = undeclared_arguments(
      all, declared,
      [](const std::string& name, const std::string& value) { return name + ":=" + value; });
  for (Diagnostic& one : errors) one.kind = FailureKind::kCommandLine;
  return errors;
}

/// The nodes with the programs of the site.
Outcome<std::vector<PlannedNode>> planned(std::vector<LaunchNode> nodes, const Start& start) {
  std::vector<PlannedNode> result;
  Diagnostics errors;
  for (LaunchNode& node : nodes) {
    if (node.kind == ProgramKind::kCommand) {
      result.emplace_back().node = std::move(node);
      continue;
    }
    const auto known = start.programs.find(node.program);
    PlannedNode one = known == start.programs.end() ? PlannedNode() : known->second;
    if (one.program.empty()) {
      errors.push_back(
          {.code = "R2W0731",
           .message = "the program `" + node.executable + "` of package `" + node.package +
                      "` is not in this site",
           .span = node.source,
           .why = {"a site has the programs that its launch file starts with the arguments' "
                   "defaults, choices, and true or false"},
           .fix = {"list the value as a choice of its argument, and pack again"}});
      continue;
    }
    one.node = std::move(node);
    result.push_back(std::move(one));
  }
  if (!errors.empty()) return errors;
  return result;
}

}  // namespace

std::string evaluate_packed_launch(std::string_view text, const LaunchPlace& place) {
  const auto question = parse_json(text, kQuestion, "R2W0700");
  if (!question) return refused(question.errors());
  const JsonValue* data = question->find("launch");
  const Start start = read_start(data == nullptr ? JsonValue() : *data);
  const PackedLaunch& launch = start.launch;
  const Texts own = texts_of(question->find("given"));
  Texts given = launch.given;
  for (const auto& [name, value] : own) given[name] = value;

  SiteFiles files(launch, *question, place);
  PythonRecord record(launch.python);
  bool decided = false;
  LaunchWorld world = world_of(files, launch.distro);
  world.variables = launch.variables;
  world.python = place.python ? place.python : record.replaying([&] { decided = true; });
  const auto needed = [&] {
    JsonWriter json;
    json.begin_object();
    write_list(json, "needs", {files.needs().begin(), files.needs().end()});
    return json.end_object().text();
  };
  if (is_true(*question, "describe")) {
    const auto description = evaluate_launch(launch.file, given, world);
    if (!files.needs().empty()) return needed();
    if (!description) return refused(description.errors(), decided);
    return "{\"description\":" + launch_json(*description) + "}";
  }
  auto launched =
      launch_file_nodes(launch.file, given, world, launch.installed, launch.from, launch.left_out);
  if (!files.needs().empty()) return needed();
  if (!launched) return refused(launched.errors(), decided);
  if (const Diagnostics errors = undeclared(own, launched->arguments); !errors.empty())
    return refused(errors, decided);
  const auto nodes = planned(std::move(launched->nodes), start);
  if (!nodes) return refused(nodes.errors(), decided);

  JsonWriter json;
  json.begin_object().key("nodes").begin_array();
  for (const PlannedNode& node : *nodes) write_site_node(json, node);
  json.end_array();
  write_launch_steps(json, launched->steps);
  json.key("arguments").begin_array();
  for (const LaunchArgument& one : launched->arguments) write_launch_argument(json, one);
  json.end_array();
  write_findings(json, "warnings", launched->warnings);
  write_list(json, "remarks", launched->remarks);
  return json.field_boolean("decided", decided).end_object().text();
}

}  // namespace ros2wasm
