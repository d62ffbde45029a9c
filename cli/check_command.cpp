// `ros2wasm check [MANIFEST]`: reads a manifest and says all that is wrong with it; with --json
// prints it as data.
#include <memory>

#include "bundler/io/files.hpp"
#include "bundler/workspace/discovery.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "workspace_schema/json_writer.hpp"
#include "workspace_schema/manifest_json.hpp"
#include "workspace_schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {

struct Options {
  std::string manifest = "workspace.yaml";
};

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

int check(Context& context, const Options& options) {
  std::filesystem::path path = options.manifest;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) path /= "workspace.yaml";
  if (!std::filesystem::exists(path, ignored)) {
    return context.console.fail(
        Diagnostic{.code = "R2W0115",
                   .message = "there is no manifest `" + path.generic_string() + "`",
                   .why = {"`ros2wasm check` reads a workspace.yaml, here or where it is told"}});
  }
  const Outcome<std::string> text = read_file(path);
  if (!text) return context.console.fail(text.errors());
  const Outcome<Manifest> manifest = read_manifest(*text, path.generic_string());
  if (!manifest) return context.console.fail(manifest.errors());
  for (const Diagnostic& doubt : manifest->warnings) context.console.report(doubt);
  const std::filesystem::path shown_folder = path.parent_path();
  const auto packages =
      discover_packages(std::filesystem::absolute(path).parent_path(), shown_folder,
                        manifest->packages, ros_condition_variables(manifest->distro));
  if (!packages) return context.console.fail(packages.errors());
  if (context.json) {
    context.console.result(manifest_json(*manifest));
    return 0;
  }
  const std::string runs = manifest->launch_file ? "launch file " + manifest->launch_file->value
                                                 : counted(manifest->nodes.size(), "node");
  context.console.result(path.generic_string() + ": good (schema " +
                         std::to_string(manifest->schema) + ", " + manifest->distro + ", " +
                         counted(packages->size(), "local package") + ", " + runs + ")");
  return 0;
}

}  // namespace

CommandBody check_command(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.optional("MANIFEST", options->manifest,
                     "a workspace.yaml, or the folder that holds it; here by default");
  arguments.examples({"ros2wasm check", "ros2wasm check course/lab1/workspace.yaml",
                      "ros2wasm check --json lab1 | jq .launch"});
  return [options](Context& context) { return check(context, *options); };
}

}  // namespace ros2wasm
