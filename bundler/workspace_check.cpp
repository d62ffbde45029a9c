// See workspace_check.hpp. The steps are those of pipeline.cpp, without the ones that cost.
#include "bundler/workspace_check.hpp"

#include <algorithm>

#include "bundler/channel/channel_index.hpp"
#include "bundler/io/files.hpp"
#include "bundler/languages/language.hpp"
#include "bundler/launch/component_containers.hpp"
#include "bundler/launch/given_arguments.hpp"
#include "bundler/launch/host/launch_world.hpp"
#include "bundler/launch/host/parameter_sources.hpp"
#include "bundler/launch/host/python_syntax.hpp"
#include "bundler/launch/launch_evaluation.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/parameter_file.hpp"
#include "bundler/launch/simulator_command.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/launch_tools.hpp"
#include "bundler/python_libraries_of_site.hpp"
#include "bundler/released_packages.hpp"
#include "bundler/store/build_place.hpp"
#include "bundler/store/cache_place.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "bundler/workspace/fuel_needs.hpp"
#include "bundler/workspace/library_request.hpp"
#include "bundler/workspace/page_bags.hpp"
#include "bundler/workspace/page_notebook.hpp"
#include "bundler/workspace/wheel_request.hpp"
#include "bundler/workspace/workspace_channels.hpp"
#include "bundler/workspace/world_files.hpp"
#include "bundler/workspace_sources.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Does everything that the workspace has not come from the channel inside the program?
bool embedded_only(const WorkspaceChannels& channels) {
  return !channels.roots.embedded.empty() && channels.addresses.size() == 1 &&
         channels.addresses.front().name == kEmbeddedChannel;
}

Diagnostics check_parameters(const Manifest& manifest, const fs::path& folder) {
  ParameterFiles files;
  Diagnostics errors = read_parameter_files(manifest.nodes, folder, files);
  for (const auto& [file, text] : files) {
    if (const auto read = read_parameter_file(text, file); !read) append(errors, read.errors());
  }
  return errors;
}

/// Modules that libraries of Pyodide's distribution bring are not missing.
Diagnostics meet_by_libraries(const CheckRequest& request, const fs::path& folder,
                              const std::vector<NamedWheel>& wheels, const KnownNames& known,
                              CheckReport& report) {
  const bool asks = !report.manifest.python_packages.empty() ||
                    std::any_of(report.packages.begin(), report.packages.end(),
                                [](const LocalPackage& one) { return !one.python_uses.empty(); });
  if (!takes_libraries(report.manifest) || !asks) return {};
  const auto offered = offered_libraries(request.executable, report.manifest, folder);
  if (!offered) return offered.errors();
  const auto asked = library_request({.manifest = report.manifest,
                                      .packages = report.packages,
                                      .left_out = {},
                                      .wheels = wheels,
                                      .known = known,
                                      .notebook_modules = {},
                                      .libraries = *offered});
  if (!asked) return asked.errors();
  append(report.warnings, asked->warnings);
  drop_met_by_libraries(asked->libraries, *offered, known, report.manifest.distro, report.packages);
  return {};
}

/// Reports names that neither the workspace nor a channel has. `known`: the names of the packages
/// of the channels.
Diagnostics check_names(CheckReport& report, const LeftOutPackages& left_out,
                        const KnownNames& known) {
  Diagnostics errors;
  const auto wanted = channel_request(report.manifest, report.packages, left_out, known, "");
  append(wanted ? report.warnings : errors, wanted ? wanted->warnings : wanted.errors());
  std::vector<std::string> packages = ros_names(known.names, report.manifest.distro);
  for (std::size_t i = 0; i < report.packages.size(); ++i) {
    if (!left_out.contains(i)) packages.push_back(report.packages[i].xml.name.value);
  }
  const LeftOutChains chains = chains_by_name(report.packages, left_out);
  append(errors, missing_packages(report.manifest.nodes, packages, chains));
  append(errors, missing_packages(report.launched, packages, chains));
  std::vector<NodeEntry> programs;
  for (const ProgramEntry& program : report.manifest.programs) {
    programs.emplace_back();
    programs.back().package = program.package;
  }
  append(errors, missing_packages(programs, packages, chains));
  return errors;
}

/// Evaluates the launch file before anything is built; its warnings are added to the report.
Diagnostics check_launch_file(const CheckRequest& request, CheckReport& report,
                              const fs::path& folder, const Cancellation& cancellation) {
  if (!report.manifest.launch_file) return {};
  const auto folders = source_launch_folders(folder, report.packages, report.manifest.distro);
  LaunchWorld world = launch_world(folders, report.manifest.distro, false);
  world.variables = report.manifest.launch_variables;
  const auto& given = report.manifest.launch_arguments;
  const std::string path = std::string(kLaunchWorkspace) + "/" + report.manifest.launch_file->value;
  const LaunchInterpreter interpreter = launch_interpreter({.executable = request.executable,
                                                            .variables = request.variables,
                                                            .environment = {},
                                                            .folders = folders,
                                                            .file = path,
                                                            .given = values_by_name(given)},
                                                           cancellation);
  world.python = interpreter.python;
  world.given_at = places_by_name(given);
  auto description =
      evaluate_launch(path, values_by_name(given), world, report.manifest.launch_file->span);
  if (!description) return std::move(description).errors();
  interpreter.keep();
  if (Diagnostics errors = undeclared_in_manifest(given, description->arguments); !errors.empty())
    return errors;
  append(report.warnings, description->warnings);
  const auto is_known = [&](const std::string& package) {
    return is_simulator_package(package) ||
           std::any_of(report.packages.begin(), report.packages.end(),
                       [&](const LocalPackage& one) { return one.xml.name.value == package; });
  };
  append(report.warnings, left_out_of_site(*description, is_known, world));
  for (const LaunchProcess& process : description->processes) {
    const std::string& package = process.node.package.value;
    if (process.node.is_command || has_stand_in(package, is_known)) continue;
    // Its program is chosen by its components.
    if (!is_container(process)) report.launched.push_back(process.node);
    for (const LaunchComponent& one : process.components) report.launched.push_back(one.node);
  }
  return {};
}

/// R2W0528: errors in packages whose programs run, else warnings, as nobody may import the file.
Diagnostics check_python(const CheckRequest& request, CheckReport& report, const fs::path& folder,
                         const Cancellation& cancellation) {
  std::vector<std::string> texts;
  std::vector<std::pair<std::string, bool>> files;  // as messages name it; does its package run?
  for (const LocalPackage& package : report.packages) {
    const auto is_own = [&](const NodeEntry& node) {
      return node.package.value == package.xml.name.value;
    };
    const bool runs =
        std::any_of(report.manifest.nodes.begin(), report.manifest.nodes.end(), is_own) ||
        std::any_of(report.launched.begin(), report.launched.end(), is_own);
    for (const fs::path& file : package.python_files) {
      auto text = read_file(file, kMostOfText);
      if (!text) continue;  // discovery has read it
      files.emplace_back(shown_path(file, folder, request.manifest.parent_path()), runs);
      texts.push_back(*std::move(text));
    }
  }
  const auto cache = cache_directory(request.variables);
  if (!cache) return cache.errors();
  const auto mistakes = python_mistakes(
      texts, kept_python_place(*cache),
      [&] { return find_launch_tools(request.executable, request.variables, {}, cancellation); },
      cancellation);
  Diagnostics errors;
  if (!mistakes) {
    // Without Node.js or Pyodide everything else is checked all the same.
    for (Diagnostic one : mistakes.errors()) {
      one.severity = Severity::kWarning;
      report.warnings.push_back(std::move(one));
    }
    return errors;
  }
  for (const PythonMistake& one : *mistakes) {
    const auto& [file, runs] = files[one.text];
    Diagnostic found = invalid_python(one, file, texts[one.text]);
    if (!runs) found.severity = Severity::kWarning;
    (runs ? errors : report.warnings).push_back(std::move(found));
  }
  return errors;
}

/// A source that is not on this machine does not make the workspace wrong, but what it has is not
/// known then: false.
bool add_source_faults(const Diagnostics& faults, Diagnostics& errors, Diagnostics& warnings) {
  for (Diagnostic one : faults) {
    const bool is_away = one.code == "R2W0253";
    if (is_away) one.severity = Severity::kWarning;
    (is_away ? warnings : errors).push_back(std::move(one));
  }
  return false;
}

}  // namespace

Outcome<CheckReport> check_workspace(const CheckRequest& request,
                                     const Cancellation& cancellation) {
  const auto text = read_file(request.manifest, kMostOfText);
  if (!text) return text.errors();
  auto manifest = read_manifest(*text, request.manifest.generic_string());
  if (!manifest) return std::move(manifest).errors();
  CheckReport report{
      .manifest = std::move(*manifest), .packages = {}, .launched = {}, .warnings = {}};
  report.warnings = report.manifest.warnings;
  const auto place = absolute_path(request.manifest);
  if (!place) return place.errors();
  const fs::path folder = place->parent_path();

  Diagnostics errors;
  auto packages =
      discover_packages(folder, request.manifest.parent_path(), report.manifest.packages,
                        ros_condition_variables(report.manifest.distro));
  if (packages) {
    report.packages = std::move(*packages);
  } else {
    append(errors, packages.errors());
  }
  Manifest asked = report.manifest;  // the report keeps the dependencies as they are written
  const auto channels = workspace_channels(asked, folder, request.executable, request.variables);
  if (!channels) append(errors, channels.errors());
  WorkspaceSources sources;
  ChannelRoots roots = channels ? channels->roots : ChannelRoots();
  roots.network.offline = true;
  const SourcesRequest sources_request{.folder = folder,
                                       .shown_folder = request.manifest.parent_path()};
  bool has_sources = true;
  if (packages && channels) {
    const auto limits = extract_limits_of("", request.variables);
    auto added = limits ? add_source_packages(report.manifest, sources_request, roots, *limits,
                                              report.packages, cancellation, {})
                        : Outcome<WorkspaceSources>(limits.errors());
    if (added) sources = std::move(*added);
    if (!added) has_sources = add_source_faults(added.errors(), errors, report.warnings);
  }
  const auto wheels = channels ? read_wheels(asked, channels->roots, {}, false, cancellation)
                               : std::vector<NamedWheel>();
  if (!wheels) append(errors, wheels.errors());
  if (wheels) drop_met_by_wheels(*wheels, report.manifest.distro, report.packages);
  auto order = order_packages(report.packages, report.manifest.distro);
  if (!order) append(errors, order.errors());
  append(errors, check_parameters(report.manifest, folder));
  if (const auto page = read_page_files(folder, report.manifest)) {
    append(report.warnings, cut_bags(page->bags, report.manifest.ui_bags));
  } else {
    append(errors, page.errors());
  }
  if (report.manifest.ui_notebook) {
    auto notebook = read_page_notebook(folder, *report.manifest.ui_notebook);
    if (!notebook) append(errors, std::move(notebook).errors());
  }
  append(errors, check_launch_file(request, report, folder, cancellation));
  append(errors, check_python(request, report, folder, cancellation));
  append(report.warnings, check_worlds(report.packages, folder, request.manifest.parent_path()));
  if (!report.manifest.fetches_fuel) {
    const fs::path shown = request.manifest.parent_path();
    for (const FuelNeed& need : fuel_needs(report.packages, folder, shown))
      report.warnings.push_back(missing_fuel_model(need));
  }

  // A program without its channel says so when it packs; the manifest is not to blame.
  bool names_are_known = packages && order && channels && has_sources && embedded_only(*channels);
  KnownNames known{.names = {}, .of_lock = !names_are_known, .absent = {}};
  if (names_are_known) {
    const auto open = open_channels(channels->addresses, channels->roots, cancellation);
    if (!open) return open.errors();
    known.names = open->names();
    const auto added =
        add_released_packages(report.manifest, sources_request, roots, {}, known.names,
                              report.packages, sources, cancellation, {});
    if (!added) names_are_known = add_source_faults(added.errors(), errors, report.warnings);
    order = order_packages(report.packages, report.manifest.distro);
    if (!order) append(errors, order.errors());
    if (wheels) append(errors, meet_by_libraries(request, folder, *wheels, known, report));
  }
  known.of_lock = !names_are_known;
  const auto left_out = order ? left_out_packages(report.packages, *order, known,
                                                  report.manifest.distro, known_build_types())
                              : LeftOutPackages();
  for (const auto& [index, reason] : left_out) report.warnings.push_back(reason.warning);
  if (names_are_known && order) append(errors, check_names(report, left_out, known));
  if (!errors.empty()) {
    // A skipped package may be the reason, so report the warnings too.
    append(errors, report.warnings);
    return errors;
  }
  return report;
}

}  // namespace ros2wasm
