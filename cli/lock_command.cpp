// `ros2wasm lock`: writes or checks ros2wasm.lock without building anything.
#include <algorithm>
#include <memory>

#include "bundler/pipeline.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

struct LockOptions {
  std::string input;
  bool check = false;
  bool offline = false;
  std::vector<std::string> update;
};

/// `--update` without a name means every package.
LockUpdate update_of(const LockOptions& options) {
  const bool everything =
      std::find(options.update.begin(), options.update.end(), "") != options.update.end();
  return {.everything = everything, .names = options.update};
}

int run(Context& context, const LockOptions& options) {
  const auto report = lock({.input = options.input,
                            .check_only = options.check,
                            .update = update_of(options),
                            .offline = options.offline,
                            .executable = context.executable,
                            .variables = context.environment},
                           context.cancellation, context.progress);
  if (!report) return context.console.fail(report.errors());
  for (const Diagnostic& warning : report->warnings) context.console.report(warning);
  if (context.json) {
    JsonWriter json;
    json.begin_object().field("lock", report->file.string());
    json.field_boolean("changed", report->changed).key("packages").begin_array();
    for (const PackageRecord& record : report->packages) {
      json.begin_object().field("name", record.name).field("version", record.version);
      json.field("build", record.build).field("url", record.url).end_object();
    }
    json.end_array().end_object();
    context.console.result(json.text());
  } else {
    const std::string count = std::to_string(report->packages.size()) + " packages";
    context.console.remark(report->changed ? "wrote " + count : "nothing to change: " + count);
    context.console.result(report->file.string());
  }
  return 0;
}

}  // namespace

CommandBody lock_command(Arguments& arguments) {
  const auto options = std::make_shared<LockOptions>();
  arguments.optional(
      "WORKSPACE", options->input,
      "a workspace.yaml, or a folder with ROS 2 packages (default: the current folder)");
  arguments.flag(
      "--check", options->check,
      "write nothing and ask no channel; fail when the lock does not fulfil what is asked");
  arguments.flag("--offline", options->offline, "use only what is on this machine");
  arguments.values_if_any(
      "--update", options->update, "NAME",
      "choose this package again, from the channels; without a name, all; may be given again");
  arguments.examples({"ros2wasm lock", "ros2wasm lock --update ros-jazzy-rclcpp",
                      "ros2wasm lock --check examples/01_talker_listener"});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
