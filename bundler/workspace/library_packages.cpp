// See library_packages.hpp.
#include "bundler/workspace/library_packages.hpp"

#include <algorithm>
#include <array>

namespace ros2wasm {
namespace {

struct LibraryPackage {
  std::string_view rosdep_key;  // or CMake's name
  std::string_view conda_name;
};

constexpr auto kLibraryPackages = std::to_array<LibraryPackage>({
    {"Eigen3", "eigen"},
    {"eigen", "eigen"},
    {"fmt", "fmt"},
    {"libyaml-cpp-dev", "yaml-cpp"},
    {"nlohmann-json-dev", "nlohmann_json"},
    {"nlohmann_json", "nlohmann_json"},
    {"numpy", "numpy"},
    {"python3-numpy", "numpy"},
    {"python3-yaml", "pyyaml"},
    {"yaml-cpp", "yaml-cpp"},
});

}  // namespace

std::string_view library_package(std::string_view rosdep_key) {
  const auto found =
      std::find_if(kLibraryPackages.begin(), kLibraryPackages.end(),
                   [&](const LibraryPackage& row) { return row.rosdep_key == rosdep_key; });
  return found == kLibraryPackages.end() ? std::string_view() : found->conda_name;
}

}  // namespace ros2wasm
