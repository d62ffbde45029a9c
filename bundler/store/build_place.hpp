// Where packages of workspaces are built, and where launch files are kept. Ninja does not see that
// another ros2wasm links differently, so each version and format has a folder of its own, and those
// of others can go.
#pragma once

#include <filesystem>
#include <string>

namespace ros2wasm {

/// Part of every hash too: raise it when the same sources must be built again.
inline constexpr const char* kBuildFormat = "6";

/// The folder of the builds of all versions of ros2wasm: `<cache>/build`.
[[nodiscard]] inline std::filesystem::path build_area(const std::filesystem::path& cache) {
  return cache / "build";
}

/// The folder of the builds of this version: `<cache>/build/0.1.0-5`.
[[nodiscard]] inline std::filesystem::path build_place(const std::filesystem::path& cache) {
  return build_area(cache) / (std::string(ROS2WASM_VERSION) + "-" + kBuildFormat);
}

/// The cached answers of launch files in Python, of all versions: `<cache>/launch`.
[[nodiscard]] inline std::filesystem::path launch_area(const std::filesystem::path& cache) {
  return cache / "launch";
}

/// The same for this version.
[[nodiscard]] inline std::filesystem::path kept_launch_place(const std::filesystem::path& cache) {
  return launch_area(cache) / ROS2WASM_VERSION;
}

/// The cached results of Python syntax checks, of all versions: `<cache>/python`.
[[nodiscard]] inline std::filesystem::path python_area(const std::filesystem::path& cache) {
  return cache / "python";
}

/// The same for this version.
[[nodiscard]] inline std::filesystem::path kept_python_place(const std::filesystem::path& cache) {
  return python_area(cache) / ROS2WASM_VERSION;
}

}  // namespace ros2wasm
