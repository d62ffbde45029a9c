// The tags `<ros2_control>` as they are written, without the facts that come from the joints of the
// robot. This file needs no ROS.
#pragma once

#include <string>
#include <vector>

#include "hardware_interface/hardware_info.hpp"

namespace hardware_interface {

/// Throws std::runtime_error for a text that is not a robot description, that has no such tag, or
/// whose tags are not as they must be.
std::vector<HardwareInfo> read_control_tags(const std::string& urdf);

}  // namespace hardware_interface
