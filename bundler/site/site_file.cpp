// See site_file.hpp.
#include "bundler/site/site_file.hpp"

#include <filesystem>

namespace ros2wasm {

std::string hash_list(const std::vector<PlannedFile>& files) {
  std::string text;
  for (const PlannedFile& file : files) text += file.sha256 + "  " + file.path + "\n";
  return text;
}

std::string page_text_path(const std::string& path) {
  return "text/" + std::filesystem::path(path).lexically_normal().generic_string();
}

std::string page_bag_path(const std::string& path) {
  return "bags/" + std::filesystem::path(path).lexically_normal().generic_string();
}

}  // namespace ros2wasm
