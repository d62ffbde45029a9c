// `ros2wasm check [MANIFEST]`: says all that a pack would refuse, as far as it shows without a
// compiler; with --json prints the manifest as data.
#include <filesystem>
#include <memory>

#include "bundler/io/files.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/workspace_check.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/schema/manifest_json.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string manifest = "workspace.yaml";
  bool strict = false;
};

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

int check(Context& context, const Options& options) {
  std::filesystem::path path = options.manifest;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) path /= "workspace.yaml";
  if (is_absent(path)) {
    return context.console.fail(Diagnostic{
        .code = "R2W0115",
        .message = "the manifest `" + path.generic_string() + "` does not exist",
        .why = {"`ros2wasm check` reads a workspace.yaml, in this folder or at the given path"}});
  }
  const auto report = check_workspace(
      {.manifest = path, .executable = context.executable, .variables = context.environment},
      context.cancellation);
  if (!report) return context.console.fail(report.errors());
  for (const Diagnostic& doubt : report->warnings)
    if (!options.strict || doubt.code != "R2W0415") context.console.report(doubt);
  if (const Diagnostics refused = refused_when_strict(report->warnings);
      options.strict && !refused.empty())
    return context.console.fail(refused);
  const Manifest& manifest = report->manifest;
  if (context.json) {
    context.console.result(manifest_json(manifest));
    return 0;
  }
  context.console.result(path.generic_string() + ": good (schema " +
                         std::to_string(manifest.schema) + ", " + manifest.distro + ", " +
                         counted(report->packages.size(), "local package") + ", " +
                         counted(manifest.nodes.size() + report->launched.size(), "node") + ")");
  return 0;
}

}  // namespace

CommandBody check_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.optional("MANIFEST", options->manifest,
                     "a workspace.yaml, or the folder that holds it; here by default");
  arguments.flag("--strict", options->strict,
                 "fail when the launch file starts what no site can start");
  arguments.examples({"ros2wasm check", "ros2wasm check course/lab1/workspace.yaml",
                      "ros2wasm check --json lab1 | jq .launch"});
  return [options](Context& context) { return check(context, *options); };
}

}  // namespace ros2wasm
