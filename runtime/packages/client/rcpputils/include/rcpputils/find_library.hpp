// File names of libraries. In a site a program is linked whole, so none of them is a file.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include "rcpputils/env.hpp"

namespace rcpputils {

inline std::string filename_for_library(const std::string& library_name) {
  return "lib" + library_name + ".so";
}

/// Empty when there is no such file in the folder.
inline std::string path_for_library(const std::string& directory, const std::string& library_name) {
  const std::filesystem::path path =
      std::filesystem::path(directory) / filename_for_library(library_name);
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) ? path.string() : "";
}

/// Empty when no folder of LD_LIBRARY_PATH has it.
inline std::string find_library_path(const std::string& library_name) {
  const std::string folders = get_env_var("LD_LIBRARY_PATH");
  for (size_t start = 0; start < folders.size();) {
    const size_t end = std::min(folders.find(':', start), folders.size());
    const std::string found = path_for_library(folders.substr(start, end - start), library_name);
    if (!found.empty()) {
      return found;
    }
    start = end + 1;
  }
  return "";
}

}  // namespace rcpputils
