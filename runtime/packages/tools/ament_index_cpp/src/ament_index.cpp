// The files of a site have one prefix, but a program may set AMENT_PREFIX_PATH itself.
#include <dirent.h>
#include <sys/stat.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "ament_index_cpp/detail/file_text.hpp"
#include "ament_index_cpp/get_package_prefix.hpp"
#include "ament_index_cpp/get_package_share_directory.hpp"
#include "ament_index_cpp/get_package_share_path.hpp"
#include "ament_index_cpp/get_packages_with_prefixes.hpp"
#include "ament_index_cpp/get_resource.hpp"
#include "ament_index_cpp/get_resources.hpp"
#include "ament_index_cpp/get_search_paths.hpp"
#include "ament_index_cpp/has_resource.hpp"

namespace ament_index_cpp {
namespace {

constexpr const char* kVariable = "AMENT_PREFIX_PATH";
constexpr const char* kPackages = "packages";

std::string folder_of(const std::string& prefix, const std::string& type) {
  return prefix + "/share/ament_index/resource_index/" + type;
}

std::string not_found(const std::string& package) {
  std::string text = "package '" + package + "' not found, searching: [";
  const char* between = "";
  for (const std::string& prefix : get_search_paths()) {
    text += between + prefix;
    between = ", ";
  }
  return text + "]";
}

void require(const std::string& type) {
  if (type.empty()) {
    throw std::runtime_error("ament_index_cpp: resource type must not be empty");
  }
}

bool is_folder(const std::string& path) {
  struct stat told {};
  return !path.empty() && stat(path.c_str(), &told) == 0 && S_ISDIR(told.st_mode);
}

}  // namespace

std::optional<std::string> detail::file_text(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) return std::nullopt;
  std::string text;
  char part[4096];
  while (const size_t count = std::fread(part, 1, sizeof part, file.get())) {
    text.append(part, count);
  }
  return text;
}

std::list<std::string> get_search_paths() {
  const char* const value = std::getenv(kVariable);
  if (value == nullptr || *value == '\0') {
    throw std::runtime_error(std::string("Environment variable '") + kVariable +
                             "' is not set or empty");
  }
  std::list<std::string> paths;
  for (std::string_view rest = value; !rest.empty();) {
    const size_t end = rest.find(':');
    std::string path(rest.substr(0, end));
    if (is_folder(path)) paths.push_back(std::move(path));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  return paths;
}

bool get_resource(const std::string& resource_type, const std::string& resource_name,
                  std::string& content, std::string* prefix_path) {
  require(resource_type);
  if (resource_name.empty()) {
    throw std::runtime_error("ament_index_cpp: resource name must not be empty");
  }
  for (const std::string& prefix : get_search_paths()) {
    std::optional<std::string> text =
        detail::file_text(folder_of(prefix, resource_type) + "/" + resource_name);
    if (!text) {
      continue;
    }
    content = std::move(*text);
    if (prefix_path != nullptr) {
      *prefix_path = prefix;
    }
    return true;
  }
  return false;
}

bool has_resource(const std::string& resource_type, const std::string& resource_name,
                  std::string* prefix_path) {
  std::string content;
  return get_resource(resource_type, resource_name, content, prefix_path);
}

std::map<std::string, std::string> get_resources(const std::string& resource_type) {
  require(resource_type);
  std::map<std::string, std::string> resources;
  for (const std::string& prefix : get_search_paths()) {
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(
        opendir(folder_of(prefix, resource_type).c_str()), closedir);
    if (!folder) {
      continue;
    }
    while (const dirent* const entry = readdir(folder.get())) {
      if (entry->d_name[0] != '.') {
        resources.emplace(entry->d_name, prefix);
      }
    }
  }
  return resources;
}

std::map<std::string, std::string> get_packages_with_prefixes() {
  return get_resources(kPackages);
}

PackageNotFoundError::PackageNotFoundError(const std::string& name)
    : std::out_of_range(not_found(name)), package_name(name) {}

PackageNotFoundError::~PackageNotFoundError() = default;

std::string get_package_prefix(const std::string& package_name) {
  std::string prefix;
  if (!has_resource(kPackages, package_name, &prefix)) {
    throw PackageNotFoundError(package_name);
  }
  return prefix;
}

void get_package_prefix(const std::string& package_name, std::filesystem::path& path) {
  path = get_package_prefix(package_name);
}

std::string get_package_share_directory(const std::string& package_name) {
  return get_package_prefix(package_name) + "/share/" + package_name;
}

void get_package_share_directory(const std::string& package_name, std::filesystem::path& path) {
  path = get_package_share_directory(package_name);
}

std::filesystem::path get_package_share_path(const std::string& package_name) {
  return get_package_share_directory(package_name);
}

}  // namespace ament_index_cpp
