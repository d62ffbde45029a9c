// See plan_site.hpp.
#include "bundler/plan/plan_site.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "bundler/archive/wasm_module.hpp"
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
#include "bundler/site/site_names.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

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
/// The role of a file that only a site in one file has.
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

bool by_path(const PlannedFile& a, const PlannedFile& b) {
  return a.path < b.path;
}

/// Plans one site: a pass for each kind of file, in the order of plan_site(). Mistakes of all
/// passes are reported together.
class SitePlanner {
 public:
  explicit SitePlanner(PlanInput input) : input_(std::move(input)) {}

  [[nodiscard]] Outcome<SitePlan> plan() {
    plan_.panels = std::move(input_.panels);
    plan_.steps = std::move(input_.steps);
    plan_.launch_package = std::move(input_.launch_package);
    name_checks();
    join_programs();
    add_runtime();
    add_page_files();
    add_programs();
    if (!errors_.empty()) return std::move(errors_);
    if (has_python_) add_python();
    add_launch();
    part_nodes_and_programs();
    add_shared_files();
    add_sources();
    add(plan_, "interfaces.json", "definitions of all message types",
        interfaces_json(input_.interfaces));
    return finished();
  }

 private:
  /// Checks and tasks speak of the nodes that run with the packed arguments.
  void name_checks() {
    if (auto checks = site_checks(input_.manifest.checks, input_.nodes)) {
      plan_.checks = std::move(checks).value();
    } else {
      append(errors_, checks.errors());
    }
    for (TaskEntry task : input_.manifest.tasks) {
      auto named = site_checks(std::move(task.checks), input_.nodes);
      if (!named) {
        append(errors_, named.errors());
        continue;
      }
      task.checks = std::move(named).value();
      plan_.tasks.push_back(std::move(task));
    }
  }

  /// From here on, the nodes are followed by the programs that none of them runs.
  void join_programs() {
    for (const LaunchNode& node : input_.nodes)
      if (!is_command(node)) first_programs_.insert(program_path(node));
    node_count_ = input_.nodes.size();
    std::move(input_.more_nodes.begin(), input_.more_nodes.end(), std::back_inserter(input_.nodes));
    has_python_ =
        input_.notebook || std::any_of(input_.nodes.begin(), input_.nodes.end(), is_python);
  }

  void add_runtime() {
    const Manifest& manifest = input_.manifest;
    const auto chosen = manifest.ui.find("theme");
    const std::string theme = chosen == manifest.ui.end() ? "auto" : chosen->second;
    const std::string& title = manifest.title.empty() ? manifest.name.value : manifest.title;
    plan_.store = {.objects = input_.store, .scripts = script_folder(input_.runtime)};
    for (RuntimeAsset& asset : input_.runtime) {
      if (!is_for_this_site(asset)) continue;
      if (asset.role == kLaunchRole)
        plan_.launch = {.data = kLaunchData,
                        .evaluator = asset.file,
                        .arguments = {},
                        .asks_python = !input_.launch->python.empty(),
                        .python = {},
                        .tried = input_.launch->tried};
      if (asset.role == kCarriedPageRole) {
        plan_.carried_page = page_html(std::move(asset.bytes), title, theme, {});
        continue;
      }
      if (asset.role == kPageRole)
        asset.bytes = page_html(std::move(asset.bytes), title, theme,
                                {first_programs_.begin(), first_programs_.end()});
      if (asset.role == kAppRole) asset.bytes = web_manifest(asset.bytes, title);
      const Kept kept = is_script(asset) ? Kept::kScript : Kept::kBeside;
      add(plan_, asset.file, reason_of_asset(asset.role), std::move(asset.bytes)).kept = kept;
    }
  }

  [[nodiscard]] bool is_for_this_site(const RuntimeAsset& asset) const {
    if (asset.role == kComponentsRole || asset.role == kCourseScriptRole) return false;
    if (asset.role.starts_with(kHeadlessRoles)) return false;
    if (asset.role == kPythonRole) return has_python_;
    const bool evaluates = asset.role == kLaunchRole || asset.role == kLaunchScriptRole;
    return !evaluates || input_.launch.has_value();
  }

  void add_page_files() {
    for (PageFile& file : input_.text)
      add(plan_, page_text_path(file.path),
          "text or notebook of the page, by `ui:` of the manifest", std::move(file.bytes));
    for (PageFile& file : input_.bags)
      add(plan_, page_bag_path(file.path), "`ui: bags:` of the manifest", std::move(file.bytes));
  }

  void add_programs() {
    for (const LaunchNode& node : input_.nodes) {
      PlannedNode planned{.node = node, .program = {}, .names = {}, .script = {}, .archives = {}};
      if (is_python(node)) {
        planned.program = program_path(node);
        planned.script = python_script(node);
      } else if (!is_command(node) && !add_compiled(node, planned)) {
        continue;
      }
      plan_.nodes.push_back(std::move(planned));
    }
  }

  /// The program of a compiled node, once however many nodes run it. False after R2W0606.
  bool add_compiled(const LaunchNode& node, PlannedNode& planned) {
    planned.program = program_path(node);
    const auto names = input_.names.find(node.program);
    const bool has_names = names != input_.names.end();
    if (!threads_of_.contains(planned.program)) {
      const std::string& bytes = input_.programs.at(node.program);
      const auto module = read_wasm_module(bytes);
      if (!module) {
        errors_.push_back(
            Diagnostic{.code = "R2W0606",
                       .message = "`" + node.program.string() + "` is not a WebAssembly module",
                       .span = node.source});
        return false;
      }
      threads_of_[planned.program] = imports_shared_memory(*module);
      add(plan_, planned.program, reason_of_program(input_.nodes, node), bytes);
      if (has_names)
        add(plan_, names_path(node),
            "function names of " + planned.program + ", fetched when a node crashed",
            names->second);
    }
    if (has_names) planned.names = names_path(node);
    planned.threads = threads_of_[planned.program];
    return true;
  }

  void add_python() {
    std::set<std::string> compiled;
    for (const LaunchNode& node : input_.nodes)
      compiled.insert(node.compiled_modules.begin(), node.compiled_modules.end());
    if (input_.notebook)
      compiled.insert(input_.notebook->compiled.begin(), input_.notebook->compiled.end());
    PythonSite python = python_site(std::move(input_.python), input_.interfaces, input_.shared,
                                    compiled, input_.packages, input_.python_index);
    plan_.sources = std::move(python.sources);
    for (PlannedNode& planned : plan_.nodes) {
      if (!is_python(planned.node)) continue;
      planned.archives =
          archives_with(python, planned.node.compiled_modules, planned.node.libraries);
      planned.load = loaded_first(python, planned.node.libraries);
    }
    add_launch_modules(python);
    if (input_.notebook)
      plan_.notebook = PlannedNotebook{
          .file = page_text_path(input_.notebook->file),
          .program = kPythonProgram,
          .archives = archives_with(python, input_.notebook->compiled, input_.notebook->libraries),
          .load = loaded_first(python, input_.notebook->libraries)};
    for (PythonSiteFile& file : python.files)
      add(plan_, std::move(file.path), std::move(file.reason), std::move(file.bytes));
  }

  [[nodiscard]] static std::vector<std::string> archives_with(
      const PythonSite& python, const std::vector<std::string>& compiled_modules,
      const std::vector<std::string>& libraries) {
    std::vector<std::string> archives = python.archives;
    for (const std::string& module : compiled_modules)
      archives.push_back(python.compiled.at(module));
    for (const std::string& project : libraries) archives.push_back(python.libraries.at(project));
    return archives;
  }

  [[nodiscard]] static std::vector<std::string> loaded_first(
      const PythonSite& python, const std::vector<std::string>& libraries) {
    std::vector<std::string> load;
    for (const std::string& project : libraries) {
      const auto& own = python.load.at(project);
      load.insert(load.end(), own.begin(), own.end());
    }
    return load;
  }

  void add_launch_modules(const PythonSite& python) {
    if (!plan_.launch || !plan_.launch->asks_python || input_.launch->modules.empty()) return;
    add(plan_, kLaunchModules, "what launch files in Python import, for other launch arguments",
        python_archive(input_.launch->modules));
    plan_.launch->python = {kLaunchModules};
    if (std::find(python.archives.begin(), python.archives.end(), kPythonWorkspace) !=
        python.archives.end())
      plan_.launch->python.emplace_back(kPythonWorkspace);
  }

  void add_launch() {
    if (!plan_.launch) return;
    plan_.launch->arguments = input_.launch->arguments;
    add(plan_, kLaunchData, "launch file, for other launch arguments",
        packed_launch_json(*input_.launch, plan_.nodes));
  }

  void part_nodes_and_programs() {
    const auto end_of_nodes = plan_.nodes.begin() + static_cast<std::ptrdiff_t>(node_count_);
    plan_.programs.assign(std::make_move_iterator(end_of_nodes),
                          std::make_move_iterator(plan_.nodes.end()));
    plan_.nodes.erase(end_of_nodes, plan_.nodes.end());
  }

  void add_shared_files() {
    std::set<std::string> packages(input_.packages.begin(), input_.packages.end());
    for (auto& [path, bytes] : input_.shared) {
      const std::string package = package_of_shared(path);
      packages.insert(package);
      add(plan_, path, "file of " + package + ", fetched when a program opens it",
          std::move(bytes));
    }
    plan_.packages.assign(packages.begin(), packages.end());
  }

  void add_sources() {
    if (input_.sources.empty()) return;
    add(plan_, kSourcesArchive, "what the site is made of, for `ros2wasm rebuild`",
        std::move(input_.sources));
  }

  /// Places the files in the store or in parts, and adds the files that list others.
  [[nodiscard]] Outcome<SitePlan> finished() {
    sort_files();
    keep_in_store(plan_);
    split();
    if (!plan_.store.objects.empty() || input_.max_file_size != 0) place_page(plan_);
    add_metadata(plan_, input_.manifest, input_.components);
    keep_in_store(plan_);
    sort_files();
    split();
    add(plan_, "site.json", kSiteJsonReason, site_json(input_.manifest, plan_));
    plan_.sha256 = plan_.files.back().sha256;
    split();
    if (!errors_.empty()) return std::move(errors_);
    sort_files();
    if (has_hash_list(plan_)) {
      add(plan_, kHashList, kHashListReason, hash_list(placed_files(plan_)));
      sort_files();
    }
    return std::move(plan_);
  }

  void sort_files() { std::sort(plan_.files.begin(), plan_.files.end(), by_path); }
  void split() { append(errors_, split_files(plan_, input_.max_file_size)); }

  PlanInput input_;
  SitePlan plan_;
  Diagnostics errors_;
  std::set<std::string>
      first_programs_;          ///< paths of the programs of nodes; the page preloads them
  std::size_t node_count_ = 0;  ///< of the launch; programs follow
  bool has_python_ = false;
  std::map<std::string, bool> threads_of_;  ///< by path of the program
};

}  // namespace

Outcome<SitePlan> plan_site(PlanInput input) {
  return SitePlanner(std::move(input)).plan();
}

}  // namespace ros2wasm
