// See channel_record.hpp.
#include "bundler/workspace/channel_record.hpp"

#include <algorithm>
#include <map>

#include "bundler/resolve/solve.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "bundler/workspace/python_tree.hpp"
#include "workspace_schema/conda/version.hpp"
#include "workspace_schema/conda/version_spec.hpp"
#include "workspace_schema/schema/package_xml.hpp"

namespace ros2wasm {
namespace {

/// Digits of a hash in a build string: enough that two builds of a version differ.
constexpr std::size_t kHashDigits = 8;
constexpr std::string_view kPythonClient = "rclpy";

bool is_for_use(DependencyKind kind) {
  return kind == DependencyKind::kExec || kind == DependencyKind::kBuildExport ||
         kind == DependencyKind::kBuildToolExport;
}

bool has(const std::vector<std::string>& sorted, std::string_view name) {
  return std::binary_search(sorted.begin(), sorted.end(), name, std::less<>());
}

bool keeps(const std::string& version, const std::string& limit) {
  const auto parsed = Version::parse(version);
  const auto spec = VersionSpec::parse(limit);
  return parsed && spec && spec->matches(*parsed);
}

/// Conda names with their limits of versions.
class Needs {
 public:
  Needs(const std::vector<LocalPackage>& packages, const KnownNames& known, std::string_view distro)
      : packages_(packages), known_(known), distro_(distro) {}

  void add(const std::string& package, const std::map<std::string, std::string>& limits) {
    const std::string name = conda_name(package, distro_);
    const auto local =
        std::find_if(packages_.begin(), packages_.end(),
                     [&package](const LocalPackage& one) { return one.xml.name.value == package; });
    if (local == packages_.end() && !has(known_.names, name)) return;
    std::vector<std::string>& own = specs_[name];
    const auto limit = [&own](std::string text) {
      if (std::find(own.begin(), own.end(), text) == own.end()) own.push_back(std::move(text));
    };
    if (local != packages_.end()) limit(">=" + local->xml.version.value);
    for (const auto& text : version_limits(limits)) {
      // One that the package here does not keep was only a warning (R2W0535): no solve could keep
      // it.
      if (local == packages_.end() || keeps(local->xml.version.value, text)) limit(text);
    }
  }

  /// Adds a name that is not one of a ROS package.
  void add_plain(std::string_view name) {
    if (has(known_.names, name)) specs_.try_emplace(std::string(name));
  }

  void add_exact(std::string_view name, std::string limit) {
    specs_[std::string(name)] = {std::move(limit)};
  }

  [[nodiscard]] std::vector<std::string> specs() const {
    std::vector<std::string> result;
    for (const auto& [name, limits] : specs_) {
      std::string spec = name;
      for (const std::string& one : limits) spec += (&one == &limits.front() ? " " : ",") + one;
      result.push_back(std::move(spec));
    }
    return result;
  }

 private:
  const std::vector<LocalPackage>& packages_;
  const KnownNames& known_;
  std::string_view distro_;
  std::map<std::string, std::vector<std::string>> specs_;
};

std::string license_of(const PackageXml& xml) {
  std::string text;
  for (const auto& one : xml.licenses) text += (text.empty() ? "" : " AND ") + one.value;
  return text;
}

}  // namespace

CondaPackage channel_record(const LocalPackage& package, const std::vector<LocalPackage>& packages,
                            const KnownNames& known, std::string_view distro, bool is_compiled,
                            const ChannelAbi& abi) {
  Needs needs(packages, known, distro);
  for (const PackageDependency& one : package.xml.dependencies) {
    if (is_for_use(one.kind)) needs.add(one.name.value, one.version_limits);
  }
  for (const auto& one : unnamed_needs(package, packages, known, distro)) needs.add(one.value, {});
  if (package.xml.build_type == kPythonBuildType) {
    needs.add_plain(kPyodidePackage);
    needs.add(std::string(kPythonClient), {});
  }
  if (is_compiled) {
    needs.add_exact(kCompilerPackage, abi.compiler_build.empty()
                                          ? abi.compiler_version + ".*"
                                          : abi.compiler_version + " " + abi.compiler_build);
    if (!abi.client_build.empty()) needs.add_exact(kClientAbiPackage, "* " + abi.client_build);
  }
  return {.name = conda_name(package.xml.name.value, distro),
          .version = package.xml.version.value,
          .build = {},
          .subdir = is_compiled ? "emscripten-wasm32" : "noarch",
          .noarch = is_compiled ? NoarchKind::kNo : NoarchKind::kGeneric,
          .depends = needs.specs(),
          .constrains = {},
          .entry_points = {},
          .license = license_of(package.xml),
          .license_files = {},
          .summary = package.xml.description,
          .home = {},
          .source = package.origin,
          .placeholder = {}};
}

std::string channel_build_string(const CondaPackage& package, const ChannelAbi& abi,
                                 std::string_view files_hash) {
  std::string tag;
  if (package.subdir != "noarch") {
    tag = "em";
    for (const char c : abi.compiler_version)
      if (c != '.') tag += c;
    tag += "_";
  }
  return tag + "h" + std::string(files_hash.substr(0, kHashDigits)) + "_" +
         std::to_string(package.build_number);
}

}  // namespace ros2wasm
