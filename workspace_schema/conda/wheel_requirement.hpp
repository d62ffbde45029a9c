// A requirement of a wheel: one Requires-Dist line (PEP 508), evaluated for the Python of sites.
// Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

struct WheelRequirement {
  std::string project;   ///< normal_project_name()
  std::string versions;  ///< ">=1.20,<3"; may be empty
  bool applies = true;   ///< here, and without extras
};

/// The Python of sites, for Requires-Python and markers.
inline constexpr std::string_view kSitePython = "3.12.7";

/// Nothing when it is none. A marker that cannot be read applies.
[[nodiscard]] std::optional<WheelRequirement> wheel_requirement(std::string_view text);

/// Is `version` one of `versions`? True when either cannot be read.
[[nodiscard]] bool fits_versions(std::string_view version, std::string_view versions);

}  // namespace ros2wasm
