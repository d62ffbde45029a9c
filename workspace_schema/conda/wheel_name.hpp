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

  /// For every Python 3 and every machine.
  [[nodiscard]] bool is_pure() const;
  /// Compiled for the interpreter of sites: its Python, its ABI, its platform.
  [[nodiscard]] bool is_for_site_abi() const;
};

/// The Python of sites, and what compiled modules must be made for.
inline constexpr std::string_view kSiteAbi =
    "Python 3.12 and the platform pyodide_2024_0_wasm32 (Pyodide 0.27)";

/// Nothing when it is not the name of a wheel. `file_name` without folders.
[[nodiscard]] std::optional<WheelName> wheel_name(std::string_view file_name);

/// "Demo__parts.x" -> "demo-parts-x": two names that give the same are the same project.
[[nodiscard]] std::string normal_project_name(std::string_view name);

}  // namespace ros2wasm
