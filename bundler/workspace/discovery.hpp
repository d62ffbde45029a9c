// Finds packages on disk as colcon does. The only file here that reads folders.
#pragma once

#include <filesystem>
#include <vector>

#include "bundler/workspace/python_imports.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"
#include "workspace_schema/schema/package_xml.hpp"

namespace ros2wasm {

/// A package of the workspace, as its package.xml describes it.
struct LocalPackage {
  PackageXml xml;
  /// It has no package.xml: `xml` comes from its CMakeLists.txt.
  bool is_plain_cmake = false;
  std::filesystem::path directory;  ///< absolute
  /// The workspace or the source that it belongs to: its links may lead anywhere in it.
  std::filesystem::path base;
  std::filesystem::path shown_base;  ///< the same as messages name it
  /// The address and the commit that it comes from; empty: a folder of the user's.
  std::string origin;
  /// Packages that its CMakeLists.txt asks for, whether package.xml names them or not.
  std::vector<Spanned<std::string>> cmake_packages;
  /// When false, it is unknown which packages it asks CMake for.
  bool has_cmake_lists = false;
  /// Top-level modules that its Python files need and that neither Python nor its own folder has.
  std::vector<Spanned<std::string>> python_modules;
  /// All that they import of these modules, once each; also what they can do without.
  std::vector<PythonImport> python_uses;
  /// The requirements of setup.py and requirements.txt for pip.
  std::vector<Spanned<std::string>> python_requirements;
  /// Modules and scripts that a node may run, sorted; not those of tests, and not setup.py.
  std::vector<std::filesystem::path> python_files;
  std::vector<std::filesystem::path> launch_files;  ///< absolute, sorted; not those of tests
  /// Packages that its launch files start or look up.
  std::vector<Spanned<std::string>> launch_packages;
};

/// Folders of packages at or below `root`, sorted: those with a package.xml, and those whose
/// CMakeLists.txt names a project when none with a package.xml is below. A package's own folder is
/// not searched further; folders that hold COLCON_IGNORE, AMENT_IGNORE or CATKIN_IGNORE and hidden
/// folders are skipped.
[[nodiscard]] std::vector<std::filesystem::path> find_package_folders(
    const std::filesystem::path& root);

/// Paths that match a pattern with `*`, `?` and `**` (any depth) relative to `base`, sorted. A
/// pattern without these stands for itself when it exists.
[[nodiscard]] std::vector<std::filesystem::path> expand_glob(const std::filesystem::path& base,
                                                             const std::string& pattern);

/// A file or folder below `base` as messages name it: below `shown_base`, which is how the person
/// named `base`.
[[nodiscard]] std::string shown_path(const std::filesystem::path& path,
                                     const std::filesystem::path& base,
                                     const std::filesystem::path& shown_base);

/// The package in a folder as its package.xml or, without one, its CMakeLists.txt describes it.
[[nodiscard]] Outcome<PackageXml> package_description(const std::filesystem::path& folder,
                                                      const std::filesystem::path& base,
                                                      const std::filesystem::path& shown_base,
                                                      const ConditionVariables& variables);

/// The packages in these folders, in that order.
[[nodiscard]] Outcome<std::vector<LocalPackage>> read_packages(
    const std::vector<std::filesystem::path>& folders, const std::filesystem::path& base,
    const std::filesystem::path& shown_base, const ConditionVariables& variables);

/// Plain CMake packages need those of the list that their CMakeLists.txt asks for, and others need
/// a plain one that theirs asks for.
void order_plain_packages(std::vector<LocalPackage>& packages);

/// All packages that the entries name, each once, sorted by folder. A plain CMake folder with the
/// name of another package is skipped: it holds firmware or the like. R2W0510 an entry
/// leads to no package; errors of package.xml files as they are.
[[nodiscard]] Outcome<std::vector<LocalPackage>> discover_packages(
    const std::filesystem::path& base, const std::filesystem::path& shown_base,
    const std::vector<Spanned<std::string>>& entries, const ConditionVariables& variables);

}  // namespace ros2wasm
