// The steps of a pack, in order. Edges (disk, processes) and pure steps alternate as
// ARCHITECTURE.md says.
#include "bundler/pipeline.hpp"

#include <algorithm>

#include "bundler/carried_sources.hpp"
#include "bundler/emit/site_output.hpp"
#include "bundler/fuel_models.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/notebook_files.hpp"
#include "bundler/pack_build.hpp"
#include "bundler/pack_inputs.hpp"
#include "bundler/pack_launch.hpp"
#include "bundler/plan/runtime_assets.hpp"
#include "bundler/program_files.hpp"
#include "bundler/python_nodes.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/site_budget.hpp"
#include "bundler/site_components.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "bundler/workspace/launch_packages.hpp"
#include "bundler/workspace_sources.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

/// Models of Gazebo Fuel, in a site that has a simulator.
Outcome<Done> add_models(const BuiltWorkspace& workspace, PlanInput& input) {
  const auto& installed = workspace.built.installed;
  if (std::none_of(installed.begin(), installed.end(),
                   [](const InstalledPackage& one) { return is_simulator(one.name); }))
    return Done{};
  append_models(workspace.supplies.source_trees, input.components);
  return collect_fuel_models(workspace.supplies.source_trees, input.shared);
}

/// Step 8: read what the plan is made of.
Outcome<SitePlan> plan(const PackRequest& request, const BuiltWorkspace& workspace,
                       LaunchedFile launched, std::string store, PackNotes& notes,
                       const Cancellation& cancellation) {
  const auto list =
      find_own_data(request.executable, "runtime/runtime_assets.json", "the runtime of sites");
  if (!list) return list.errors();
  auto runtime = read_runtime_assets(*list);
  if (!runtime) return std::move(runtime).errors();

  PlanInput input{.manifest = workspace.read.manifest,
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
  if (auto added = add_page(workspace.read, input, notes); !added) return std::move(added).errors();
  auto components = with_runtime_components(input.runtime, workspace.built.components);
  if (!components) return std::move(components).errors();
  input.components = std::move(*components);
  for (const auto* nodes : {&input.nodes, &input.more_nodes}) {
    if (auto done = read_programs(request, workspace, *nodes, input, cancellation); !done)
      return std::move(done).errors();
  }
  for (const InstalledPackage& package : workspace.built.installed) {
    collect_interfaces(package.prefix, package.name, input.interfaces);
    const auto left_out = collect_shared_files(package.prefix, package.name, input.shared);
    if (!left_out) return left_out.errors();
    for (const std::string& one : *left_out) notes.remarks.push_back("skipped " + one);
  }
  if (auto added = add_models(workspace, input); !added) return std::move(added).errors();
  for (const BuiltPackage& package : workspace.built.packages)
    input.packages.push_back(package.name);
  if (auto added = add_python(request, workspace, launched.by_default, input, notes, cancellation);
      !added)
    return std::move(added).errors();
  if (auto added = add_sources(request, workspace, input, notes); !added)
    return std::move(added).errors();
  auto planned = plan_site(std::move(input));
  if (planned) planned->channel = workspace.fetched.channel;
  return planned;
}

}  // namespace

Outcome<BuiltWorkspace> build(const PackRequest& request, const Cancellation& cancellation,
                              const ProgressSink& progress) {
  PackNotes notes;
  // 1. the manifest, 2. the packages of the workspace, 3. what the channels give: index, solve,
  // lock, fetch
  auto question = ask(request, notes, cancellation, progress);
  if (!question) return std::move(question).errors();
  const Store store(question->supplies.roots, question->supplies.limits);
  auto fetched = fetch_packages(request, *question, store, notes, cancellation, progress);
  if (!fetched) return std::move(fetched).errors();

  // 4. build, through the toolchain file, 5. programs with the plugins that they load, 6. what is
  // installed now, and under which licenses
  auto built = build_packages(request, *question, *fetched, notes, cancellation, progress);
  if (!built) return std::move(built).errors();
  if (!request.plan_builds) {
    auto done =
        link_and_install(*question, *fetched, request.for_channel, *built, cancellation, progress);
    if (!done) return std::move(done).errors();
    built->components = site_components(fetched->records, store, question->supplies.wheels,
                                        question->packages, built->left_out);
  }
  built->sources = std::move(question->packages);
  return BuiltWorkspace{.read = std::move(question->read),
                        .supplies = std::move(question->supplies),
                        .fetched = std::move(*fetched),
                        .built = std::move(*built),
                        .notes = std::move(notes)};
}

Outcome<LockReport> lock(const LockRequest& request, const Cancellation& cancellation,
                         const ProgressSink& progress) {
  PackNotes notes;
  auto question = ask({.input = request.input,
                       .frozen = request.check_only,
                       .offline = request.offline,
                       .executable = request.executable,
                       .variables = request.variables,
                       .update = request.update},
                      notes, cancellation, progress);
  if (!question) return std::move(question).errors();
  LockReport report{.file = question->read.folder / kLockFileName,
                    .warnings = std::move(notes.warnings)};
  for (const auto& [index, reason] : question->left_out) report.warnings.push_back(reason.warning);
  if (request.check_only) {
    report.packages = std::move(question->index.records);
    return report;
  }
  auto solved = solve_with_lock(question->specs, lock_rest(*question), question->index, report.file,
                                question->read.manifest.channel_priority, false,
                                without_sources(request.update, question->supplies.source_trees),
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
  PackNotes notes = std::move(workspace->notes);

  // 7. what runs
  auto launched = launch(request, *workspace, notes, cancellation, progress);
  if (!launched) return std::move(launched).errors();

  // 8. every file of the site
  begin_step(progress, "plan");
  auto planned =
      plan(request, *workspace, *std::move(launched), std::move(*store), notes, cancellation);
  if (!planned) return std::move(planned).errors();
  if (request.signer) sign_site(*planned, *request.signer);

  // 9. write it, and what its parts weigh beside the lock
  if (!request.plan_only) {
    const ReadWorkspace& read = workspace->read;
    const bool writes = !request.locked && !request.frozen;
    if (auto kept = keep_budget(read.manifest, *planned, read.folder, writes); !kept)
      return std::move(kept).errors();
    begin_step(progress, "emit");
    if (auto emitted = emit_site(*planned, request.output, cancellation); !emitted) {
      return std::move(emitted).errors();
    }
  }
  return PackReport{
      .plan = std::move(planned).value(), .output = request.output, .notes = std::move(notes)};
}

}  // namespace ros2wasm
