// See channel_request.hpp.
#include "bundler/workspace/channel_request.hpp"

#include <algorithm>
#include <set>

#include "bundler/workspace/host_packages.hpp"
#include "bundler/workspace/launch_packages.hpp"
#include "bundler/workspace/library_packages.hpp"
#include "bundler/workspace/python_modules.hpp"
#include "bundler/workspace/python_tree.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/names.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/conda/version.hpp"
#include "workspace_schema/conda/version_spec.hpp"

namespace ros2wasm {
namespace {

/// Parts of the C++ library that the site's compiler lacks. Every package may use them, and none
/// names them.
constexpr std::string_view kLibraryParts = "ros2wasm_std";
/// The package with files that every C++ program needs, with or without ROS.
constexpr std::string_view kCore = "ros2wasm_core";
/// Brings Pyodide, and the kernel of notebooks.
constexpr std::string_view kPythonClient = "rclpy";

bool has(const std::vector<std::string>& sorted, std::string_view name) {
  return std::binary_search(sorted.begin(), sorted.end(), name, std::less<>());
}

/// Dependencies that CMakeLists.txt, Python imports or a launch file need, that a channel has, and
/// that package.xml does not list. With a full installation of ROS 2 nobody notices them.
std::vector<Spanned<std::string>> forgotten(const LocalPackage& package,
                                            const std::vector<LocalPackage>& packages,
                                            const KnownNames& known, std::string_view distro) {
  std::vector<Spanned<std::string>> result;
  const auto is_local = [&](const std::string& name) {
    return std::any_of(packages.begin(), packages.end(),
                       [&](const LocalPackage& one) { return one.xml.name.value == name; });
  };
  const auto is_named = [&](const std::string& wanted) {
    return std::any_of(
        package.xml.dependencies.begin(), package.xml.dependencies.end(),
        [&](const PackageDependency& one) { return conda_name(one.name.value, distro) == wanted; });
  };
  std::vector<Spanned<std::string>> uses = package.cmake_packages;
  uses.insert(uses.end(), package.launch_packages.begin(), package.launch_packages.end());
  for (const Spanned<std::string>& module : package.python_modules) {
    if (is_local(module.value)) continue;
    std::string name(package_of_module(module.value));
    // The module is not from a ROS package, but from a package with the name of the module.
    if (!has(known.names, conda_name(name, distro)) && has(known.names, ascii_lower(name)))
      name = "python3-" + ascii_lower(name);
    uses.push_back({.value = std::move(name), .span = module.span});
  }
  std::set<std::string> asked;
  for (Spanned<std::string>& one : uses) {
    const std::string wanted = conda_name(one.value, distro);
    if (!host_package_reason(one.value).empty() || is_local(one.value) || is_named(wanted))
      continue;
    if (has(known.names, wanted) && asked.insert(wanted).second) result.push_back(std::move(one));
  }
  return result;
}

/// Further packages that the imported modules of a package need, if the channels have them.
std::vector<Spanned<std::string>> module_needs(const LocalPackage& package, const KnownNames& known,
                                               std::string_view distro) {
  std::vector<Spanned<std::string>> result;
  for (const Spanned<std::string>& module : package.python_modules) {
    for (const std::string_view need : needs_of_module(module.value)) {
      if (has(known.names, conda_name(need, distro)))
        result.push_back({.value = std::string(need), .span = module.span});
    }
  }
  return result;
}

RequestedSpec spec_of(const Spanned<std::string>& package, std::string_view distro) {
  return {
      .text = conda_name(package.value, distro), .origin = package.span.file, .span = package.span};
}

Diagnostic forgotten_warning(const LocalPackage& package,
                             const std::vector<Spanned<std::string>>& names) {
  std::string lines;
  for (const Spanned<std::string>& one : names) lines += "<depend>" + one.value + "</depend>";
  return Diagnostic{.code = "R2W0515",
                    .severity = Severity::kWarning,
                    .message = "package `" + package.xml.name.value + "` uses " +
                               (names.size() == 1 ? "a package" : "packages") +
                               " that its package.xml does not name",
                    .span = names.front().span,
                    .label = "asked for here",
                    .why = {"it is taken from the channels all the same"},
                    .fix = {"add `" + lines + "` to package.xml"}};
}

/// R2W0535 for each limit of versions that a package of the workspace does not keep. colcon does
/// not look at them.
Diagnostics other_versions(const std::vector<LocalPackage>& packages,
                           const std::set<std::size_t>& ignored) {
  Diagnostics warnings;
  std::set<std::string> said;
  for (std::size_t i = 0; i < packages.size(); ++i) {
    if (ignored.contains(i)) continue;
    for (const PackageDependency& need : packages[i].xml.dependencies) {
      std::string limits;
      for (const std::string& one : version_limits(need.version_limits))
        limits += (limits.empty() ? "" : ",") + one;
      if (limits.empty()) continue;
      const auto found = std::find_if(
          packages.begin(), packages.end(),
          [&need](const LocalPackage& one) { return one.xml.name.value == need.name.value; });
      if (found == packages.end()) continue;
      const std::string& there = found->xml.version.value;
      const auto version = Version::parse(there);
      const auto spec = VersionSpec::parse(limits);
      if (!version || !spec || spec->matches(*version)) continue;
      const std::string message = "package `" + packages[i].xml.name.value + "` asks for `" +
                                  need.name.value + " " + limits + "`, and version " + there +
                                  " is built";
      if (!said.insert(message).second) continue;
      warnings.push_back(Diagnostic{.code = "R2W0535",
                                    .severity = Severity::kWarning,
                                    .message = message,
                                    .span = need.name.span});
    }
  }
  return warnings;
}

/// Conda names that no channel has: those for which packages are skipped, and those that the other
/// packages may lack.
std::vector<std::string> absent_names(const std::vector<LocalPackage>& packages,
                                      const LeftOutPackages& left_out,
                                      const std::vector<ExternalDependency>& external,
                                      const KnownNames& known, std::string_view distro) {
  std::set<std::string> names;
  for (const ExternalDependency& one : external) {
    if (one.needed_to_build && is_absent(one.name, known, distro))
      names.insert(conda_name(one.name, distro));
  }
  for (const auto& [index, reason] : left_out) {
    for (const PackageDependency* one :
         lacking_dependencies(packages[index], packages, known, distro))
      names.insert(conda_name(one->name.value, distro));
  }
  return {names.begin(), names.end()};
}

/// Requests the packages that run the cells of the page's notebook, and those that the cells
/// import, if the channels have them.
template <typename IsLocal>
void append_notebook(const Manifest& manifest, const std::vector<Spanned<std::string>>& modules,
                     const IsLocal& is_local, const KnownNames& known,
                     std::vector<RequestedSpec>& specs) {
  if (!manifest.ui_notebook) return;
  const auto ask = [&](std::string_view package, const SourceSpan& span) {
    const std::string name = conda_name(package, manifest.distro);
    if (has(known.names, name)) specs.push_back({.text = name, .origin = span.file, .span = span});
  };
  ask(kPythonClient, manifest.ui_notebook->span);
  for (const Spanned<std::string>& module : modules) {
    if (!is_local(module.value)) ask(package_of_module(module.value), module.span);
    for (const std::string_view need : needs_of_module(module.value)) ask(need, module.span);
  }
}

}  // namespace

std::vector<Spanned<std::string>> unnamed_needs(const LocalPackage& package,
                                                const std::vector<LocalPackage>& packages,
                                                const KnownNames& known, std::string_view distro) {
  auto needs = forgotten(package, packages, known, distro);
  for (auto& one : module_needs(package, known, distro)) needs.push_back(std::move(one));
  return needs;
}

std::string dependency_spec(const std::string& text, std::string_view distro,
                            const std::vector<std::string>& channel_names) {
  const auto end = text.find_first_of(" <>=!~[");
  const std::string name = text.substr(0, end);
  const std::string rest = end == std::string::npos ? "" : text.substr(end);
  if (name.find("::") != std::string::npos || has(channel_names, name)) return text;
  if (const std::string_view library = library_package(name); !library.empty())
    return std::string(library) + rest;
  const std::string ros_name = conda_name(name, distro);
  const bool is_ros_name = !package_name_fault(name);  // not a file or an address
  const bool looks_like_ros =
      is_ros_name && (name.find('_') != std::string::npos || has(channel_names, ros_name));
  return looks_like_ros ? ros_name + rest : text;
}

Outcome<ChannelRequest> channel_request(const Manifest& manifest,
                                        const std::vector<LocalPackage>& packages,
                                        const LeftOutPackages& left_out, const KnownNames& known,
                                        const std::string& compiler_version,
                                        const std::vector<Spanned<std::string>>& notebook_modules) {
  ChannelRequest request;
  Diagnostics errors;
  std::set<std::size_t> ignored;
  for (const auto& [index, reason] : left_out) ignored.insert(index);
  const auto external = external_dependencies(packages, ignored, manifest.distro);
  for (Diagnostic& one : missing_dependencies(external, known, manifest.distro)) {
    (one.severity == Severity::kError ? errors : request.warnings).push_back(std::move(one));
  }
  if (!errors.empty()) return errors;
  append(request.warnings, other_versions(packages, ignored));

  request.absent = absent_names(packages, left_out, external, known, manifest.distro);
  for (const ExternalDependency& dependency : external) {
    if (!has(known.names, conda_name(dependency.name, manifest.distro)) &&
        !(known.of_lock && dependency.needed_to_build &&
          !is_absent(dependency.name, known, manifest.distro)))
      continue;
    request.specs.push_back({.text = dependency.match_spec,
                             .origin = dependency.places.front().file,
                             .span = dependency.places.front()});
  }
  for (std::size_t i = 0; i < packages.size(); ++i) {
    if (ignored.contains(i)) continue;
    const LocalPackage& package = packages[i];
    for (const auto& one : module_needs(package, known, manifest.distro))
      request.specs.push_back(spec_of(one, manifest.distro));
    auto names = forgotten(package, packages, known, manifest.distro);
    for (const auto& one : names) request.specs.push_back(spec_of(one, manifest.distro));
    // Natively no package.xml names it.
    std::erase_if(names, [](const auto& one) { return one.value == kSimulatorPackage; });
    if (!names.empty() && !package.is_plain_cmake)
      request.warnings.push_back(forgotten_warning(package, names));
  }
  for (const LocalPackage& package : packages) {
    if (package.xml.build_type != kPythonBuildType) continue;
    // The client library starts every Python program, one that has no node too.
    for (const std::string& name :
         {std::string(kPyodidePackage), conda_name(kPythonClient, manifest.distro)}) {
      if (!has(known.names, name)) continue;
      request.specs.push_back(
          {.text = name, .origin = package.xml.name.span.file, .span = package.xml.name.span});
    }
  }
  if (manifest.launch_file && manifest.launch_file->value.ends_with(".py") &&
      has(known.names, kPyodidePackage)) {
    request.specs.push_back({.text = std::string(kPyodidePackage),
                             .origin = manifest.launch_file->span.file,
                             .span = manifest.launch_file->span});
  }
  for (const Spanned<std::string>& dependency : manifest.dependencies) {
    if (!host_package_reason(dependency.value).empty()) continue;
    request.specs.push_back(
        {.text = dependency_spec(dependency.value, manifest.distro, known.names),
         .origin = manifest.file,
         .span = dependency.span});
  }
  const auto is_local = [&](const std::string& name) {
    return std::any_of(packages.begin(), packages.end(),
                       [&](const LocalPackage& one) { return one.xml.name.value == name; });
  };
  const auto want = [&](const Spanned<std::string>& package) {
    const std::string name = conda_name(package.value, manifest.distro);
    if (is_local(package.value) || !has(known.names, name)) return;
    request.specs.push_back({.text = name, .origin = manifest.file, .span = package.span});
  };
  for (const NodeEntry& node : manifest.nodes) want(node.package);
  for (const ProgramEntry& program : manifest.programs) want(program.package);
  append_notebook(manifest, notebook_modules, is_local, known, request.specs);
  const auto want_for_builds = [&](std::string_view package) {
    const std::string name = conda_name(package, manifest.distro);
    if (has(known.names, name))
      request.specs.push_back(
          {.text = name, .origin = "the toolchain of sites", .span = std::nullopt});
  };
  if (!packages.empty()) want_for_builds(kLibraryParts);
  if (std::any_of(packages.begin(), packages.end(),
                  [](const LocalPackage& one) { return one.xml.build_type != kPythonBuildType; }))
    want_for_builds(kCore);
  if (!compiler_version.empty() && has(known.names, kCompilerPackage)) {
    request.specs.push_back({.text = std::string(kCompilerPackage) + " " + compiler_version + ".*",
                             .origin = "Emscripten " + compiler_version + " of this machine",
                             .span = std::nullopt});
  }
  std::stable_sort(request.specs.begin(), request.specs.end(),
                   [](const RequestedSpec& a, const RequestedSpec& b) { return a.text < b.text; });
  const auto repeated =
      std::unique(request.specs.begin(), request.specs.end(),
                  [](const RequestedSpec& a, const RequestedSpec& b) { return a.text == b.text; });
  request.specs.erase(repeated, request.specs.end());
  return request;
}

}  // namespace ros2wasm
