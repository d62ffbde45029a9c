// Libraries that are no ROS packages: package.xml names them by rosdep key, channels by conda's
// name. One table, like that of host packages.
#pragma once

#include <string_view>

namespace ros2wasm {

/// Conda's name of the library with this rosdep key or name for find_package(), or an empty text
/// when the key is none of them.
[[nodiscard]] std::string_view library_package(std::string_view rosdep_key);

}  // namespace ros2wasm
