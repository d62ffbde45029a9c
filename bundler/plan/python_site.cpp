// See python_site.hpp.
#include "bundler/plan/python_site.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <tuple>

#include "bundler/archive/zip_writer.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/launch/host/import_check.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kFolder = "python/";
constexpr std::string_view kPackageIndex = "share/ament_index/resource_index/packages/";

/// The files of a top-level module, which are gone from `files` then.
PythonFiles taken_out(PythonFiles& files, const std::string& module) {
  PythonFiles taken;
  const std::string base = std::string(kPythonModules) + "/" + module;
  for (auto it = files.lower_bound(base); it != files.end() && it->first.starts_with(base);) {
    const bool is_of_it = it->first.size() > base.size() &&
                          (it->first[base.size()] == '/' || it->first[base.size()] == '.');
    const auto next = std::next(it);
    if (is_of_it) taken.insert(files.extract(it));
    it = next;
  }
  return taken;
}

/// "std_msgs/msg/String" -> "share/std_msgs/msg/String.msg".
std::string definition_path(const std::string& type) {
  const auto first = type.find('/');
  const auto last = type.rfind('/');
  return "share/" + type + "." + type.substr(first + 1, last - first - 1);
}

/// Sorted by what people call them. A package beside the workspace's folder is named from there.
std::vector<PlannedSource> sources_of(const PythonInput& input) {
  constexpr std::string_view kUp = "../";
  std::vector<PlannedSource> sources;
  for (const auto& [path, file] : input.sources) {
    std::string_view name = file;
    while (name.starts_with(kUp)) name.remove_prefix(kUp.size());
    sources.push_back(
        {.path = path, .file = std::string(name), .sha256 = sha256_hex(input.workspace.at(path))});
  }
  std::sort(sources.begin(), sources.end(), [](const PlannedSource& a, const PlannedSource& b) {
    return std::tie(a.file, a.path) < std::tie(b.file, b.path);
  });
  return sources;
}

}  // namespace

std::string python_archive(const PythonFiles& files) {
  ZipWriter zip;
  for (const auto& [path, bytes] : files) zip.member(path, bytes);
  return zip.finish();
}

std::string package_of_shared(const std::string& path) {
  const std::filesystem::path parts = path;
  const std::string folder = std::next(parts.begin())->string();
  return folder == "ament_index" ? parts.filename().string() : folder;
}

PythonSite python_site(PythonInput input, const InterfaceTexts& interfaces,
                       const SharedFiles& shared, const std::set<std::string>& needed,
                       const std::vector<std::string>& local,
                       const std::vector<std::string>& packages) {
  const auto part_of = [&](const std::string& package) -> PythonFiles& {
    const bool is_local = std::find(local.begin(), local.end(), package) != local.end();
    return is_local ? input.workspace : input.channels;
  };
  for (const auto& [type, text] : interfaces)
    part_of(type.substr(0, type.find('/'))).emplace(definition_path(type), text);
  for (const auto& [path, bytes] : shared) part_of(package_of_shared(path)).emplace(path, bytes);
  for (const std::string& package : packages)
    part_of(package).emplace(std::string(kPackageIndex) + package, "");

  PythonSite site;
  site.sources = sources_of(input);
  for (auto& [name, bytes] : input.pyodide) {
    site.files.push_back(
        {.path = "pyodide/" + name, .reason = "Python of Python nodes", .bytes = std::move(bytes)});
  }
  const auto add = [&](const std::string& name, const std::string& reason,
                       const PythonFiles& files) {
    site.files.push_back(
        {.path = std::string(kFolder) + name, .reason = reason, .bytes = python_archive(files)});
    return site.files.back().path;
  };
  for (const std::string& module : compiled_modules(input.channels)) {
    const PythonFiles files = taken_out(input.channels, module);
    if (!needed.contains(module)) continue;
    site.compiled[module] = add(module + ".zip", "module " + module + " of Python nodes", files);
  }
  for (auto& [project, library] : input.libraries) {
    site.libraries[project] = add("libraries/" + project + ".zip",
                                  "library " + project + " of Python nodes", library.files);
    site.load[project] = std::move(library.load);
  }
  const auto add_part = [&](const std::string& name, const PythonFiles& files) {
    if (files.empty()) return;
    site.archives.push_back(
        add(name + ".zip", "what Python nodes find installed of the " + name, files));
  };
  add_part("channels", input.channels);
  add_part("wheels", input.wheels);
  add_part("workspace", input.workspace);
  return site;
}

}  // namespace ros2wasm
