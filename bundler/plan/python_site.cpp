// See python_site.hpp.
#include "bundler/plan/python_site.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "bundler/archive/zip_writer.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kFolder = "python/";
constexpr std::string_view kPackageIndex = "share/ament_index/resource_index/packages/";

std::string zipped(const PythonFiles& files) {
  ZipWriter zip;
  for (const auto& [path, bytes] : files) zip.member(path, bytes);
  return zip.finish();
}

/// "std_msgs/msg/String" -> "share/std_msgs/msg/String.msg".
std::string definition_path(const std::string& type) {
  const auto first = type.find('/');
  const auto last = type.rfind('/');
  return "share/" + type + "." + type.substr(first + 1, last - first - 1);
}

}  // namespace

std::string package_of_shared(const std::string& path) {
  const std::filesystem::path parts = path;
  const std::string folder = std::next(parts.begin())->string();
  return folder == "ament_index" ? parts.filename().string() : folder;
}

PythonSite python_site(PythonInput input, const InterfaceTexts& interfaces,
                       const SharedFiles& shared, const std::vector<std::string>& local,
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
  for (auto& [name, bytes] : input.pyodide) {
    site.files.push_back(
        {.path = "pyodide/" + name, .reason = "Python of Python nodes", .bytes = std::move(bytes)});
  }
  const auto add = [&](const char* name, const char* reason, const PythonFiles& files) {
    if (files.empty()) return;
    site.archives.push_back(std::string(kFolder) + name);
    site.files.push_back({.path = site.archives.back(), .reason = reason, .bytes = zipped(files)});
  };
  add("channels.zip", "what Python nodes find installed of channels' packages", input.channels);
  add("workspace.zip", "what Python nodes find installed of the workspace", input.workspace);
  return site;
}

}  // namespace ros2wasm
