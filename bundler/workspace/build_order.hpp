// From package.xml files to the order of building, and to what must come from channels. Pure.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bundler/workspace/discovery.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// A package that a local package wants and the workspace has not.
struct ExternalDependency {
  std::string name;                ///< as package.xml says it
  std::string match_spec;          ///< conda: "ros-jazzy-std-msgs >=5.0"
  bool needed_to_build = false;    ///< else only when nodes run
  bool can_be_missing = true;      ///< no package is skipped for it
  std::vector<SourceSpan> places;  ///< where it is asked for; the first is shown
};

struct BuildOrder {
  std::vector<std::size_t>
      order;  ///< indices of packages: what is needed stands before what needs it
  /// For each package (by index) the indices of the local packages it needs, directly or not, in
  /// build order.
  std::vector<std::vector<std::size_t>> needs;
  std::vector<ExternalDependency> external;  ///< sorted by name
};

/// Conda's name of a ROS package (`ros-jazzy-std-msgs`), or of a library by its rosdep key.
[[nodiscard]] std::string conda_name(std::string_view package, std::string_view distro);

/// The ROS package names among conda names, as far as a name tells: `-` becomes `_`. Sorted.
[[nodiscard]] std::vector<std::string> ros_names(const std::vector<std::string>& conda_names,
                                                 std::string_view distro);

/// R2W0511 for each package whose name an earlier one has.
[[nodiscard]] Diagnostics duplicate_names(const std::vector<LocalPackage>& packages);

/// R2W0511 two packages of one name, R2W0512 packages that need each other. All at once.
[[nodiscard]] Outcome<BuildOrder> order_packages(const std::vector<LocalPackage>& packages,
                                                 std::string_view distro);

/// The limits of a dependency as match specs have them: ">=1.2", "<2". In the order of their keys.
[[nodiscard]] std::vector<std::string> version_limits(
    const std::map<std::string, std::string>& limits);

/// The dependencies of the packages that are not in the workspace, sorted by name. Dependencies of
/// the packages in `left_out` do not count.
[[nodiscard]] std::vector<ExternalDependency> external_dependencies(
    const std::vector<LocalPackage>& packages, const std::set<std::size_t>& left_out,
    std::string_view distro);

[[nodiscard]] bool matters_for_building(DependencyKind kind);

/// Does a package stay out of the site when nobody has a dependency? Not one in Python, whose
/// imports tell what it needs (R2W0518), nor one whose CMakeLists.txt does not ask for it, as far
/// as its text tells.
[[nodiscard]] bool cannot_be_missing(const LocalPackage& package,
                                     const PackageDependency& dependency);

/// Names of packages, sorted, and whose they are.
struct KnownNames {
  std::vector<std::string> names;
  bool of_lock = false;  ///< those of a lock, which says nothing of what else the channels have
  std::vector<std::string> absent;  ///< of a lock: what no channel had, sorted
};

/// Is it known that no channel has a package? A lock only knows about packages that were searched
/// for.
[[nodiscard]] bool is_absent(std::string_view package, const KnownNames& known,
                             std::string_view distro);

/// The conda name of a package that `package` was most likely meant to be, if there is one.
[[nodiscard]] std::optional<std::string> similar_name(std::string_view package,
                                                      const KnownNames& known,
                                                      std::string_view distro);

/// Dependencies that no channel has, each with the line that names it: R2W0513. Those that can be
/// missing become warnings of the same code. With a lock, only those that matter when nodes run,
/// and those that no channel had, are reported here; check_solution() reports the others.
[[nodiscard]] Diagnostics missing_dependencies(const std::vector<ExternalDependency>& external,
                                               const KnownNames& known, std::string_view distro);

}  // namespace ros2wasm
