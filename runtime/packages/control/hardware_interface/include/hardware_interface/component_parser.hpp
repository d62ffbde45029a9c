// Reads the tags `<ros2_control>` of a robot description. This file needs no ROS.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "hardware_interface/hardware_info.hpp"

namespace hardware_interface {

/// One entry per tag, in the order of the text. Throws std::runtime_error for a text that is not a
/// robot description, and for a tag that is not as it must be.
std::vector<HardwareInfo> parse_control_resources_from_urdf(const std::string& urdf);

std::vector<InterfaceDescription> parse_state_interface_descriptions(
    const std::vector<ComponentInfo>& component_info);
void parse_state_interface_descriptions(
    const std::vector<ComponentInfo>& component_info,
    std::unordered_map<std::string, InterfaceDescription>& state_interfaces_map);
std::vector<InterfaceDescription> parse_command_interface_descriptions(
    const std::vector<ComponentInfo>& component_info);
void parse_command_interface_descriptions(
    const std::vector<ComponentInfo>& component_info,
    std::unordered_map<std::string, InterfaceDescription>& command_interfaces_map);

}  // namespace hardware_interface
