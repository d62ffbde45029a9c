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
    {"Armadillo", "armadillo"},
    {"Boost", "libboost-headers"},
    {"Eigen3", "eigen"},
    {"GeographicLib", "geographiclib-cpp"},
    {"TinyXML2", "tinyxml2"},
    {"armadillo", "armadillo"},
    {"boost", "libboost-headers"},
    {"eigen", "eigen"},
    {"fmt", "fmt"},
    {"geographiclib", "geographiclib-cpp"},
    {"graphicsmagick", "graphicsmagick"},
    {"libboost-all-dev", "libboost-headers"},
    {"libboost-dev", "libboost-headers"},
    {"libgraphicsmagick++1-dev", "graphicsmagick"},
    {"libnanoflann-dev", "nanoflann"},
    {"liborocos-kdl-dev", "orocos-kdl"},
    {"libyaml-cpp-dev", "yaml-cpp"},
    {"nanoflann", "nanoflann"},
    {"nlohmann-json-dev", "nlohmann_json"},
    {"nlohmann_json", "nlohmann_json"},
    {"numpy", "numpy"},
    {"orocos_kdl", "orocos-kdl"},
    {"python-transforms3d-pip", "transforms3d"},
    {"python3-opencv", "py-opencv"},
    {"python3-pil", "pillow"},
    {"python3-serial", "pyserial"},
    {"python3-yaml", "pyyaml"},
    {"range-v3", "range-v3"},
    {"spdlog", "spdlog"},
    {"tinyxml2", "tinyxml2"},
    {"transforms3d", "transforms3d"},
    {"tzdata", "tzdata"},
    {"uuid", "libuuid"},
    {"uuid-dev", "libuuid"},
    {"yaml-cpp", "yaml-cpp"},
});

constexpr std::string_view kPythonKey = "python3-";
constexpr std::string_view kPipKey = "-pip";

}  // namespace

std::string_view library_package(std::string_view rosdep_key) {
  const auto found =
      std::find_if(kLibraryPackages.begin(), kLibraryPackages.end(),
                   [&](const LibraryPackage& row) { return row.rosdep_key == rosdep_key; });
  if (found != kLibraryPackages.end()) return found->conda_name;
  // Keys of Python modules, which are no ROS packages.
  if (!rosdep_key.starts_with(kPythonKey)) return {};
  rosdep_key.remove_prefix(kPythonKey.size());
  if (rosdep_key.ends_with(kPipKey)) rosdep_key.remove_suffix(kPipKey.size());
  return rosdep_key;
}

}  // namespace ros2wasm
