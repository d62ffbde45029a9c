// `ros2wasm build [WORKSPACE]`: compiles the packages and stops before the site.
#include <cmath>
#include <memory>

#include "bundler/pipeline.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string input;
  bool locked = false;
  int jobs = 0;
  bool quick = false;
  bool plan = false;
};

std::string about(double seconds) {
  if (seconds < 1) return "a second";
  if (seconds < 90) return std::to_string(std::lround(seconds)) + " s";
  return std::to_string(std::lround(seconds / 60)) + " min";
}

/// The packages that are not in the cache, where they come from, and how long they take.
void print_plan(Context& context, const std::vector<PlannedBuild>& planned) {
  JsonWriter json;
  json.begin_array();
  double all = 0;
  std::size_t count = 0;
  for (const PlannedBuild& one : planned) {
    json.begin_object().field("package", one.name).field("version", one.version);
    if (!one.origin.empty()) json.field("source", one.origin);
    json.field_boolean("cached", one.is_cached).key("seconds").number(one.seconds).end_object();
    if (one.is_cached) continue;
    all += one.seconds;
    ++count;
    if (!context.json)
      context.console.result(one.name + " " + one.version + "  about " + about(one.seconds) +
                             (one.origin.empty() ? "" : "  " + one.origin));
  }
  json.end_array();
  if (context.json) context.console.result(json.text());
  context.console.remark(
      count == 0 ? "nothing to build: " + std::to_string(planned.size()) + " packages are cached"
                 : "to build: " + std::to_string(count) + " of " + std::to_string(planned.size()) +
                       " packages, about " + about(all) + " one after the other");
}

int run(Context& context, const Options& options) {
  const auto workspace = build({.input = options.input,
                                .output = {},
                                .locked = options.locked,
                                .plan_builds = options.plan,
                                .executable = context.executable,
                                .variables = context.environment,
                                .jobs = static_cast<unsigned>(options.jobs),
                                .quick = options.quick},
                               context.cancellation, context.progress);
  if (!workspace) return context.console.fail(workspace.errors());
  for (const Diagnostic& warning : workspace->notes.warnings) context.console.report(warning);
  for (const std::string& remark : workspace->notes.remarks) context.console.remark(remark);
  if (options.plan) {
    print_plan(context, workspace->built.planned);
    return 0;
  }
  JsonWriter json;
  json.begin_array();
  for (const BuiltPackage& package : workspace->built.packages) {
    json.begin_object().field("package", package.name).field("prefix", package.prefix.string());
    json.field_boolean("from_cache", package.from_cache).end_object();
    if (!context.json) context.console.result(package.name + "  " + package.prefix.string());
  }
  json.end_array();
  if (context.json) context.console.result(json.text());
  return 0;
}

}  // namespace

CommandBody build_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.optional(
      "WORKSPACE", options->input,
      "a workspace.yaml, or a folder with ROS 2 packages (default: the current folder)");
  arguments.flag("--locked", options->locked, "fail rather than change ros2wasm.lock");
  arguments.flag("--plan", options->plan,
                 "build nothing: say which packages are not in the cache, and how long they take");
  arguments.flag("--quick", options->quick,
                 "link in a fraction of the time, without wasm-opt: larger programs");
  arguments.number("-j,--jobs", options->jobs, "N", 1, 256,
                   "compilers at once (default: one per processor)");
  arguments.examples({"ros2wasm build ~/ros2_ws", "ros2wasm build ~/ros2_ws --plan"});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
