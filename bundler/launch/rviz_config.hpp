// The displays of a configuration of rviz2, and which of them the page's 3D view shows. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// Names of displays, each with its topic when it has one: "LaserScan (/scan)". Those that are not
/// enabled are skipped.
struct RvizDisplays {
  std::vector<std::string> shown;
  std::vector<std::string> elsewhere;  ///< in another panel of the page
  std::vector<std::string> missing;
};

/// Empty when the text is not such a file.
[[nodiscard]] RvizDisplays rviz_displays(std::string_view text);

}  // namespace ros2wasm
