// See launch_step.hpp.
#include "bundler/launch_from_file.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "bundler/io/files.hpp"
#include "bundler/launch/given_arguments.hpp"
#include "bundler/launch/host/argument_choices.hpp"
#include "bundler/launch/host/launch_world.hpp"
#include "bundler/launch/launch_evaluation.hpp"
#include "bundler/launch/launch_file_nodes.hpp"
#include "bundler/launch/launch_paths.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/launch_tools.hpp"
#include "bundler/workspace/environment_hooks.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/text_encoding.hpp"
#include "workspace_schema/schema/package_xml.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostTrials = 31;  // besides the one with the packed values
/// The limits in bytes for texts of the workspace that a site gets: for each one, and for all
/// together.
constexpr std::size_t kLargestText = 256U << 10U;
constexpr std::size_t kMostText = 4U << 20U;
/// The endings of files that launch files and descriptions use.
constexpr std::string_view kEndings[] = {".json", ".launch", ".sdf", ".srdf", ".txt",
                                         ".urdf", ".xacro",  ".xml", ".yaml", ".yml"};

using Texts = std::map<std::string, std::string>;
std::string written(const Texts& given) {
  std::vector<std::string> words;
  for (const auto& [name, value] : given) words.push_back(name + ":=" + value);
  return name_list(words, words.size());
}

bool is_in_workspace(const std::string& path) {
  return path.starts_with(std::string(kLaunchWorkspace) + "/");
}

/// Records the files that an evaluation reads.
class Reading {
 public:
  LaunchWorld seen_through(LaunchWorld world) {
    world.read = [this, read = world.read](const std::string& path) {
      auto text = read(path);
      const std::string normal = fs::path(path).lexically_normal().generic_string();
      if (text && is_in_workspace(normal)) texts_[normal] = *text;
      return text;
    };
    return world;
  }

  /// Reads what Python read, which sites need that run it anew: of the workspace, and text.
  void add_python(const LaunchWorld& world, const SeenPaths& seen) {
    endings_.push_back(".launch.py");
    for (const auto& [path, state] : seen) {
      // Opened, "file SIZE SHA256": whoever lists a folder looks at all that is in it.
      const bool was_opened = state.starts_with("file ") && state.find(' ', 5) != std::string::npos;
      if (!was_opened || !is_in_workspace(path) || texts_.contains(path)) continue;
      auto text = world.read(path);
      if (text && !first_invalid_utf8(*text)) of_python_.emplace(path, std::move(*text));
    }
  }

  /// The texts that were read in the workspace, and those beside them: an argument may name one
  /// when the site starts. `left_out`: texts that exceed the limits.
  [[nodiscard]] Texts texts(const LaunchWorld& world, std::vector<std::string>& left_out) const {
    Texts result = texts_;
    std::set<std::string> folders;
    std::size_t size = 0;
    for (const auto& [path, text] : texts_) {
      folders.insert(path.substr(0, path.rfind('/')));
      size += text.size();
    }
    const auto add = [&](const std::string& path, std::string text) {
      if (text.size() > kLargestText || size + text.size() > kMostText) {
        left_out.push_back(world.shown_path(path));
        return;
      }
      size += text.size();
      result.emplace(path, std::move(text));
    };
    for (const auto& [path, text] : of_python_) add(path, text);
    for (const std::string& folder : folders) {
      // Do not take other files from the root of a workspace: they may be private, such as reports,
      // notes or keys.
      if (folder == kLaunchWorkspace) continue;
      for (const std::string& name : world.names_in(folder)) {
        const std::string path = folder + "/" + name;
        const bool is_meant =
            std::any_of(endings_.begin(), endings_.end(),
                        [&](std::string_view one) { return name.ends_with(one); });
        if (!is_meant || result.contains(path)) continue;
        auto text = world.read(path);
        if (text) add(path, std::move(*text));
      }
    }
    return result;
  }

 private:
  Texts texts_;
  Texts of_python_;
  std::vector<std::string_view> endings_{std::begin(kEndings), std::end(kEndings)};
};

bool runs_python(const std::vector<LaunchNode>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const LaunchNode& node) { return node.kind == ProgramKind::kPython; });
}

Diagnostic not_with(const Texts& given, const SourceSpan& span, const Diagnostics& errors) {
  Diagnostic warning{.code = "R2W0440",
                     .severity = Severity::kWarning,
                     .message = "the launch file fails with " + written(given),
                     .span = errors.front().span ? errors.front().span : span,
                     .why = {errors.front().message}};
  const std::vector<std::string>& more = errors.front().why;
  warning.why.insert(warning.why.end(), more.begin(), more.end());
  return warning;
}

/// The package of the workspace in whose folder the file lies; empty: none.
std::string package_around(const ReadWorkspace& workspace, const std::string& file) {
  fs::path below = fs::path(file).lexically_normal().parent_path();
  for (;; below = below.parent_path()) {
    const fs::path described = workspace.folder / below / "package.xml";
    if (std::error_code none; fs::exists(described, none)) {
      const auto text = read_file(described, kMostOfList);
      const auto xml = text ? parse_package_xml(*text, described.string(),
                                                ros_condition_variables(workspace.manifest.distro))
                            : Outcome<PackageXml>(text.errors());
      return xml ? xml->name.value : std::string();
    }
    if (below.empty()) return {};
  }
}

}  // namespace

Outcome<LaunchedFile> launch_from_file(const PackRequest& request, const BuiltWorkspace& workspace,
                                       PackNotes& notes, const Cancellation& cancellation) {
  const Manifest& manifest = workspace.read.manifest;
  const Spanned<std::string>& file = *manifest.launch_file;
  const std::vector<GivenArgument>& arguments = manifest.launch_arguments;
  const std::vector<InstalledPackage>& installed = workspace.built.installed;
  const LeftOutChains& left_out_chains = workspace.built.left_out;
  notes.watched.push_back(workspace.read.folder / file.value);
  const auto folders = installed_launch_folders(workspace.read.folder, installed,
                                                workspace.fetched.prefix, manifest.distro);
  LaunchWorld world = launch_world(folders, manifest.distro, true);
  world.variables =
      with_environment_hooks(manifest.launch_variables, installed, launch_prefix(manifest.distro));
  Reading reading;
  PythonRecord record;
  const std::string path = std::string(kLaunchWorkspace) + "/" + file.value;
  const Texts packed_with = values_by_name(arguments);
  const auto given_at = places_by_name(arguments);
  const LaunchInterpreter interpreter = launch_interpreter({.executable = request.executable,
                                                            .variables = request.variables,
                                                            .environment = workspace.fetched.prefix,
                                                            .folders = folders,
                                                            .file = path,
                                                            .given = packed_with},
                                                           cancellation);
  const auto evaluate = [&](Texts given) {
    given.insert(packed_with.begin(), packed_with.end());  // those that are tried stay
    LaunchWorld seen = reading.seen_through(world);
    seen.python = record.recording(interpreter.python);
    seen.given_at = given_at;
    return launch_file_nodes(path, given, seen, installed, file.span, left_out_chains);
  };
  const auto watch = [&](const std::vector<std::string>& files) {
    for (const std::string& one : files)
      if (auto real = real_path(folders, one)) notes.watched.push_back(std::move(*real));
  };

  auto launched = evaluate({});
  if (!launched) return std::move(launched).errors();
  if (Diagnostics errors = undeclared_in_manifest(arguments, launched->arguments); !errors.empty())
    return errors;
  Diagnostics refused = refused_when_strict(launched->warnings);
  if (request.strict && !refused.empty()) return refused;
  append(notes.warnings, launched->warnings);
  watch(launched->files);
  for (std::string& remark : launched->remarks) notes.remarks.push_back(std::move(remark));
  LaunchedFile step;
  step.package = package_around(workspace.read, file.value);
  std::set<fs::path> programs;
  for (const LaunchNode& node : launched->nodes) programs.insert(node.program);
  if (!launched->arguments.empty()) {
    const ArgumentTrials tried = argument_trials(launched->arguments, kMostTrials);
    std::set<std::string> told;  // one wrong value makes every combination with it fail
    for (const Texts& given : tried.trials) {
      if (cancellation.requested()) return interrupted();
      auto other = evaluate(given);
      if (!other) {
        if (told.insert(other.errors().front().message).second)
          notes.warnings.push_back(not_with(given, file.span, other.errors()));
        continue;
      }
      watch(other->files);
      for (LaunchNode& node : other->nodes)
        if (node.kind != ProgramKind::kCommand && programs.insert(node.program).second)
          step.more_nodes.push_back(std::move(node));
    }
    if (!tried.is_complete)
      notes.remarks.push_back(
          "tried " + std::to_string(tried.trials.size() + 1) +
          " values of launch arguments together; a program that only others start is not in the "
          "site");
    // With Pyodide in the site, Python is run there again.
    PythonFiles modules;
    if (!record.exchanges().empty() &&
        (runs_python(launched->nodes) || runs_python(step.more_nodes))) {
      auto read = launch_modules(request.executable);
      if (!read) return std::move(read).errors();
      modules = std::move(*read);
      const auto seen_by_python = interpreter.seen();
      if (!seen_by_python) return seen_by_python.errors();
      reading.add_python(world, *seen_by_python);
    }
    std::vector<std::string> left_out;
    Texts texts = reading.texts(world, left_out);
    if (!left_out.empty())
      notes.remarks.push_back("launch arguments cannot choose " + name_list(left_out) +
                              ": too large");
    // The same site whatever folder the pack was started in.
    SourceSpan from = file.span;
    from.file = fs::path(from.file).filename().string();
    step.launch = PackedLaunch{.file = path,
                               .from = std::move(from),
                               .given = packed_with,
                               .variables = world.variables,
                               .distro = manifest.distro,
                               .installed = installed,
                               .left_out = left_out_chains,
                               .texts = std::move(texts),
                               .python = record.exchanges(),
                               .arguments = std::move(launched->arguments),
                               .tried = tried.names,
                               .modules = std::move(modules)};
  }
  interpreter.keep();
  // Programs that the page stands in for, rviz2 for example, start nothing and are there all the
  // same.
  if (launched->nodes.empty() && step.more_nodes.empty() && launched->panels.empty()) {
    return Diagnostic{.code = "R2W0406",
                      .message = "the launch file starts nothing that a site can run",
                      .span = file.span,
                      .why = {"`ros2wasm launch " + file.value + "` shows what it comes to"}};
  }
  step.nodes = std::move(launched->nodes);
  step.steps = std::move(launched->steps);
  step.panels = std::move(launched->panels);
  return step;
}

Outcome<PackedLaunch> packed_launch(const std::string& path, const Texts& given,
                                    const LaunchWorld& world,
                                    const std::vector<InstalledPackage>& installed,
                                    const std::string& distro) {
  Reading reading;
  PythonRecord record;
  LaunchWorld seen = reading.seen_through(world);
  seen.python = record.recording(world.python);
  auto description = evaluate_launch(path, given, seen);
  if (!description) return std::move(description).errors();
  std::vector<std::string> left_out;
  return PackedLaunch{.file = path,
                      .from = {},
                      .given = {},
                      .variables = world.variables,
                      .distro = distro,
                      .installed = installed,
                      .left_out = {},
                      .texts = reading.texts(world, left_out),
                      .python = record.exchanges(),
                      .arguments = std::move(description->arguments),
                      .tried = {},
                      .modules = {}};
}

}  // namespace ros2wasm
