// See pack_build.hpp.
#include "bundler/pack_build.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <thread>

#include "bundler/build/cached_header.hpp"
#include "bundler/build/direct_link.hpp"
#include "bundler/build/foreign_packages.hpp"
#include "bundler/build/plugin_link.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/languages/language.hpp"
#include "bundler/plan/shipped_channel.hpp"
#include "bundler/python_nodes.hpp"
#include "bundler/store/build_place.hpp"
#include "bundler/store/cache_care.hpp"
#include "bundler/store/link_scripts.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// No script of a package is run. Packages whose scripts must not be missed are refused, the others
/// are named.
Diagnostics leave_link_scripts(const Manifest& manifest, const FetchedPackages& fetched,
                               const Store& store, PackNotes& notes) {
  const auto scripts = link_scripts_in(fetched.prefix, fetched.records, store);
  if (!scripts) return scripts.errors();
  std::vector<std::string> ignored;
  for (const auto& name : manifest.ignore_link_scripts) ignored.push_back(name.value);
  Diagnostics refused = refused_link_scripts(fetched.prefix, *scripts, ignored);
  if (!refused.empty()) return refused;
  for (const LinkScript& script : *scripts)
    notes.remarks.push_back("did not run " + script.path + " of " + script.package);
  return {};
}

Outcome<BuildTools> build_tools(const PackRequest& request, const Question& question,
                                const fs::path& cache, const Cancellation& cancellation) {
  const auto toolchain = find_own_data(
      request.executable, "templates/toolchain/ros2wasm-toolchain.cmake", "the CMake toolchain");
  if (!toolchain) return toolchain.errors();
  const auto real_toolchain = real_path(*toolchain);
  if (!real_toolchain) return real_toolchain.errors();
  const auto c_headers = find_own_data(request.executable, "templates/c_messages/c_headers.py",
                                       "the generator of C headers of messages");
  if (!c_headers) return c_headers.errors();
  const Compiler& compiler = question.compiler;
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
      .tool_calls = tool_calls_folder(cache, compiler),
      .quick = request.quick,
      .kept_headers = user_launcher ? fs::path() : kept_headers_folder(cache, compiler),
      .node_js = {},
      .python_templates = {}};
  if (std::any_of(question.packages.begin(), question.packages.end(), reads_setup_py)) {
    auto added = add_python_tools(request, tools, cancellation);
    if (!added) return std::move(added).errors();
  }
  return tools;
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

}  // namespace

Outcome<FetchedPackages> fetch_packages(const PackRequest& request, const Question& question,
                                        const Store& store, PackNotes& notes,
                                        const Cancellation& cancellation,
                                        const ProgressSink& progress) {
  auto resolved = resolve(request, question, notes, cancellation);
  if (!resolved) return std::move(resolved).errors();
  if (auto marked = mark_cache(question.supplies.roots.cache); !marked)
    return std::move(marked).errors();
  const auto environment = make_environment(store, resolved->records, cancellation, progress);
  if (!environment) return environment.errors();
  if (auto fits = check_foreign_packages(resolved->records, store); !fits)
    return std::move(fits).errors();
  for (const std::string& name : environment->without_hashes)
    notes.remarks.push_back("only the archive of " + name + " could be checked: it is an old " +
                            "package, which has no hashes of its files");
  FetchedPackages fetched{.records = std::move(resolved->records),
                          .lock_text = std::move(resolved->lock_text),
                          .prefix = environment->prefix,
                          .key = environment->key,
                          .channel = {}};
  if (request.with_channel) {
    const auto archives = store.archives(fetched.records, cancellation);
    if (!archives) return archives.errors();
    fetched.channel = shipped_channel(fetched.records, *archives);
  }
  Diagnostics refused = leave_link_scripts(question.read.manifest, fetched, store, notes);
  if (!refused.empty()) return refused;
  return fetched;
}

Outcome<BuiltPackages> build_packages(const PackRequest& request, const Question& question,
                                      const FetchedPackages& fetched, PackNotes& notes,
                                      const Cancellation& cancellation,
                                      const ProgressSink& progress) {
  const fs::path cache =
      build_place(request.built.empty() ? question.supplies.roots.cache : request.built);
  auto tools = build_tools(request, question, cache, cancellation);
  if (!tools) return std::move(tools).errors();
  begin_step(progress, "build");
  BuiltPackages result{.sources = {},
                       .left_out = {},
                       .tools = std::move(*tools),
                       .settings = {.cache = cache,
                                    .environment_prefix = fetched.prefix,
                                    .environment_key = fetched.key,
                                    .channel_packages = question.all_packages,
                                    .lacks = question.lacks,
                                    .builder_of = builder_of,
                                    .keeps_going = request.for_channel},
                       .packages = {},
                       .planned = {},
                       .failed = {},
                       .installed = {},
                       .components = {}};
  if (request.plan_builds) {
    auto planned = plan_builds(question.packages, question.order, question.left_out, result.tools,
                               result.settings);
    if (!planned) return std::move(planned).errors();
    result.planned = *std::move(planned);
    return result;
  }
  auto built = build_workspace(question.packages, question.order, question.left_out, result.tools,
                               result.settings, cancellation, progress);
  if (!built) return std::move(built).errors();
  append(notes.warnings, built->warnings);
  result.packages = std::move(built->packages);
  result.left_out = std::move(built->left_out);
  result.failed = std::move(built->failed);
  if (!result.packages.empty()) notes.remarks.push_back(build_remark(result.packages));
  if (std::string remark = warnings_remark(result.packages); !remark.empty())
    notes.remarks.push_back(std::move(remark));
  return result;
}

Outcome<Done> link_and_install(const Question& question, const FetchedPackages& fetched,
                               bool for_channel, BuiltPackages& built,
                               const Cancellation& cancellation, const ProgressSink& progress) {
  std::map<fs::path, fs::path> linked;
  // A channel has programs as they are; each workspace that uses them adds its plugins.
  if (!for_channel) {
    auto made = link_plugins(question.packages, built.packages, built.tools, built.settings,
                             cancellation, progress);
    if (!made) return std::move(made).errors();
    linked = std::move(*made);
  }
  built.installed = all_installed(built.packages, fetched.prefix);
  for (InstalledPackage& package : built.installed) {
    for (InstalledProgram& program : package.programs) {
      const auto found = linked.find(program.file);
      if (found != linked.end()) program.file = found->second;
    }
  }
  return Done{};
}

}  // namespace ros2wasm
