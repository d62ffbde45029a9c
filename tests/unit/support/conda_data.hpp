// Public data of conda that is not in the repository: named by ROS2WASM_CONDA_DATA, or beside the
// source tree. Tests that use it check what is in the repository too, and check more where the data
// is.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace ros2wasm::testing {

inline std::optional<std::filesystem::path> conda_data(const std::string& name) {
  const char* given = std::getenv("ROS2WASM_CONDA_DATA");
  const std::filesystem::path folder =
      given != nullptr
          ? std::filesystem::path(given)
          : std::filesystem::path(ROS2WASM_SOURCE_DIR) / ".." / "shared" / "data" / "conda";
  std::error_code error;
  if (!std::filesystem::exists(folder / name, error)) return std::nullopt;
  return folder / name;
}

}  // namespace ros2wasm::testing
