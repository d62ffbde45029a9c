// The steps of a pack, in order. Edges (disk, processes) and pure steps alternate as
// ARCHITECTURE.md says.
#include "bundler/pipeline.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <thread>

#include "bundler/build/cached_header.hpp"
#include "bundler/build/direct_link.hpp"
#include "bundler/build/foreign_packages.hpp"
#include "bundler/build/plugin_link.hpp"
#include "bundler/carried_programs.hpp"
#include "bundler/carried_sources.hpp"
#include "bundler/container_programs.hpp"
#include "bundler/emit/site_output.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/languages/language.hpp"
#include "bundler/launch/host/parameter_sources.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch_from_file.hpp"
#include "bundler/notebook_files.hpp"
#include "bundler/pack_inputs.hpp"
#include "bundler/plan/runtime_assets.hpp"
#include "bundler/plan/shipped_channel.hpp"
#include "bundler/program_files.hpp"
#include "bundler/python_nodes.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/site_budget.hpp"
#include "bundler/site_components.hpp"
#include "bundler/store/build_place.hpp"
#include "bundler/store/cache_care.hpp"
#include "bundler/store/environment.hpp"
#include "bundler/store/link_scripts.hpp"
#include "bundler/workspace/default_manifest.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "bundler/workspace/page_bags.hpp"
#include "bundler/workspace/wheel_request.hpp"
#include "bundler/workspace_sources.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// No script of a package is run. Whose must not be missed is refused, the others are named.
Diagnostics leave_link_scripts(BuiltWorkspace& workspace, const fs::path& environment,
                               const std::vector<PackageRecord>& records, const Store& store) {
  const auto scripts = link_scripts_in(environment, records, store);
  if (!scripts) return scripts.errors();
  std::vector<std::string> ignored;
  for (const auto& name : workspace.manifest.ignore_link_scripts) ignored.push_back(name.value);
  Diagnostics refused = refused_link_scripts(environment, *scripts, ignored);
  if (!refused.empty()) return refused;
  for (const LinkScript& script : *scripts)
    workspace.remarks.push_back("did not run " + script.path + " of " + script.package);
  return {};
}

/// The packages in the prefixes, those of the workspace before those of the channels.
std::vector<InstalledPackage> all_installed(const std::vector<BuiltPackage>& built,
                                            const fs::path& environment) {
  std::vector<InstalledPackage> result;
  std::set<std::string> names;
  for (const BuiltPackage& one : built) {
    names.insert(one.name);
    result.push_back({.name = one.name,
                      .version = one.version,
                      .prefix = one.prefix,
                      .programs = installed_programs(one.prefix, one.name),
                      .in_bin = programs_in_bin(one.prefix)});
  }
  for (InstalledPackage& one : installed_packages(environment)) {
    if (names.insert(one.name).second) result.push_back(std::move(one));
  }
  return result;
}

/// Step 7: nodes of the launch file or of the manifest; without any, every program of the
/// workspace.
Outcome<LaunchedFile> launch(const PackRequest& request, BuiltWorkspace& workspace,
                             const Cancellation& cancellation) {
  Manifest& manifest = workspace.manifest;
  if (manifest.launch_file)
    return launch_from_file(request, workspace, *manifest.launch_file, manifest.launch_arguments,
                            cancellation);
  workspace.nodes_by_default = manifest.nodes.empty();
  if (workspace.nodes_by_default) {
    const auto local_end =
        workspace.installed.begin() + static_cast<std::ptrdiff_t>(workspace.packages.size());
    manifest.nodes = default_nodes({workspace.installed.begin(), local_end});
    if (manifest.nodes.empty()) {
      return Diagnostic{.code = "R2W0406",
                        .message = "the workspace has no program to run",
                        .why = {"none of its packages installs an executable into lib/<package>/"}};
    }
    std::vector<std::string> names;
    for (const NodeEntry& node : manifest.nodes)
      names.push_back(node.package.value + "/" + node.executable.value);
    workspace.remarks.push_back("every program runs once: " + name_list(names, 12));
  }
  ParameterFiles files;
  Diagnostics errors = read_parameter_files(manifest.nodes, workspace.folder, files);
  for (const NodeEntry& node : manifest.nodes) {
    for (const auto& file : node.parameter_files)
      workspace.watched.push_back(workspace.folder / file.value);
  }
  auto nodes = launch_nodes(manifest.nodes, workspace.installed, files, workspace.left_out);
  if (!nodes) append(errors, nodes.errors());
  if (!errors.empty()) return errors;
  // The same site whatever folder the pack was started in.
  for (LaunchNode& node : *nodes) node.source.file = fs::path(node.source.file).filename().string();
  return LaunchedFile{
      .nodes = std::move(*nodes), .steps = {}, .more_nodes = {}, .launch = std::nullopt};
}

/// Step 8: read what the plan is made of.
Outcome<SitePlan> plan(const PackRequest& request, BuiltWorkspace& workspace, LaunchedFile launched,
                       std::string store, const Cancellation& cancellation) {
  const auto list =
      find_own_data(request.executable, "runtime/runtime_assets.json", "the runtime of sites");
  if (!list) return list.errors();
  auto runtime = read_runtime_assets(*list);
  if (!runtime) return std::move(runtime).errors();

  PlanInput input{.manifest = workspace.manifest,
                  .nodes = std::move(launched.nodes),
                  .steps = std::move(launched.steps),
                  .more_nodes = std::move(launched.more_nodes),
                  .launch = std::move(launched.launch),
                  .launch_package = std::move(launched.package),
                  .panels = std::move(launched.panels),
                  .programs = {},
                  .names = {},
                  .runtime = std::move(runtime).value(),
                  .interfaces = {},
                  .shared = {},
                  .packages = {},
                  .python = {},
                  .python_index = {},
                  .components = {},
                  .text = {},
                  .bags = {},
                  .notebook = std::nullopt,
                  .max_file_size = request.max_file_size,
                  .store = std::move(store)};
  if (auto added = add_page(workspace, input); !added) return std::move(added).errors();
  auto components = with_runtime_components(input.runtime, std::move(workspace.components));
  if (!components) return std::move(components).errors();
  input.components = std::move(*components);
  const auto read = [&](const std::vector<LaunchNode>& nodes) {
    return read_programs(request, workspace, nodes, input, cancellation);
  };
  if (auto done = read(input.nodes); !done) return std::move(done).errors();
  if (auto done = read(input.more_nodes); !done) return std::move(done).errors();
  for (const InstalledPackage& package : workspace.installed) {
    collect_interfaces(package.prefix, package.name, input.interfaces);
    const auto left_out = collect_shared_files(package.prefix, package.name, input.shared);
    if (!left_out) return left_out.errors();
    for (const std::string& one : *left_out) workspace.remarks.push_back("skipped " + one);
  }
  for (const BuiltPackage& package : workspace.packages) input.packages.push_back(package.name);
  if (auto added = add_python(request, workspace, input, cancellation); !added)
    return std::move(added).errors();
  if (auto added = add_sources(request, workspace, input); !added) return std::move(added).errors();
  return plan_site(std::move(input));
}

}  // namespace

Outcome<BuiltWorkspace> build(const PackRequest& request, const Cancellation& cancellation,
                              const ProgressSink& progress) {
  // 1. the manifest, 2. the packages of the workspace, 3. what the channels give: index, solve,
  // lock, fetch
  auto question = ask(request, cancellation, progress);
  if (!question) return std::move(question).errors();
  const auto records = resolve(request, *question, cancellation);
  if (!records) return records.errors();
  const ChannelRoots& roots = question->roots;
  const Compiler& compiler = question->compiler;
  BuiltWorkspace* workspace = &question->workspace;
  if (auto marked = mark_cache(roots.cache); !marked) return std::move(marked).errors();
  const Store store(roots, question->limits);
  const auto environment = make_environment(store, *records, cancellation, progress);
  if (!environment) return environment.errors();
  if (auto fits = check_foreign_packages(*records, store); !fits) return std::move(fits).errors();
  for (const std::string& name : environment->without_hashes)
    workspace->remarks.push_back("only the archive of " + name +
                                 " could be checked: it is an old " +
                                 "package, which has no hashes of its files");
  if (request.with_channel) {
    const auto archives = store.archives(*records, cancellation);
    if (!archives) return archives.errors();
    workspace->channel = shipped_channel(*records, *archives);
  }
  if (Diagnostics refused = leave_link_scripts(*workspace, environment->prefix, *records, store);
      !refused.empty())
    return refused;

  // 4. build, through the toolchain file
  const auto toolchain = find_own_data(
      request.executable, "templates/toolchain/ros2wasm-toolchain.cmake", "the CMake toolchain");
  if (!toolchain) return toolchain.errors();
  const auto real_toolchain = real_path(*toolchain);
  if (!real_toolchain) return real_toolchain.errors();
  const auto c_headers = find_own_data(request.executable, "templates/c_messages/c_headers.py",
                                       "the generator of C headers of messages");
  if (!c_headers) return c_headers.errors();
  workspace->cache = build_place(request.built.empty() ? roots.cache : request.built);
  workspace->environment = environment->prefix;
  // One of the user's own, such as ccache, keeps its place.
  const auto launcher = request.variables.find("CMAKE_CXX_COMPILER_LAUNCHER");
  const bool user_launcher = launcher != request.variables.end() && !launcher->second.empty();
  BuildTools tools{
      .compiler = compiler,
      .compiler_environment = compiler_environment(request.variables),
      .tool_environment = tool_environment(request.variables, compiler.cxx),
      .toolchain = *real_toolchain,
      .c_messages = c_headers->parent_path(),
      .cli = request.executable,
      .jobs = request.jobs != 0 ? request.jobs : std::max(1U, std::thread::hardware_concurrency()),
      .tool_calls = tool_calls_folder(workspace->cache, compiler),
      .quick = request.quick,
      .kept_headers = user_launcher ? fs::path() : kept_headers_folder(workspace->cache, compiler),
      .node_js = {},
      .python_templates = {}};
  if (std::any_of(question->packages.begin(), question->packages.end(), reads_setup_py)) {
    auto added = add_python_tools(request, tools, cancellation);
    if (!added) return std::move(added).errors();
  }
  begin_step(progress, "build");
  const BuildSettings settings{.cache = workspace->cache,
                               .environment_prefix = environment->prefix,
                               .environment_key = environment->key,
                               .channel_packages = question->all_packages,
                               .lacks = question->lacks,
                               .builder_of = builder_of,
                               .keeps_going = request.for_channel};
  if (request.plan_builds) {
    auto planned =
        plan_builds(question->packages, question->order, question->left_out, tools, settings);
    if (!planned) return std::move(planned).errors();
    workspace->planned = *std::move(planned);
    return std::move(*workspace);
  }
  auto built = build_workspace(question->packages, question->order, question->left_out, tools,
                               settings, cancellation, progress);
  if (!built) return std::move(built).errors();
  append(workspace->warnings, built->warnings);
  workspace->packages = std::move(built->packages);
  workspace->left_out = std::move(built->left_out);
  workspace->failed = std::move(built->failed);
  if (!workspace->packages.empty()) workspace->remarks.push_back(build_remark(workspace->packages));
  if (std::string remark = warnings_remark(workspace->packages); !remark.empty())
    workspace->remarks.push_back(std::move(remark));

  // 5. programs with the plugins that they load
  // A channel has programs as they are; each workspace that uses them adds its plugins.
  const auto linked = request.for_channel
                          ? Outcome<std::map<fs::path, fs::path>>(std::map<fs::path, fs::path>())
                          : link_plugins(question->packages, workspace->packages, tools, settings,
                                         cancellation, progress);
  if (!linked) return linked.errors();

  // 6. what is installed now, and under which licenses
  workspace->installed = all_installed(workspace->packages, environment->prefix);
  for (InstalledPackage& package : workspace->installed) {
    for (InstalledProgram& program : package.programs) {
      const auto found = linked->find(program.file);
      if (found != linked->end()) program.file = found->second;
    }
  }
  workspace->components =
      site_components(*records, store, workspace->wheels, question->packages, workspace->left_out);
  workspace->sources = std::move(question->packages);
  workspace->tools = std::move(tools);
  workspace->settings = settings;
  return std::move(*workspace);
}

Outcome<LockReport> lock(const LockRequest& request, const Cancellation& cancellation,
                         const ProgressSink& progress) {
  auto question = ask({.input = request.input,
                       .frozen = request.check_only,
                       .offline = request.offline,
                       .executable = request.executable,
                       .variables = request.variables,
                       .update = request.update},
                      cancellation, progress);
  if (!question) return std::move(question).errors();
  LockReport report{.file = question->workspace.folder / kLockFileName,
                    .warnings = question->workspace.warnings};
  for (const auto& [index, reason] : question->left_out) report.warnings.push_back(reason.warning);
  if (request.check_only) {
    report.packages = std::move(question->index.records);
    return report;
  }
  const LockRest rest{
      .absent = question->absent,
      .sources = sources_to_lock(question->workspace.source_trees, question->packages),
      .wheels = locked_wheels(question->workspace.wheels),
      .python_index = question->workspace.python_index,
      .libraries = question->workspace.libraries};
  auto solved = solve_with_lock(question->specs, rest, question->index, report.file,
                                question->workspace.manifest.channel_priority, false,
                                without_sources(request.update, question->workspace.source_trees),
                                cancellation);
  if (!solved) return std::move(solved).errors();
  if (auto written = write_file(report.file, solved->lock_text); !written)
    return std::move(written).errors();
  report.packages = std::move(solved->packages);
  report.changed = solved->lock_changed;
  return report;
}

Outcome<PackReport> pack(const PackRequest& request, const Cancellation& cancellation,
                         const ProgressSink& progress) {
  auto store = may_write(request.output, request.store, request.plan_only);
  if (!store) return std::move(store).errors();
  auto workspace = build(request, cancellation, progress);
  if (!workspace) return std::move(workspace).errors();

  // 7. what runs
  auto nodes = launch(request, *workspace, cancellation);
  if (!nodes) {
    // A skipped package may be the reason, so report the warnings too.
    Diagnostics errors = std::move(nodes).errors();
    append(errors, workspace->warnings);
    return errors;
  }

  if (auto linked = link_containers(*workspace, *nodes, cancellation, progress); !linked)
    return std::move(linked).errors();
  if (auto carried = add_programs(*workspace, *nodes); !carried) return std::move(carried).errors();

  // 8. every file of the site
  begin_step(progress, "plan");
  auto planned =
      plan(request, *workspace, std::move(nodes).value(), std::move(*store), cancellation);
  if (!planned) return std::move(planned).errors();
  planned->channel = std::move(workspace->channel);
  if (request.signer) sign_site(*planned, *request.signer);

  // 9. write it, and what its parts weigh beside the lock
  if (!request.plan_only) {
    const bool writes = !request.locked && !request.frozen;
    if (auto kept = keep_budget(workspace->manifest, *planned, workspace->folder, writes); !kept)
      return std::move(kept).errors();
    begin_step(progress, "emit");
    if (auto emitted = emit_site(*planned, request.output, cancellation); !emitted) {
      return std::move(emitted).errors();
    }
  }
  return PackReport{.plan = std::move(planned).value(),
                    .output = request.output,
                    .watched = std::move(workspace->watched),
                    .warnings = std::move(workspace->warnings),
                    .remarks = std::move(workspace->remarks)};
}

}  // namespace ros2wasm
