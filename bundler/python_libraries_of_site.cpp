// See python_libraries_of_site.hpp.
#include "bundler/python_libraries_of_site.hpp"

#include <algorithm>

#include "bundler/io/files.hpp"
#include "bundler/io/installation.hpp"
#include "bundler/site_components.hpp"
#include "bundler/store/library_files.hpp"
#include "bundler/workspace/library_request.hpp"
#include "bundler/workspace/python_tree.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/conda/wheel_requirement.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

using Needs = std::map<std::string, std::vector<std::string>>;

std::string installed(const std::string& path) {
  return std::string(kPythonModules) + "/" + path;
}

std::string file_name(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

/// Projects that a wheel requires.
std::vector<std::string> required_by(const Wheel& wheel) {
  std::vector<std::string> projects;
  for (const std::string& text : wheel.requirements) {
    const auto need = wheel_requirement(text);
    if (need && need->applies) projects.push_back(need->project);
  }
  std::sort(projects.begin(), projects.end());
  return projects;
}

std::set<std::string> top_modules(const Wheel& wheel) {
  std::set<std::string> modules;
  for (const auto& [path, bytes] : wheel.files) {
    if (path.ends_with(".py") || wheel.side_modules.contains(path))
      modules.insert(path.substr(0, path.find_first_of("/.")));
  }
  return modules;
}

/// Libraries that others need come first.
std::vector<std::string> in_load_order(const Needs& needed) {
  std::set<std::string> all;
  for (const auto& [name, needs] : needed) all.insert(name);
  return libraries_in_order(all, needed);
}

/// The files of a wheel, and those of its compiled modules that others of it need.
LibraryInput of_wheel(const Wheel& wheel) {
  LibraryInput input;
  for (const auto& [path, bytes] : wheel.files) input.files.emplace(installed(path), bytes);
  std::set<std::string> names;
  for (const auto& [path, needed] : wheel.side_modules) names.insert(needed.begin(), needed.end());
  std::map<std::string, std::string> places;
  Needs libraries;
  for (const auto& [path, needed] : wheel.side_modules) {
    if (names.contains(file_name(path)) && places.emplace(file_name(path), path).second)
      libraries.emplace(file_name(path), needed);
  }
  for (const std::string& name : in_load_order(libraries))
    input.load.push_back(installed(places.at(name)));
  return input;
}

LibraryInput of_shared(const SharedLibraries& shared) {
  constexpr std::string_view kFolder = "lib/";
  LibraryInput input;
  for (const std::string& name : in_load_order(shared.needed)) {
    input.load.push_back(std::string(kFolder) + name);
    input.files.emplace(std::string(kFolder) + name, shared.files.at(name));
  }
  return input;
}

/// R2W0245 for each compiled module that needs a library which is not there.
Diagnostics unmet_needs(const std::string& archive, const Needs& modules,
                        const std::set<std::string>& libraries) {
  Diagnostics errors;
  for (const auto& [path, needed] : modules) {
    for (const std::string& one : needed) {
      if (!libraries.contains(one))
        errors.push_back(refused_side_module(
            archive, path, "needs `" + one + "`, which no library of the site has"));
    }
  }
  return errors;
}

/// Whether there is anything that could ask for a library.
bool has_python(const Manifest& manifest, const std::vector<LocalPackage>& packages,
                const std::vector<NamedWheel>& wheels,
                const std::vector<Spanned<std::string>>& notebook_modules) {
  return !manifest.python_packages.empty() || manifest.python_lock || !wheels.empty() ||
         !notebook_modules.empty() ||
         std::any_of(packages.begin(), packages.end(),
                     [](const LocalPackage& one) { return !one.python_uses.empty(); });
}

bool is_asked(const Manifest& manifest, const LibrarySupply& python, const std::string& project) {
  const auto& asked = manifest.python_packages;
  return std::any_of(asked.begin(), asked.end(), [&](const Spanned<std::string>& one) {
    return library_project(wheel_requirement(one.value)->project, python.offered) == project;
  });
}

}  // namespace

Outcome<PythonLibraries> offered_libraries(const fs::path& executable, const Manifest& manifest,
                                           const fs::path& folder) {
  if (manifest.python_lock) {
    const auto text = read_file(folder / manifest.python_lock->value, kMostOfList);
    auto read = text ? read_python_libraries(*text, manifest.python_lock->value)
                     : Outcome<PythonLibraries>(text.errors());
    if (read) return read;
    Diagnostics errors = std::move(read).errors();
    for (Diagnostic& one : errors)
      if (!one.span) one.span = manifest.python_lock->span;
    return errors;
  }
  const auto file =
      find_own_data(executable, "runtime/python_libraries.json", "the list of Python libraries");
  if (!file) return file.errors();
  const auto text = read_file(*file, kMostOfList);
  if (!text) return text.errors();
  return read_python_libraries(*text, file->string());
}

bool takes_libraries(const Manifest& manifest) {
  return !manifest.python_index || manifest.python_index->value != kNoPythonIndex;
}

Outcome<AskedLibraries> ask_for_libraries(const fs::path& executable,
                                          const std::vector<NamedWheel>& wheels,
                                          const KnownNames& known,
                                          const std::vector<Spanned<std::string>>& notebook_modules,
                                          const ReadWorkspace& read,
                                          std::vector<LocalPackage>& packages, PackNotes& notes) {
  const Manifest& manifest = read.manifest;
  AskedLibraries result;
  if (!has_python(manifest, packages, wheels, notebook_modules)) return result;
  auto offered = offered_libraries(executable, manifest, read.folder);
  if (!offered) return std::move(offered).errors();
  result.supply.offered = std::move(*offered);
  if (manifest.python_lock) notes.watched.push_back(read.folder / manifest.python_lock->value);
  if (!takes_libraries(manifest)) return result;
  auto asked = library_request({.manifest = manifest,
                                .packages = packages,
                                .left_out = {},
                                .wheels = wheels,
                                .known = known,
                                .notebook_modules = notebook_modules,
                                .libraries = result.supply.offered});
  if (!asked) return std::move(asked).errors();
  result.supply.asked = std::move(asked->libraries);
  if (!result.supply.asked.empty())
    result.supply.index =
        manifest.python_index ? manifest.python_index->value : result.supply.offered.index;
  append(notes.warnings, asked->warnings);
  drop_met_by_libraries(result.supply.asked, result.supply.offered, known, manifest.distro,
                        packages);
  result.specs = std::move(asked->specs);
  return result;
}

SiteLibraries site_libraries(const Supplies& supplies) {
  SiteLibraries result;
  for (const LockedLibrary& one : supplies.python.asked) result.depends[one.project] = one.depends;
  for (const auto& [module, project] : supplies.python.offered.project_of)
    if (result.depends.contains(project)) result.project_of.emplace(module, project);
  for (const NamedWheel& one : supplies.wheels) {
    if (one.wheel.side_modules.empty()) continue;
    result.depends[one.locked.project] = required_by(one.wheel);
    for (const std::string& module : top_modules(one.wheel))
      result.project_of[module] = one.locked.project;
  }
  return result;
}

std::set<std::string> named_libraries(const Manifest& manifest, const Supplies& supplies) {
  std::set<std::string> result;
  for (const LockedLibrary& one : supplies.python.asked)
    if (is_asked(manifest, supplies.python, one.project)) result.insert(one.project);
  for (const NamedWheel& one : supplies.wheels)
    if (!one.wheel.side_modules.empty()) result.insert(one.locked.project);
  return result;
}

bool hide_replaced(const Manifest& manifest, const Supplies& supplies,
                   const std::set<std::string>& reached, PythonFiles& channels) {
  const SiteLibraries libraries = site_libraries(supplies);
  std::set<std::string> needed;
  for (std::string& one : libraries_in_order(reached, libraries.depends))
    needed.insert(std::move(one));
  bool any = false;
  for (const auto& [module, project] : libraries.project_of) {
    if (!needed.contains(project) && !is_asked(manifest, supplies.python, project)) continue;
    const std::string base = installed(module);
    any = std::erase_if(channels,
                        [&](const auto& file) {
                          const std::string& path = file.first;
                          return path.starts_with(base) && path.size() > base.size() &&
                                 (path[base.size()] == '/' || path[base.size()] == '.');
                        }) > 0 ||
          any;
  }
  return any;
}

Outcome<Done> add_libraries(const BuiltWorkspace& workspace, const std::set<std::string>& reached,
                            PythonInput& python, std::vector<SiteComponent>& components,
                            PackNotes& notes, const Cancellation& cancellation) {
  const Supplies& supplies = workspace.supplies;
  const std::vector<LockedLibrary>& asked = supplies.python.asked;
  const std::string& index = supplies.python.index;
  const SiteLibraries libraries = site_libraries(supplies);
  python.library_needs = libraries.depends;
  std::vector<LockedLibrary> wanted;
  std::set<std::string> loaded;
  Diagnostics errors;
  for (const std::string& project : libraries_in_order(reached, libraries.depends)) {
    const auto locked = std::find_if(asked.begin(), asked.end(), [&](const LockedLibrary& one) {
      return one.project == project;
    });
    if (locked != asked.end()) wanted.push_back(*locked);
  }
  auto read = read_libraries(wanted, index, supplies.roots, supplies.limits, cancellation);
  if (!read) return std::move(read).errors();
  if (!is_network_url(index)) {
    for (const LockedLibrary& one : wanted)
      notes.watched.push_back(workspace.read.folder / index / one.file);
  }
  std::vector<std::pair<std::string, const Needs*>> modules;
  const auto add = [&](const std::string& project, const std::string& file, LibraryInput input,
                       const Needs& needs) {
    for (const std::string& path : input.load) loaded.insert(file_name(path));
    modules.emplace_back(file, &needs);
    python.libraries.emplace(project, std::move(input));
  };
  for (const LibraryFiles& one : *read) {
    const bool is_wheel = one.shared.files.empty();
    add(one.locked.project, one.locked.file, is_wheel ? of_wheel(one.wheel) : of_shared(one.shared),
        is_wheel ? one.wheel.side_modules : one.shared.needed);
    components.push_back(library_component(one, index + (index.ends_with('/') ? "" : "/")));
  }
  for (const NamedWheel& one : supplies.wheels) {
    if (!one.wheel.side_modules.empty())
      add(one.locked.project, one.file_name, of_wheel(one.wheel), one.wheel.side_modules);
  }
  for (const auto& [file, needs] : modules) append(errors, unmet_needs(file, *needs, loaded));
  if (!errors.empty()) return errors;
  return Done{};
}

}  // namespace ros2wasm
