// See foreign_packages.hpp.
#include "bundler/build/foreign_packages.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "bundler/archive/side_module.hpp"
#include "bundler/build/object_abi.hpp"
#include "bundler/channel/channel_index.hpp"
#include "bundler/io/files.hpp"
#include "bundler/workspace/python_tree.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPythonFolder = "lib/python";

/// "3.12", of the folder in which a site's Python looks for modules.
std::string_view site_python() {
  std::string_view version = kPythonModules;
  version.remove_prefix(kPythonFolder.size());
  return version.substr(0, version.find('/'));
}

/// The version of Python whose folder a path is in; empty when it is in none.
std::string python_of_folder(const std::string& path) {
  if (!path.starts_with(kPythonFolder)) return {};
  const std::string rest = path.substr(kPythonFolder.size());
  const std::string version = rest.substr(0, rest.find('/'));
  const bool is_version = version.find('.') != std::string::npos &&
                          version.find_first_not_of("0123456789.") == std::string::npos;
  return is_version ? version : std::string();
}

/// The faults of one file, each as a sentence about "it".
Outcome<std::vector<std::string>> faults_of(const fs::path& folder, const TreeEntry& entry) {
  std::vector<std::string> faults;
  if (entry.kind != FileKind::kFile || entry.path.starts_with("info/")) return faults;
  std::string version = python_of_folder(entry.path);
  if (const std::string named = python_version_of_module(fs::path(entry.path).filename().string());
      !named.empty() && entry.path.ends_with(".so"))
    version = named;
  if (!version.empty() && version != site_python())
    return std::vector<std::string>{"it is for Python " + version + ", and a site has Python " +
                                    std::string(site_python())};
  // Python's own folders have libraries that no program of a site is linked with.
  const bool is_object = (entry.path.ends_with(".a") || entry.path.ends_with(".o")) &&
                         !entry.path.starts_with(kPythonFolder);
  const bool is_module = entry.path.ends_with(".so") && entry.path.starts_with(kPythonFolder);
  if (!is_object && !is_module) return faults;
  const auto bytes = read_file(folder / entry.path, kMostOfData);
  if (!bytes) return bytes.errors();
  if (is_object) return object_abi_faults(*bytes);
  const auto module = read_side_module(*bytes);
  if (const auto* fault = std::get_if<SideModuleFault>(&module)) {
    faults.push_back("it " + fault->why);
  } else if (const auto& needed = std::get<SideModule>(module).needed; !needed.empty()) {
    faults.push_back("it needs `" + needed.front() +
                     "`, and libraries of modules are loaded for wheels only");
  }
  return faults;
}

Diagnostic unfit(const PackageRecord& record, std::vector<std::string> why) {
  return Diagnostic{
      .code = "R2W0534",
      .message = "`" + distribution_name(record) + "` of the channel `" + record.channel +
                 "` cannot be a part of this site",
      .why = std::move(why),
      .fix = {"take it from a channel that `ros2wasm channel build` has made, or name its sources "
              "below `sources:`"}};
}

}  // namespace

Outcome<Done> check_foreign_packages(const std::vector<PackageRecord>& records,
                                     const Store& store) {
  Diagnostics errors;
  for (const PackageRecord& record : records) {
    if (record.channel == kEmbeddedChannel) continue;
    const fs::path folder = store.package_place(record);
    if (folder.empty()) continue;
    const auto tree = list_tree(folder);
    if (!tree) return tree.errors();
    std::vector<std::string> why;
    std::set<std::string> said;
    for (const TreeEntry& entry : *tree) {
      const auto faults = faults_of(folder, entry);
      if (!faults) return faults.errors();
      for (const std::string& fault : *faults)
        if (said.insert(fault).second) why.push_back("`" + entry.path + "`: " + fault);
    }
    if (!why.empty()) errors.push_back(unfit(record, std::move(why)));
  }
  if (!errors.empty()) return errors;
  return Done{};
}

}  // namespace ros2wasm
