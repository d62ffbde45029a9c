// `ros2wasm build [WORKSPACE]`: compiles the packages and stops before the site.
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
};

int run(Context& context, const Options& options) {
  const auto workspace = build({.input = options.input,
                                .output = {},
                                .locked = options.locked,
                                .executable = context.executable,
                                .variables = context.environment,
                                .jobs = static_cast<unsigned>(options.jobs),
                                .quick = options.quick},
                               context.cancellation, context.progress);
  if (!workspace) return context.console.fail(workspace.errors());
  for (const Diagnostic& warning : workspace->warnings) context.console.report(warning);
  for (const std::string& remark : workspace->remarks) context.console.remark(remark);
  JsonWriter json;
  json.begin_array();
  for (const BuiltPackage& package : workspace->packages) {
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
  arguments.flag("--quick", options->quick,
                 "link in a fraction of the time, without wasm-opt: larger programs");
  arguments.number("-j,--jobs", options->jobs, "N", 1, 256,
                   "compilers at once (default: one per processor)");
  arguments.examples({"ros2wasm build ~/ros2_ws"});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
