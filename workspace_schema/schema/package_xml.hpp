// package.xml, formats 1 to 3 (REP 127, 140, 149), as a value. Parsing is pure: text in, value or
// diagnostics out. The XML library ends in xml_reader.cpp.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// The purpose of a dependency. One `<depend>` yields kBuild, kBuildExport and kExec,
/// `<run_depend>` of format 1 yields kBuildExport and kExec.
enum class DependencyKind {
  kBuild,
  kBuildExport,
  kBuildTool,
  kBuildToolExport,
  kExec,
  kTest,
  kDoc,
};

struct PackageDependency {
  DependencyKind kind = DependencyKind::kBuild;
  Spanned<std::string> name;  ///< ROS package name or rosdep key
  /// Version limits as written, e.g. {"gte", "1.2.0"}; keys lt lte eq gte gt.
  std::map<std::string, std::string> version_limits;
};

struct PackageXml {
  std::string file;
  int format = 1;
  Spanned<std::string> name;
  Spanned<std::string> version;
  std::string description;  ///< white space folded
  std::vector<Spanned<std::string>> licenses;
  std::vector<std::string> maintainers;
  std::vector<Spanned<std::string>> member_of_groups;  ///< e.g. rosidl_interface_packages
  std::vector<Spanned<std::string>> group_depends;     ///< groups whose members must be built first
  std::vector<PackageDependency>
      dependencies;        ///< in the order of the file, only those whose condition holds
  std::string build_type;  ///< <export><build_type>; "catkin" by format's default when absent

  /// Names of the given kinds, sorted, each once.
  [[nodiscard]] std::vector<std::string> names_of(
      std::initializer_list<DependencyKind> kinds) const;
};

/// Values for `condition="$ROS_VERSION == 2"`. Unknown variables are empty, as in REP 149.
using ConditionVariables = std::map<std::string, std::string>;

/// ROS_VERSION=2, ROS_DISTRO=<distro>, ROS_PYTHON_VERSION=3.
[[nodiscard]] ConditionVariables ros_condition_variables(std::string_view distro);

/// Reads a package.xml; `file` is only for messages. R2W0120 not XML, R2W0121 an element is missing
/// or wrong, R2W0122 bad name or version, R2W0123 bad condition. All mistakes at once.
[[nodiscard]] Outcome<PackageXml> parse_package_xml(std::string_view text, const std::string& file,
                                                    const ConditionVariables& variables);

/// Evaluates a REP 149 condition (== != < <= > >= and or parentheses, quoted or bare literals). On
/// a syntax error returns std::nullopt.
[[nodiscard]] std::optional<bool> evaluate_condition(std::string_view condition,
                                                     const ConditionVariables& variables);

}  // namespace ros2wasm
