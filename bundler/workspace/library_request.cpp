// See library_request.hpp.
#include "bundler/workspace/library_request.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "bundler/workspace/python_modules.hpp"
#include "bundler/workspace/wheel_request.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/wheel_requirement.hpp"

namespace ros2wasm {
namespace {

/// The distribution has them, and what they are for needs sockets or windows: an import alone does
/// not ask for them.
constexpr std::array<std::string_view, 5> kNotByImport = {"aiohttp", "httpx", "pygame", "requests",
                                                          "urllib3"};

/// They open windows, which this package of a channel makes panels of the page.
constexpr std::array<std::string_view, 2> kWithWindows = {"matplotlib", "pillow"};
constexpr std::string_view kPanels = "ros2wasm_figures";

bool has(const std::vector<std::string>& sorted, std::string_view name) {
  return std::binary_search(sorted.begin(), sorted.end(), name, std::less<>());
}

std::string top_level(const std::string& module) {
  return module.substr(0, module.find('.'));
}

bool channel_has(const std::string& module, const KnownNames& known, std::string_view distro) {
  const std::string name(package_of_module(module));
  return has(known.names, conda_name(name, distro)) || has(known.names, ascii_lower(name));
}

class Request {
 public:
  explicit Request(const LibraryQuestion& question) : question_(question) {}

  Outcome<LibraryRequest> run() {
    ask_of_manifest();
    for (std::size_t i = 0; i < question_.packages.size(); ++i)
      if (!question_.left_out.contains(i)) ask_of_package(question_.packages[i]);
    for (const auto& module : question_.notebook_modules)
      ask_of_import({.module = module.value, .names = {}, .span = module.span}, nullptr);
    ask_of_wheels();
    if (!errors_.empty()) return errors_;
    take_what_is_needed();
    ask_for_panels();
    for (std::size_t i = 0; i < question_.packages.size(); ++i) {
      if (question_.left_out.contains(i)) continue;
      for (const auto& one : question_.packages[i].python_requirements) compare(one);
    }
    for (const auto& one : question_.manifest.python_packages) compare(one);
    for (auto& [project, library] : taken_) result_.libraries.push_back(std::move(library));
    return std::move(result_);
  }

 private:
  void ask_of_manifest() {
    for (const Spanned<std::string>& one : question_.manifest.python_packages) {
      const std::string project =
          library_project(wheel_requirement(one.value)->project, question_.libraries);
      if (!project.empty()) {
        asked_.insert(project);
        continue;
      }
      std::vector<std::string> names;
      for (const auto& [name, library] : question_.libraries.by_project) names.push_back(name);
      Diagnostic unknown{.code = "R2W0127",
                         .message = "Pyodide's distribution has no library `" + one.value + "`",
                         .span = one.span,
                         .label = "not among its " + std::to_string(names.size()) + " libraries",
                         .why = {"a wheel of it can be named under `python: wheels:`"}};
      if (const auto similar = nearest(one.value, names))
        unknown.fix.push_back("write `" + *similar + "`");
      errors_.push_back(std::move(unknown));
    }
  }

  [[nodiscard]] bool is_local(const std::string& module) const {
    return std::any_of(question_.packages.begin(), question_.packages.end(),
                       [&](const LocalPackage& one) { return one.xml.name.value == module; });
  }

  [[nodiscard]] bool names_key(const LocalPackage& package, const std::string& project) const {
    return std::any_of(package.xml.dependencies.begin(), package.xml.dependencies.end(),
                       [&](const PackageDependency& one) {
                         return library_project(one.name.value, question_.libraries) == project;
                       });
  }

  void ask_of_package(const LocalPackage& package) {
    for (const PythonImport& one : package.python_uses) ask_of_import(one, &package);
  }

  /// `package`: where the import stands; none: in the notebook.
  void ask_of_import(const PythonImport& one, const LocalPackage* package) {
    const std::string top = top_level(one.module);
    const auto found = question_.libraries.project_of.find(top);
    if (found == question_.libraries.project_of.end() || is_local(top)) return;
    const bool is_refused =
        std::find(kNotByImport.begin(), kNotByImport.end(), top) != kNotByImport.end();
    const bool is_wanted =
        (one.needed && !is_refused) || (package != nullptr && names_key(*package, found->second));
    const bool is_met = channel_has(top, question_.known, question_.manifest.distro) &&
                        stand_in_has(one.module, one.names, one.attributes).value_or(true);
    if (is_wanted && !is_met) asked_.insert(found->second);
  }

  void ask_of_wheels() {
    for (const NamedWheel& wheel : question_.wheels) {
      for (const std::string& text : wheel.wheel.requirements) {
        const auto need = wheel_requirement(text);
        if (need && need->applies && !channel_name(need->project)) {
          const std::string project = library_project(need->project, question_.libraries);
          if (!project.empty()) asked_.insert(project);
        }
      }
    }
  }

  /// The package of a channel that is all of the project.
  [[nodiscard]] std::optional<std::string> channel_name(const std::string& project) const {
    if (stand_in_has(project, {})) return std::nullopt;
    std::string name =
        python_package_name(project, question_.known.names, question_.manifest.distro);
    if (name.empty()) return std::nullopt;
    return name;
  }

  [[nodiscard]] bool is_wheel(const std::string& project) const {
    return std::any_of(question_.wheels.begin(), question_.wheels.end(),
                       [&](const NamedWheel& one) { return one.locked.project == project; });
  }

  void take_what_is_needed() {
    std::vector<std::string> open(asked_.begin(), asked_.end());
    while (!open.empty()) {
      const std::string project = std::move(open.back());
      open.pop_back();
      const auto row = question_.libraries.by_project.find(project);
      if (row == question_.libraries.by_project.end() || is_wheel(project) ||
          taken_.contains(project))
        continue;
      const auto from_channel = channel_name(project);
      if (from_channel && !asked_.contains(project)) {
        result_.specs.push_back({.text = *from_channel,
                                 .origin = "a library of Pyodide's distribution",
                                 .span = std::nullopt});
        continue;
      }
      taken_.emplace(project, row->second);
      open.insert(open.end(), row->second.depends.begin(), row->second.depends.end());
    }
  }

  void ask_for_panels() {
    const std::string package = conda_name(kPanels, question_.manifest.distro);
    const bool has_windows =
        std::any_of(kWithWindows.begin(), kWithWindows.end(), [&](std::string_view project) {
          return taken_.contains(std::string(project)) || is_wheel(std::string(project));
        });
    if (has_windows && has(question_.known.names, package))
      result_.specs.push_back({.text = package,
                               .origin = "windows of a library of Pyodide's distribution",
                               .span = std::nullopt});
  }

  void compare(const Spanned<std::string>& wish) {
    const auto wanted = wheel_requirement(wish.value);
    if (!wanted || !wanted->applies) return;
    const auto found = taken_.find(library_project(wanted->project, question_.libraries));
    if (found == taken_.end() || fits_versions(found->second.version, wanted->versions)) return;
    if (!told_.insert(found->first + wanted->versions).second) return;
    result_.warnings.push_back(
        {.code = "R2W0247",
         .severity = Severity::kWarning,
         .message = "a site has `" + found->first + "` " + found->second.version + ", and not `" +
                    wish.value + "`",
         .span = wish.span,
         .label = "asks for another version",
         .why = {"libraries of Pyodide's distribution have one version each",
                 "a wheel of another version, made for sites, can be named under `python: "
                 "wheels:`"}});
  }

  const LibraryQuestion& question_;
  std::set<std::string> asked_;
  std::map<std::string, LockedLibrary> taken_;
  std::set<std::string> told_;
  LibraryRequest result_;
  Diagnostics errors_;
};

}  // namespace

Outcome<LibraryRequest> library_request(const LibraryQuestion& question) {
  return Request(question).run();
}

void drop_met_by_libraries(const std::vector<LockedLibrary>& locked,
                           const PythonLibraries& libraries, const KnownNames& known,
                           std::string_view distro, std::vector<LocalPackage>& packages) {
  std::set<std::string> projects;
  for (const LockedLibrary& one : locked) projects.insert(one.project);
  const auto is_met = [&](const std::string& name) {
    return !has(known.names, conda_name(name, distro)) &&
           projects.contains(library_project(name, libraries));
  };
  for (LocalPackage& package : packages) {
    std::erase_if(package.xml.dependencies,
                  [&](const PackageDependency& one) { return is_met(one.name.value); });
  }
}

}  // namespace ros2wasm
