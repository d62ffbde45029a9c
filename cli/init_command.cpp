// `ros2wasm init`: a workspace.yaml for a colcon workspace, or a new workspace to begin with.
#include <algorithm>
#include <iterator>
#include <memory>

#include "bundler/io/installation.hpp"
#include "bundler/workspace/manifest_init.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string kind;
  std::string folder;
  std::optional<std::string> from;
  std::optional<std::string> environment;
  std::optional<std::string> output;
  std::optional<std::string> ci;
};

/// Files of templates/ci, and where a repository has them.
struct Workflow {
  const char* host;
  const char* place;
};
constexpr Workflow kWorkflows[] = {
    {"github", ".github/workflows/ros2wasm.yml"},
    {"gitlab", ".gitlab-ci.yml"},
};

/// Folders of templates/workspaces.
struct Template {
  const char* name;
  const char* what;
};
constexpr Template kTemplates[] = {
    {"cpp", "a talker and a listener in C++"},
    {"python", "the same in Python"},
    {"mixed", "a message of one's own, a sensor in C++ and a monitor in Python"},
    {"course", "a lab with the turtle simulator"},
    {"sim", "a robot with a lidar in Gazebo Sim"},
    {"paper", "an experiment with its numbers, its seed and how to cite it"},
};

bool is_template(const std::string& name) {
  return std::any_of(std::begin(kTemplates), std::end(kTemplates),
                     [&](const Template& one) { return one.name == name; });
}

std::string template_names() {
  std::vector<std::string> names;
  for (const Template& one : kTemplates) names.emplace_back(one.name);
  return name_list(names);
}

std::string template_help() {
  std::string text;
  for (const Template& one : kTemplates)
    text += (text.empty() ? "" : "; ") + std::string(one.name) + ": " + one.what;
  return text;
}

Diagnostic wrong_use(std::string message) {
  return Diagnostic{.code = "R2W0902",
                    .kind = FailureKind::kCommandLine,
                    .message = std::move(message),
                    .why = {"`ros2wasm init --help` says what it takes"},
                    .fix = {"ros2wasm init cpp my_workspace", "ros2wasm init --from ~/ros2_ws"}};
}

Outcome<InitReport> init_ci(const Context& context, const Options& options) {
  if (options.from || options.output || options.environment)
    return wrong_use("`--ci` goes without `--from` and its options");
  if (!options.folder.empty()) return wrong_use("`--ci` takes one folder, that of the repository");
  std::vector<std::string> hosts;
  for (const Workflow& workflow : kWorkflows) {
    hosts.emplace_back(workflow.host);
    if (*options.ci != workflow.host) continue;
    const auto source =
        find_own_data(context.executable, "templates/ci/" + *options.ci + ".yml", "the workflow");
    if (!source) return source.errors();
    return init_workflow(*source, options.kind.empty() ? "." : options.kind, workflow.place);
  }
  return wrong_use("there is no workflow for `" + *options.ci + "`; there are those for " +
                   name_list(hosts));
}

Outcome<InitReport> init(const Context& context, const Options& options) {
  if (options.ci) return init_ci(context, options);
  if (options.from) {
    if (!options.kind.empty()) return wrong_use("`--from` goes without a template");
    const std::filesystem::path workspace = *options.from;
    std::error_code error;
    if (std::filesystem::is_regular_file(workspace, error))
      return init_from_environment(workspace, options.output.value_or(""),
                                   options.environment.value_or(""));
    return init_from_workspace(workspace, options.output ? std::filesystem::path(*options.output)
                                                         : workspace / "workspace.yaml");
  }
  if (options.kind.empty()) return wrong_use("what to begin with is missing");
  if (!is_template(options.kind))
    return wrong_use("there is no template `" + options.kind + "`; there are " + template_names());
  if (options.output) return wrong_use("`--output` goes with `--from` only");
  if (options.folder.empty()) return wrong_use("the folder of the new workspace is missing");
  const auto source = find_own_data(context.executable, "templates/workspaces/" + options.kind,
                                    "the template of new workspaces");
  if (!source) return source.errors();
  return init_from_template(*source, options.folder);
}

int run(Context& context, const Options& options) {
  const auto report = init(context, options);
  if (!report) return context.console.fail(report.errors());
  for (const std::string& remark : report->remarks) context.console.remark(remark);
  if (context.json) {
    JsonWriter json;
    json.begin_object().key("written").begin_array();
    for (const auto& path : report->written) json.string(path.string());
    json.end_array().end_object();
    context.console.result(json.text());
    return 0;
  }
  for (const auto& path : report->written) context.console.result(path.string());
  if (options.ci) {
    context.console.remark("Next: read its first lines, which say what to set, and commit it");
    return 0;
  }
  const std::string next = options.from ? report->written.front().string() : options.folder;
  context.console.remark("Next: ros2wasm pack " + next);
  return 0;
}

}  // namespace

CommandBody init_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.optional("TEMPLATE", options->kind, template_help());
  arguments.optional("FOLDER", options->folder, "where to write the template");
  arguments.value("--from", options->from, "FOLDER|FILE",
                  "write a workspace.yaml for the colcon workspace in this folder, or one that "
                  "begins with an environment.yml, pixi.toml, pixi.lock or conda-lock file");
  arguments.value("--environment", options->environment, "NAME",
                  "with --from pixi.lock: which of its environments");
  arguments.value("-o,--output", options->output, "FILE",
                  "with --from: where to write it [workspace.yaml in the folder]");
  arguments.value("--ci", options->ci, "HOST",
                  "github, gitlab: write a workflow that packs on every push, plays the checks, "
                  "keeps the site and publishes it, into the current folder or the one named");
  arguments.examples({"ros2wasm init --ci github", "ros2wasm init --ci gitlab my_repository",
                      "ros2wasm init cpp my_workspace", "ros2wasm init course lab_1",
                      "ros2wasm init --from ~/ros2_ws",
                      "ros2wasm init --from pixi.lock --environment wasm"});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
