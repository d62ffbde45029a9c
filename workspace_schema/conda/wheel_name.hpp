// The parts of the file name of a Python wheel, and names of Python projects as package indexes
// compare them. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// "demo_parts-1.2-py3-none-any.whl".
struct WheelName {
  std::string project;  ///< as it is written: "demo_parts"
  std::string version;  ///< "1.2"
  std::string tags;     ///< "py3-none-any"

  /// For every Python 3 and every machine: what a site can run.
  [[nodiscard]] bool is_pure() const;
};

/// Nothing when it is not the name of a wheel. `file_name` without folders.
[[nodiscard]] std::optional<WheelName> wheel_name(std::string_view file_name);

/// "Demo__parts.x" -> "demo-parts-x": two names that give the same are the same project.
[[nodiscard]] std::string normal_project_name(std::string_view name);

}  // namespace ros2wasm
