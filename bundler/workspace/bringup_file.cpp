// See bringup_file.hpp.
#include "bundler/workspace/bringup_file.hpp"

#include <algorithm>
#include <string_view>

namespace ros2wasm {
namespace {

constexpr std::string_view kWord = "bringup";

std::string file_name(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

/// The folder above `launch/`.
std::string package_of(const std::string& path) {
  const auto launch = path.rfind("/launch/");
  const std::string folder = path.substr(0, launch == std::string::npos ? 0 : launch);
  return folder.substr(folder.rfind('/') + 1);
}

bool says_bringup(const std::string& name) {
  return name.find(kWord) != std::string::npos;
}

}  // namespace

BringupChoice bringup_file(const std::vector<std::string>& files) {
  const auto only = [&](auto&& is_it) -> std::string {
    const auto count = std::count_if(files.begin(), files.end(), is_it);
    return count == 1 ? *std::find_if(files.begin(), files.end(), is_it) : std::string();
  };
  BringupChoice choice;
  choice.file = only([](const std::string&) { return true; });
  if (choice.file.empty())
    choice.file = only([](const std::string& file) { return says_bringup(file_name(file)); });
  if (choice.file.empty())
    choice.file = only([](const std::string& file) { return says_bringup(package_of(file)); });
  std::copy_if(files.begin(), files.end(), std::back_inserter(choice.candidates),
               [&](const std::string& file) { return file != choice.file; });
  return choice;
}

}  // namespace ros2wasm
