// See site_file.hpp and site_names.hpp.
#include "bundler/site/site_file.hpp"

#include <filesystem>

#include "bundler/site/site_names.hpp"

namespace ros2wasm {

bool is_carried_page(std::string_view page) {
  return page.starts_with(std::string(kCarriedPageDoctype) + std::string(kCarriedPageMark) +
                          std::string(kSiteGenerator));
}

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
