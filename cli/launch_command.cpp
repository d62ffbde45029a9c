// `ros2wasm launch FILE [NAME:=VALUE ...]`: what a launch file comes to, without building anything.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bundler/io/files.hpp"
#include "bundler/launch/host/launch_world.hpp"
#include "bundler/launch/launch_evaluation.hpp"
#include "bundler/launch/launch_tree.hpp"
#include "bundler/launch/simulator_command.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/launch_from_file.hpp"
#include "bundler/launch_tools.hpp"
#include "bundler/render/packed_launch_json.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/workspace_channels.hpp"
#include "bundler/workspace_sources.hpp"
#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/launch_arguments.hpp"
#include "workspace_schema/schema/manifest.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

struct LaunchOptions {
  std::string file;
  std::vector<std::string> given;
  std::string workspace = ".";
  bool strict = false;
  bool print = false;      ///< as is done anyway
  bool site_data = false;  ///< launch.json instead
};

Diagnostic refused(std::string message, std::vector<std::string> why) {
  return {.code = "R2W0902",
          .kind = FailureKind::kCommandLine,
          .message = std::move(message),
          .why = std::move(why)};
}

/// The manifest of the folder, for its distro; without one, what manifests have by default.
Outcome<Manifest> manifest_of(const fs::path& folder, const fs::path& shown) {
  if (is_absent(folder / "workspace.yaml")) return Manifest{};
  const auto text = read_file(folder / "workspace.yaml", kMostOfText);
  if (!text) return text.errors();
  return read_manifest(*text, (shown / "workspace.yaml").lexically_normal().generic_string());
}

/// The packages of the folder; one that has none is not a fault here.
Outcome<std::vector<LocalPackage>> packages_of(const fs::path& folder, const fs::path& shown,
                                               const Manifest& manifest) {
  auto packages =
      discover_packages(folder, shown, manifest.packages, ros_condition_variables(manifest.distro));
  if (packages) {
    if (Diagnostics twice = duplicate_names(*packages); !twice.empty()) return twice;
    return packages;
  }
  if (packages.errors().front().code != "R2W0510") return packages;
  return std::vector<LocalPackage>();
}

/// As they are on this machine.
Outcome<Done> add_sources(Context& context, Manifest& manifest, const fs::path& folder,
                          const fs::path& shown, std::vector<LocalPackage>& packages) {
  if (manifest.sources.empty()) return Done{};
  auto channels = workspace_channels(manifest, folder, context.executable, context.environment);
  if (!channels) return std::move(channels).errors();
  channels->roots.network.offline = true;
  const auto limits = extract_limits_of("", context.environment);
  if (!limits) return limits.errors();
  auto sources = add_source_packages(manifest, {.folder = folder, .shown_folder = shown},
                                     channels->roots, *limits, packages, context.cancellation, {});
  if (!sources) return std::move(sources).errors();
  return Done{};
}

int run(Context& context, const LaunchOptions& options) {
  const auto given = launch_arguments_of(options.given);
  if (!given) return context.console.fail(given.errors());
  const auto workspace = real_path(options.workspace);
  if (!workspace) return context.console.fail(workspace.errors());
  const auto file = real_path(options.file);
  if (!file) return context.console.fail(file.errors());
  const fs::path& folder = *workspace;
  const fs::path inside = file->lexically_relative(folder);
  if (inside.empty() || *inside.begin() == "..")
    return context.console.fail(
        {refused("`" + options.file + "` is not in the workspace `" + options.workspace + "`",
                 {"name its folder with --workspace"})});
  auto manifest = manifest_of(folder, options.workspace);
  if (!manifest) return context.console.fail(manifest.errors());
  if (manifest->packages.empty()) manifest->packages.push_back({".", {}});
  auto packages = packages_of(folder, options.workspace, *manifest);
  if (!packages) return context.console.fail(packages.errors());
  if (const auto added = add_sources(context, *manifest, folder, options.workspace, *packages);
      !added)
    return context.console.fail(added.errors());
  const auto folders = source_launch_folders(folder, *packages, manifest->distro);
  LaunchWorld world = launch_world(folders, manifest->distro, false);
  world.variables = manifest->launch_variables;
  const std::string path = std::string(kLaunchWorkspace) + "/" + inside.generic_string();
  const LaunchInterpreter interpreter = launch_interpreter({.executable = context.executable,
                                                            .variables = context.environment,
                                                            .environment = {},
                                                            .folders = folders,
                                                            .file = path,
                                                            .given = *given},
                                                           context.cancellation);
  world.python = interpreter.python;
  if (options.site_data) {
    std::vector<InstalledPackage> installed;
    for (const LocalPackage& one : *packages)
      installed.push_back(
          {.name = one.xml.name.value, .version = {}, .prefix = {}, .programs = {}});
    const auto packed = packed_launch(path, *given, world, installed, manifest->distro);
    if (!packed) return context.console.fail(packed.errors());
    interpreter.keep();
    context.console.result_text(packed_launch_json(*packed, {}));
    return 0;
  }
  const auto description = evaluate_launch(path, *given, world);
  if (!description) return context.console.fail(description.errors());
  interpreter.keep();
  const auto is_known = [&](const std::string& package) {
    return is_simulator_package(package) ||
           std::any_of(packages->begin(), packages->end(),
                       [&](const LocalPackage& one) { return one.xml.name.value == package; });
  };
  const Diagnostics left_out = left_out_of_site(*description, is_known, world);
  if (options.strict && !left_out.empty())
    return context.console.fail(refused_when_strict(left_out));
  for (const Diagnostic& warning : description->warnings) context.console.report(warning);
  // The others are in the tree.
  for (std::size_t i = description->left_out.size(); i < left_out.size(); ++i)
    context.console.report(left_out[i]);
  if (context.json) {
    context.console.result(launch_json(*description));
  } else {
    for (const std::string& line : launch_tree(*description)) context.console.result(line);
  }
  return 0;
}

}  // namespace

CommandBody launch_command(Arguments& arguments) {
  const auto options = std::make_shared<LaunchOptions>();
  arguments.required("FILE", options->file, "a launch file in XML, YAML or Python");
  arguments.rest("NAME:=VALUE", options->given, "launch arguments");
  arguments.value("-w,--workspace", options->workspace, "FOLDER",
                  "the folder with the workspace's packages [the current one]");
  arguments.flag("--strict", options->strict, "fail when it starts what no site can start");
  arguments.flag("--print", options->print, "show it as a tree, as is done anyway");
  arguments.flag("--site-data", options->site_data,
                 "print what a site has of it, for its start: launch.json, without programs");
  arguments.examples({"ros2wasm launch src/demo/launch/bringup.launch.xml",
                      "ros2wasm launch bringup.launch.yaml robot:=r2 --json"});
  return [options](Context& context) { return run(context, *options); };
}

}  // namespace ros2wasm
