// See site_plan.hpp.
#include "bundler/plan/site_plan.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "bundler/build/wasm_module.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/plan/runtime_assets.hpp"
#include "bundler/plan/site_checks.hpp"
#include "bundler/plan/stored_site.hpp"
#include "bundler/render/citation.hpp"
#include "bundler/render/interfaces_json.hpp"
#include "bundler/render/license_list.hpp"
#include "bundler/render/packed_launch_json.hpp"
#include "bundler/render/page_html.hpp"
#include "bundler/render/site_json.hpp"
#include "bundler/render/web_manifest.hpp"
#include "workspace_schema/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

/// Headless programs run from the ros2wasm installation and are not part of sites.
constexpr std::string_view kHeadlessRoles = "headless";
/// For Python nodes only.
constexpr std::string_view kPythonRole = "python_worker";
/// For sites whose launch file declares arguments only.
constexpr std::string_view kLaunchRole = "launch_evaluator";
constexpr std::string_view kLaunchScriptRole = "launch_script";
constexpr std::string_view kScriptRole = "script";
constexpr std::string_view kPageRole = "page";
constexpr std::string_view kAppRole = "web_manifest";
/// Of a site in one file only.
constexpr std::string_view kCarriedPageRole = "carried_page";
constexpr const char* kLaunchData = "launch.json";
constexpr const char* kSiteJsonReason = "what runs in the site";

bool is_python(const LaunchNode& node) {
  return node.kind == ProgramKind::kPython;
}

bool is_command(const LaunchNode& node) {
  return node.kind == ProgramKind::kCommand;
}

std::string program_path(const LaunchNode& node) {
  if (is_python(node)) return kPythonProgram;
  return "programs/" + node.package + "/" + node.program.stem().string() + ".wasm";
}

PlannedFile& add(SitePlan& plan, std::string path, std::string reason, std::string bytes) {
  std::string hash = sha256_hex(bytes);
  plan.files.push_back({.path = std::move(path),
                        .reason = std::move(reason),
                        .bytes = std::move(bytes),
                        .sha256 = std::move(hash)});
  return plan.files.back();
}

std::string names_path(const LaunchNode& node) {
  return "programs/" + node.package + "/" + node.program.stem().string() + ".names";
}

std::string reason_of_program(const std::vector<LaunchNode>& nodes, const LaunchNode& first) {
  std::string users;
  for (const LaunchNode& node : nodes) {
    if (node.program != first.program) continue;
    users += (users.empty() ? "" : ", ") + node.id;
  }
  return "program of " + users;
}

/// A store's files have their hashes in their names.
bool has_hash_list(const SitePlan& plan) {
  return plan.store.objects.empty();
}

/// LICENSES.txt and the bill of materials, which are in every site, and what a citation needs.
void add_metadata(SitePlan& plan, const Manifest& manifest,
                  const std::vector<SiteComponent>& components) {
  const std::string content = sha256_hex(hash_list(plan.files));
  PlannedFile& licenses = add(plan, "LICENSES.txt", "licenses of all that is in the site",
                              license_list(manifest, components));
  if (!plan.store.objects.empty()) share_texts(licenses);
  add(plan, "sbom.spdx.json", "what the site is made of, for machines",
      spdx_document(manifest, components, content));
  if (!manifest.citation) return;
  add(plan, "CITATION.cff", "how the site is cited", citation_cff(manifest));
  std::vector<DescribedFile> files;
  for (const PlannedFile& file : plan.files) {
    files.push_back({.path = file.path,
                     .reason = file.reason,
                     .sha256 = file.sha256,
                     .size = file.bytes.size()});
  }
  files.push_back({.path = "site.json", .reason = kSiteJsonReason, .sha256 = {}, .size = 0});
  if (has_hash_list(plan))
    files.push_back({.path = kHashList, .reason = kHashListReason, .sha256 = {}, .size = 0});
  std::sort(files.begin(), files.end(),
            [](const DescribedFile& a, const DescribedFile& b) { return a.path < b.path; });
  add(plan, "ro-crate-metadata.json", "RO-Crate metadata, for archives of research data",
      ro_crate_metadata(manifest, files));
}

bool is_script(const RuntimeAsset& asset) {
  return asset.role == kScriptRole || asset.role == kLaunchScriptRole;
}

/// The same for all sites of one ros2wasm, whichever of them a site has.
std::string script_folder(const std::vector<RuntimeAsset>& assets) {
  std::vector<PlannedFile> scripts;
  for (const RuntimeAsset& asset : assets) {
    if (!is_script(asset)) continue;
    scripts.push_back(
        {.path = asset.file, .reason = {}, .bytes = {}, .sha256 = sha256_hex(asset.bytes)});
  }
  return sha256_hex(hash_list(scripts));
}

std::string reason_of_asset(std::string_view role) {
  if (role == "service_worker") return "runtime service worker";
  if (role == kAppRole) return "what browsers install the page by";
  return "runtime " + std::string(role);
}

}  // namespace

std::string page_text_path(const std::string& path) {
  return "text/" + std::filesystem::path(path).lexically_normal().generic_string();
}

std::string page_bag_path(const std::string& path) {
  return "bags/" + std::filesystem::path(path).lexically_normal().generic_string();
}

Outcome<SitePlan> plan_site(PlanInput input) {
  SitePlan plan;
  plan.panels = std::move(input.panels);
  Diagnostics errors;
  std::set<std::string> paths;
  for (const LaunchNode& node : input.nodes)
    if (!is_command(node)) paths.insert(program_path(node));
  const std::size_t count = input.nodes.size();
  // Of the nodes that run with the packed arguments.
  auto checks = site_checks(input.manifest.checks, input.nodes);
  if (checks) {
    plan.checks = std::move(checks).value();
  } else {
    append(errors, checks.errors());
  }
  for (TaskEntry task : input.manifest.tasks) {
    auto named = site_checks(std::move(task.checks), input.nodes);
    if (!named) {
      append(errors, named.errors());
      continue;
    }
    task.checks = std::move(named).value();
    plan.tasks.push_back(std::move(task));
  }
  std::move(input.more_nodes.begin(), input.more_nodes.end(), std::back_inserter(input.nodes));
  const bool has_python =
      input.notebook || std::any_of(input.nodes.begin(), input.nodes.end(), is_python);
  const Manifest& manifest = input.manifest;
  const auto chosen = manifest.ui.find("theme");
  const std::string theme = chosen == manifest.ui.end() ? "auto" : chosen->second;
  const std::string& title = manifest.title.empty() ? manifest.name.value : manifest.title;
  plan.store = {.objects = input.store, .scripts = script_folder(input.runtime)};
  for (RuntimeAsset& asset : input.runtime) {
    if (asset.role == kComponentsRole || asset.role == kCourseScriptRole) continue;
    if (asset.role.starts_with(kHeadlessRoles) || (asset.role == kPythonRole && !has_python))
      continue;
    const bool evaluates = asset.role == kLaunchRole || asset.role == kLaunchScriptRole;
    if (evaluates && !input.launch) continue;
    if (asset.role == kLaunchRole)
      plan.launch = {.data = kLaunchData,
                     .evaluator = asset.file,
                     .arguments = {},
                     .asks_python = !input.launch->python.empty(),
                     .python = {},
                     .tried = input.launch->tried};
    if (asset.role == kCarriedPageRole) {
      plan.carried_page = page_html(std::move(asset.bytes), title, theme, {});
      continue;
    }
    if (asset.role == kPageRole) {
      asset.bytes = page_html(std::move(asset.bytes), title, theme, {paths.begin(), paths.end()});
    }
    if (asset.role == kAppRole) asset.bytes = web_manifest(asset.bytes, title);
    const Kept kept = is_script(asset) ? Kept::kScript : Kept::kBeside;
    add(plan, asset.file, reason_of_asset(asset.role), std::move(asset.bytes)).kept = kept;
  }
  for (PageFile& file : input.text)
    add(plan, page_text_path(file.path), "text or notebook of the page, by `ui:` of the manifest",
        std::move(file.bytes));
  for (PageFile& file : input.bags)
    add(plan, page_bag_path(file.path), "`ui: bags:` of the manifest", std::move(file.bytes));
  std::map<std::string, bool> threads_of;
  plan.steps = std::move(input.steps);
  plan.launch_package = std::move(input.launch_package);
  for (const LaunchNode& node : input.nodes) {
    if (is_command(node)) {
      plan.nodes.push_back(
          {.node = node, .program = {}, .names = {}, .script = {}, .archives = {}});
      continue;
    }
    const std::string path = program_path(node);
    if (is_python(node)) {
      plan.nodes.push_back({.node = node,
                            .program = path,
                            .names = {},
                            .threads = false,
                            .script = python_script(node),
                            .archives = {}});
      continue;
    }
    const auto names = input.names.find(node.program);
    if (!threads_of.contains(path)) {
      const std::string& bytes = input.programs.at(node.program);
      const auto module = read_wasm_module(bytes);
      if (!module) {
        errors.push_back(
            Diagnostic{.code = "R2W0606",
                       .message = "`" + node.program.string() + "` is not a WebAssembly module",
                       .span = node.source});
        continue;
      }
      threads_of[path] = imports_shared_memory(*module);
      add(plan, path, reason_of_program(input.nodes, node), bytes);
      if (names != input.names.end()) {
        add(plan, names_path(node), "function names of " + path + ", fetched when a node crashed",
            names->second);
      }
    }
    plan.nodes.push_back({.node = node,
                          .program = path,
                          .names = names == input.names.end() ? "" : names_path(node),
                          .threads = threads_of[path],
                          .script = {},
                          .archives = {}});
  }
  if (!errors.empty()) return errors;
  if (has_python) {
    std::set<std::string> compiled;
    for (const LaunchNode& node : input.nodes)
      compiled.insert(node.compiled_modules.begin(), node.compiled_modules.end());
    if (input.notebook)
      compiled.insert(input.notebook->compiled.begin(), input.notebook->compiled.end());
    PythonSite python = python_site(std::move(input.python), input.interfaces, input.shared,
                                    compiled, input.packages, input.python_index);
    plan.sources = std::move(python.sources);
    for (PlannedNode& planned : plan.nodes) {
      if (!is_python(planned.node)) continue;
      planned.archives = python.archives;
      for (const std::string& module : planned.node.compiled_modules)
        planned.archives.push_back(python.compiled.at(module));
    }
    if (plan.launch && plan.launch->asks_python && !input.launch->modules.empty()) {
      add(plan, kLaunchModules, "what launch files in Python import, for other launch arguments",
          python_archive(input.launch->modules));
      plan.launch->python = {kLaunchModules};
      if (std::find(python.archives.begin(), python.archives.end(), kPythonWorkspace) !=
          python.archives.end())
        plan.launch->python.emplace_back(kPythonWorkspace);
    }
    if (input.notebook) {
      plan.notebook = PlannedNotebook{.file = page_text_path(input.notebook->file),
                                      .program = kPythonProgram,
                                      .archives = python.archives};
      for (const std::string& module : input.notebook->compiled)
        plan.notebook->archives.push_back(python.compiled.at(module));
    }
    for (PythonSiteFile& file : python.files)
      add(plan, std::move(file.path), std::move(file.reason), std::move(file.bytes));
  }
  if (plan.launch) {
    plan.launch->arguments = input.launch->arguments;
    add(plan, kLaunchData, "launch file, for other launch arguments",
        packed_launch_json(*input.launch, plan.nodes));
  }
  const auto end_of_nodes = plan.nodes.begin() + static_cast<std::ptrdiff_t>(count);
  plan.programs.assign(std::make_move_iterator(end_of_nodes),
                       std::make_move_iterator(plan.nodes.end()));
  plan.nodes.erase(end_of_nodes, plan.nodes.end());
  std::set<std::string> packages(input.packages.begin(), input.packages.end());
  for (auto& [path, bytes] : input.shared) {
    const std::string package = package_of_shared(path);
    packages.insert(package);
    add(plan, path, "file of " + package + ", fetched when a program opens it", std::move(bytes));
  }
  plan.packages.assign(packages.begin(), packages.end());
  if (!input.sources.empty()) {
    add(plan, kSourcesArchive, "what the site is made of, for `ros2wasm rebuild`",
        std::move(input.sources));
  }
  add(plan, "interfaces.json", "definitions of all message types",
      interfaces_json(input.interfaces));
  const auto by_path = [](const PlannedFile& a, const PlannedFile& b) { return a.path < b.path; };
  std::sort(plan.files.begin(), plan.files.end(), by_path);
  keep_in_store(plan);
  append(errors, split_files(plan, input.max_file_size));
  if (!plan.store.objects.empty() || input.max_file_size != 0) place_page(plan);
  add_metadata(plan, input.manifest, input.components);
  keep_in_store(plan);
  std::sort(plan.files.begin(), plan.files.end(), by_path);
  append(errors, split_files(plan, input.max_file_size));
  add(plan, "site.json", kSiteJsonReason, site_json(input.manifest, plan));
  plan.sha256 = plan.files.back().sha256;
  append(errors, split_files(plan, input.max_file_size));
  if (!errors.empty()) return errors;
  std::sort(plan.files.begin(), plan.files.end(), by_path);
  if (!has_hash_list(plan)) return plan;
  add(plan, kHashList, kHashListReason, hash_list(placed_files(plan)));
  std::sort(plan.files.begin(), plan.files.end(), by_path);
  return plan;
}

std::string hash_list(const std::vector<PlannedFile>& files) {
  std::string text;
  for (const PlannedFile& file : files) text += file.sha256 + "  " + file.path + "\n";
  return text;
}

std::vector<PlannedFile> placed_files(const SitePlan& plan) {
  std::vector<PlannedFile> placed;
  for (const PlannedFile& file : plan.files) {
    const std::vector<std::string> places = places_of(file, plan);
    for (std::size_t i = 0; i < places.size(); ++i) {
      placed.push_back({.path = places[i],
                        .reason = {},
                        .bytes = {},
                        .sha256 = file.parts.empty() ? file.sha256 : file.parts[i].sha256});
    }
  }
  std::sort(placed.begin(), placed.end(),
            [](const PlannedFile& a, const PlannedFile& b) { return a.path < b.path; });
  return placed;
}

std::vector<std::string> places_of(const PlannedFile& file, const SitePlan& plan) {
  return site_places(file.path, file.sha256, file.kept, file.parts, plan.store);
}

std::uint64_t total_size(const SitePlan& plan) {
  std::uint64_t sum = 0;
  for (const PlannedFile& file : plan.files) sum += file.bytes.size();
  return sum;
}

std::uint64_t channel_size(const SitePlan& plan) {
  std::uint64_t sum = 0;
  for (const ChannelFile& file : plan.channel) sum += file.size;
  return sum;
}

std::uint64_t names_size(const SitePlan& plan) {
  std::uint64_t sum = 0;
  for (const PlannedFile& file : plan.files) {
    if (file.path.ends_with(".names")) sum += file.bytes.size();
  }
  return sum;
}

}  // namespace ros2wasm
