// See discovery.hpp.
#include "bundler/workspace/discovery.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "bundler/io/files.hpp"
#include "bundler/workspace/cmake_packages.hpp"
#include "bundler/workspace/launch_packages.hpp"
#include "bundler/workspace/python_imports.hpp"
#include "bundler/workspace/python_modules.hpp"
#include "bundler/workspace/python_requirements.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

bool is_ignored(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "COLCON_IGNORE", error) ||
         fs::exists(folder / "AMENT_IGNORE", error) || fs::exists(folder / "CATKIN_IGNORE", error);
}

bool is_hidden(const fs::path& path) {
  return path.filename().native().starts_with('.');
}

std::vector<fs::path> sorted_subfolders(const fs::path& folder) {
  std::vector<fs::path> result;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->is_directory(error) && !is_hidden(it->path())) result.push_back(it->path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// True even for a package.xml that cannot be read, so that the package is not skipped. A folder
/// that may not be entered counts as empty.
bool has_package_xml(const fs::path& folder) {
  std::error_code error;
  return fs::exists(fs::symlink_status(folder / "package.xml", error));
}

/// The project that the CMakeLists.txt of a folder names, if it names one.
std::optional<CMakeProject> project_of(const fs::path& folder, const std::string& shown) {
  const fs::path lists = folder / "CMakeLists.txt";
  std::error_code error;
  if (!fs::is_regular_file(lists, error)) return std::nullopt;
  const auto text = read_file(lists, kMostOfText);
  return text ? cmake_project(*text, shown) : std::nullopt;
}

/// `visited` holds real paths, so that a link to a folder above does not lead round in circles.
void search(const fs::path& folder, std::set<fs::path>& visited, std::vector<fs::path>& found) {
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  if (error || !visited.insert(real).second || is_ignored(folder)) return;
  if (has_package_xml(folder)) {
    found.push_back(folder);
    return;
  }
  const std::size_t before = found.size();
  for (const fs::path& inner : sorted_subfolders(folder)) search(inner, visited, found);
  const auto inner = found.begin() + static_cast<std::ptrdiff_t>(before);
  if (std::any_of(inner, found.end(), has_package_xml) || !project_of(folder, {})) return;
  found.erase(inner, found.end());  // projects inside are parts of this one
  found.push_back(folder);
}

bool has_wildcard(std::string_view text) {
  return text.find_first_of("*?[") != std::string_view::npos;
}

void expand(const fs::path& base, const std::vector<std::string>& parts, std::size_t at,
            std::set<fs::path>& found) {
  std::error_code error;
  if (at == parts.size()) {
    if (fs::exists(base, error)) found.insert(base.lexically_normal());
    return;
  }
  if (!has_wildcard(parts[at])) {
    expand(base / parts[at], parts, at + 1, found);
    return;
  }
  if (parts[at] == "**") {
    expand(base, parts, at + 1, found);
    for (const fs::path& inner : sorted_subfolders(base)) {
      // Links may lead round in circles; `*` follows them, one level at a time.
      if (!fs::is_symlink(inner, error)) expand(inner, parts, at, found);
    }
    return;
  }
  for (fs::directory_iterator it(base, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (fnmatch(parts[at].c_str(), name.c_str(), FNM_PERIOD) == 0) {
      expand(it->path(), parts, at + 1, found);
    }
  }
}

/// Folders of a package whose Python files no node imports.
constexpr auto kOtherFolders = std::to_array<std::string_view>(
    {"build", "doc", "docs", "install", "launch", "log", "test", "tests"});
constexpr std::uintmax_t kBiggestScript = 1'000'000;  // bytes

/// A module of a node, or a script that names Python; not what builds, tests or launches it.
bool may_be_of_a_node(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  std::error_code error;
  if (name == "setup.py" || name == "conftest.py" || name.ends_with(".launch.py") ||
      !entry.is_regular_file(error) || entry.file_size(error) > kBiggestScript)
    return false;
  return entry.path().extension() == ".py" || !entry.path().has_extension();
}

/// Files of Python code below a package's folder, sorted; `own` gets the names that they may import
/// of each other.
std::vector<fs::path> python_sources(const fs::path& folder, std::set<std::string>& own) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    const bool is_folder = it->is_directory(error);
    const bool is_other = is_folder && std::find(kOtherFolders.begin(), kOtherFolders.end(),
                                                 name) != kOtherFolders.end();
    if (is_other || name.starts_with('.')) {
      if (is_folder) it.disable_recursion_pending();
    } else if (is_folder) {
      own.insert(name);
    } else if (may_be_of_a_node(*it)) {
      own.insert(it->path().stem().string());
      files.push_back(it->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> python_files(const fs::path& folder) {
  std::set<std::string> names;
  std::vector<fs::path> files = python_sources(folder, names);
  std::erase_if(files, [](const fs::path& file) {
    if (file.has_extension()) return false;
    const auto text = read_file(file, kMostOfText);
    return !text || !is_python_script(*text);
  });
  return files;
}

std::vector<Spanned<std::string>> python_modules(const fs::path& folder, const fs::path& base,
                                                 const fs::path& shown_base) {
  std::vector<Spanned<std::string>> result;
  std::set<std::string> known;
  for (const fs::path& file : python_sources(folder, known)) {
    const auto text = read_file(file, kMostOfText);
    if (!text || (!file.has_extension() && !is_python_script(*text))) continue;
    for (PythonImport& one : python_imports(*text, shown_path(file, base, shown_base))) {
      std::string name = one.module.substr(0, one.module.find('.'));
      const bool is_all_there = is_python_module(name) && needs_of_module(name).empty();
      if (!one.needed || name.empty() || is_all_there || !known.insert(name).second) continue;
      result.push_back({.value = std::move(name), .span = std::move(one.span)});
    }
  }
  return result;
}

std::vector<PythonImport> python_uses(const fs::path& folder, const fs::path& base,
                                      const fs::path& shown_base) {
  std::vector<PythonImport> result;
  std::set<std::string> own;
  using Use = std::tuple<std::string, std::vector<std::string>, std::vector<std::string>, bool>;
  std::set<Use> known;
  for (const fs::path& file : python_sources(folder, own)) {
    const auto text = read_file(file, kMostOfText);
    if (!text || (!file.has_extension() && !is_python_script(*text))) continue;
    for (PythonImport& one : python_imports(*text, shown_path(file, base, shown_base))) {
      const std::string name = one.module.substr(0, one.module.find('.'));
      if (name.empty() || is_python_module(name) || own.contains(name)) continue;
      if (known.emplace(one.module, one.names, one.attributes, one.needed).second)
        result.push_back(std::move(one));
    }
  }
  return result;
}

std::vector<Spanned<std::string>> python_requirements(const fs::path& folder, const fs::path& base,
                                                      const fs::path& shown_base) {
  std::vector<Spanned<std::string>> result;
  const auto add = [&](const char* name, auto reader) {
    const fs::path file = folder / name;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return;
    const auto text = read_file(file, kMostOfText);
    if (!text) return;
    for (auto& one : reader(*text, shown_path(file, base, shown_base)))
      result.push_back(std::move(one));
  };
  add("setup.py", requirements_of_setup);
  add("requirements.txt", requirements_of_list);
  return result;
}

/// Folders of a package whose launch files are not its own, or only of its tests.
constexpr auto kNoLaunchFolders =
    std::to_array<std::string_view>({"build", "install", "log", "test", "tests"});

std::vector<fs::path> files_to_launch(const fs::path& folder,
                                      bool (*is_one)(std::string_view name)) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (it->is_directory(error)) {
      const bool is_other = std::find(kNoLaunchFolders.begin(), kNoLaunchFolders.end(), name) !=
                            kNoLaunchFolders.end();
      if (is_other || name.starts_with('.')) it.disable_recursion_pending();
    } else if (is_one(name) && it->is_regular_file(error) &&
               it->file_size(error) <= kBiggestScript) {
      files.push_back(it->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> launch_files(const fs::path& folder) {
  return files_to_launch(folder, is_launch_file_name);
}

/// Those that the launch files and the descriptions of a package name.
std::vector<Spanned<std::string>> packages_of_launch_files(const fs::path& folder,
                                                           const fs::path& base,
                                                           const fs::path& shown_base) {
  std::vector<Spanned<std::string>> result;
  std::set<std::string> known;
  const auto add = [&](const std::vector<fs::path>& files, auto read_packages) {
    for (const fs::path& file : files) {
      const auto text = read_file(file, kMostOfText);
      if (!text) continue;
      for (Spanned<std::string>& one : read_packages(*text, shown_path(file, base, shown_base))) {
        if (known.insert(one.value).second) result.push_back(std::move(one));
      }
    }
  };
  add(launch_files(folder), launch_packages);
  add(files_to_launch(folder, is_description_name), description_packages);
  return result;
}

/// `**` leads into packages too: a plain one inside another is a part of it.
bool is_inside_another(const fs::path& real, const std::map<fs::path, fs::path>& folders) {
  for (fs::path above = real.parent_path(); above != above.root_path(); above = above.parent_path())
    if (has_package_xml(above) || folders.contains(above)) return true;
  return false;
}

Outcome<PackageXml> read_package_xml(const fs::path& folder, const fs::path& base,
                                     const fs::path& shown_base,
                                     const ConditionVariables& variables) {
  const fs::path file = folder / "package.xml";
  const auto text = read_file(file, kMostOfText);
  if (!text) return text.errors();
  return parse_package_xml(*text, shown_path(file, base, shown_base), variables);
}

/// Takes the place of the package.xml that a plain CMake package does not have.
Outcome<PackageXml> plain_package(const fs::path& folder, const fs::path& base,
                                  const fs::path& shown_base) {
  PackageXml xml{.file = shown_path(folder / "CMakeLists.txt", base, shown_base)};
  const auto project = project_of(folder, xml.file);
  if (!project)  // the file has changed since the search
    return Diagnostic{.code = "R2W0510", .message = "`" + xml.file + "` names no project"};
  xml.name = project->name;
  xml.version = {.value = project->version.empty() ? "0.0.0" : project->version,
                 .span = project->name.span};
  xml.build_type = "cmake";
  return xml;
}

void drop_equal_names(std::vector<LocalPackage>& packages) {
  std::set<std::string> names;
  for (const LocalPackage& one : packages)
    if (!one.is_plain_cmake) names.insert(one.xml.name.value);
  std::erase_if(packages, [&](const LocalPackage& one) {
    return one.is_plain_cmake && !names.insert(one.xml.name.value).second;
  });
}

}  // namespace

std::vector<fs::path> find_package_folders(const fs::path& root) {
  std::set<fs::path> visited;
  std::vector<fs::path> found;
  search(root, visited, found);
  return found;
}

std::vector<fs::path> expand_glob(const fs::path& base, const std::string& pattern) {
  std::vector<std::string> parts;
  for (const fs::path& part : fs::path(pattern)) {
    if (!part.empty() && part != ".") parts.push_back(part.string());
  }
  std::set<fs::path> found;
  expand(fs::path(pattern).is_absolute() ? fs::path() : base, parts, 0, found);
  return {found.begin(), found.end()};
}

std::string shown_path(const fs::path& path, const fs::path& base, const fs::path& shown_base) {
  const std::string relative = path.lexically_relative(base).generic_string();
  if (relative.empty() || relative.starts_with("..")) return path.string();
  const std::string shown = (shown_base / relative).lexically_normal().generic_string();
  return shown == "." ? "" : shown;
}

Outcome<std::vector<LocalPackage>> discover_packages(
    const fs::path& base, const fs::path& shown_base,
    const std::vector<Spanned<std::string>>& entries, const ConditionVariables& variables) {
  std::map<fs::path, fs::path> folders;  // real path -> as it was found first
  std::error_code error;
  Diagnostics errors;
  for (const Spanned<std::string>& entry : entries) {
    bool any = false;
    for (const fs::path& root : expand_glob(base, entry.value)) {
      for (const fs::path& folder : find_package_folders(root)) {
        folders.emplace(fs::canonical(folder, error), folder.lexically_normal());
        any = true;
      }
    }
    if (!any) {
      errors.push_back(Diagnostic{.code = "R2W0510",
                                  .message = "`" + entry.value + "` leads to no ROS package",
                                  .span = entry.span,
                                  .label = "no package.xml at or below it",
                                  .why = {"it was looked for in " + base.string()}});
    }
  }
  std::vector<fs::path> chosen;
  for (const auto& [real, folder] : folders) {
    if (has_package_xml(folder) || !is_inside_another(real, folders)) chosen.push_back(folder);
  }
  auto packages = read_packages(chosen, base, shown_base, variables);
  if (!packages) append(errors, packages.errors());
  if (!errors.empty()) return errors;
  drop_equal_names(*packages);
  order_plain_packages(*packages);
  return packages;
}

Outcome<PackageXml> package_description(const fs::path& folder, const fs::path& base,
                                        const fs::path& shown_base,
                                        const ConditionVariables& variables) {
  return has_package_xml(folder) ? read_package_xml(folder, base, shown_base, variables)
                                 : plain_package(folder, base, shown_base);
}

Outcome<std::vector<LocalPackage>> read_packages(const std::vector<fs::path>& folders,
                                                 const fs::path& base, const fs::path& shown_base,
                                                 const ConditionVariables& variables) {
  std::error_code error;
  Diagnostics errors;
  std::vector<LocalPackage> packages;
  for (const fs::path& folder : folders) {
    auto xml = package_description(folder, base, shown_base, variables);
    if (!xml) {
      append(errors, xml.errors());
      continue;
    }
    const fs::path lists = folder / "CMakeLists.txt";
    const auto cmake =
        fs::exists(lists, error) ? read_file(lists, kMostOfText) : Outcome<std::string>("");
    packages.push_back(
        {.xml = std::move(xml).value(),
         .is_plain_cmake = !has_package_xml(folder),
         .directory = folder,
         .base = base,
         .shown_base = shown_base,
         .origin = {},
         .cmake_packages = cmake_packages(cmake ? *cmake : "", shown_path(lists, base, shown_base)),
         .has_cmake_lists = cmake && !cmake->empty(),
         .python_modules = python_modules(folder, base, shown_base),
         .python_uses = python_uses(folder, base, shown_base),
         .python_requirements = python_requirements(folder, base, shown_base),
         .python_files = python_files(folder),
         .launch_files = launch_files(folder),
         .launch_packages = packages_of_launch_files(folder, base, shown_base)});
  }
  if (!errors.empty()) return errors;
  return packages;
}

void order_plain_packages(std::vector<LocalPackage>& packages) {
  std::map<std::string, bool> is_plain;
  for (const LocalPackage& one : packages) is_plain[one.xml.name.value] = one.is_plain_cmake;
  for (LocalPackage& package : packages) {
    for (const Spanned<std::string>& asked : package.cmake_packages) {
      const auto found = is_plain.find(asked.value);
      if (found == is_plain.end() || asked.value == package.xml.name.value) continue;
      const auto is_same = [&asked](const PackageDependency& one) {
        return one.kind == DependencyKind::kBuild && one.name.value == asked.value;
      };
      auto& needs = package.xml.dependencies;
      if ((package.is_plain_cmake || found->second) &&
          std::none_of(needs.begin(), needs.end(), is_same))
        needs.push_back({.kind = DependencyKind::kBuild, .name = asked, .version_limits = {}});
    }
  }
}

}  // namespace ros2wasm
