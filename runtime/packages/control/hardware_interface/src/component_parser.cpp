// Joins the tags `<ros2_control>` with the joints of the robot: mimic joints and limits.
#include "hardware_interface/component_parser.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "control_tags.hpp"
#include "hardware_interface/lexical_casts.hpp"
#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "joint_limits/joint_limits_urdf.hpp"
#include "urdf/model.h"

namespace hardware_interface {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// The `min` and `max` of an interface; what is not given stays as it is. False without any.
bool read_bounds(const InterfaceInfo& interface, double& min, double& max) {
  if (interface.min.empty() && interface.max.empty()) {
    return false;
  }
  try {
    min = interface.min.empty() ? min : hardware_interface::stod(interface.min);
    max = interface.max.empty() ? max : hardware_interface::stod(interface.max);
    return true;
  } catch (const std::invalid_argument&) {
    std::fprintf(stderr,
                 "Error parsing the limits for the interface: %s from the tags [min: '%s' and max: "
                 "'%s'] within ros2_control tag inside the URDF. Skipping it\n",
                 interface.name.c_str(), interface.min.c_str(), interface.max.c_str());
    return false;
  }
}

void limit_position(const InterfaceInfo& interface, joint_limits::JointLimits& limits) {
  const bool from_joint = limits.has_position_limits && interface.enable_limits;
  limits.min_position = from_joint ? limits.min_position : -kLargest;
  limits.max_position = from_joint ? limits.max_position : kLargest;
  double min = limits.min_position;
  double max = limits.max_position;
  if (interface.enable_limits && read_bounds(interface, min, max)) {
    limits.min_position = std::max(min, limits.min_position);
    limits.max_position = std::min(max, limits.max_position);
    limits.has_position_limits = true;
  }
  limits.has_position_limits = limits.has_position_limits && interface.enable_limits;
}

/// Velocity and effort have one limit for both directions.
void limit_size(const InterfaceInfo& interface, double& largest, bool& has_limit) {
  largest = has_limit ? largest : kLargest;
  double min = -largest;
  double max = largest;
  if (interface.enable_limits && read_bounds(interface, min, max)) {
    largest = std::min({std::abs(min), max, largest});
    has_limit = true;
  }
  has_limit = has_limit && interface.enable_limits;
}

void limit_acceleration(const InterfaceInfo& interface, joint_limits::JointLimits& limits) {
  double min = kNotANumber;
  double max = kNotANumber;
  if (!read_bounds(interface, min, max)) {
    return;
  }
  if (std::isfinite(min)) {
    limits.max_deceleration = std::fabs(min);
    limits.has_deceleration_limits = interface.enable_limits;
  }
  if (std::isfinite(max)) {
    limits.max_acceleration = max;
    limits.has_acceleration_limits = interface.enable_limits;
  }
  if (!std::isfinite(max)) {
    limits.max_acceleration = limits.max_deceleration;
  } else if (!std::isfinite(limits.max_deceleration)) {
    limits.max_deceleration = std::fabs(max);
  }
}

void limit_jerk(const InterfaceInfo& interface, joint_limits::JointLimits& limits) {
  if (!interface.min.empty()) {
    std::fprintf(stderr,
                 "Error parsing the limits for the interface: jerk from the tag: min within "
                 "ros2_control tag inside the URDF. Jerk only accepts max limits.\n");
  }
  double min = kNotANumber;
  double max = kNotANumber;
  if (!interface.max.empty() && read_bounds(interface, min, max) && std::isfinite(max)) {
    limits.max_jerk = std::abs(max);
    limits.has_jerk_limits = interface.enable_limits;
  }
}

/// Narrows the limits of the joint by those of its command interfaces.
void apply_interfaces(const ComponentInfo& joint, joint_limits::JointLimits& limits) {
  if (!joint.enable_limits) {
    limits.disable_all_limits();
    return;
  }
  for (const InterfaceInfo& interface : joint.command_interfaces) {
    if (interface.name == HW_IF_POSITION) {
      limit_position(interface, limits);
    } else if (interface.name == HW_IF_VELOCITY) {
      limit_size(interface, limits.max_velocity, limits.has_velocity_limits);
    } else if (interface.name == HW_IF_EFFORT) {
      limit_size(interface, limits.max_effort, limits.has_effort_limits);
    } else if (interface.name == HW_IF_ACCELERATION) {
      limit_acceleration(interface, limits);
    } else if (interface.name == "jerk") {
      limit_jerk(interface, limits);
    } else if (!interface.min.empty() || !interface.max.empty()) {
      std::fprintf(stderr,
                   "Unable to parse the limits for the interface: %s from the tags [min and max] "
                   "within ros2_control tag inside the URDF. Supported interfaces for joint limits "
                   "are: position, velocity, effort, acceleration and jerk.\n",
                   interface.name.c_str());
    }
  }
}

/// Notes that the joint follows another one of the same tag, when its description says so.
void add_mimic(HardwareInfo& info, std::size_t index, const urdf::Joint& joint) {
  const ComponentInfo& component = info.joints[index];
  if (!joint.mimic && component.is_mimic == MimicAttribute::TRUE) {
    throw std::runtime_error("Joint '" + component.name + "' has no mimic information in the URDF");
  }
  if (!joint.mimic || component.is_mimic == MimicAttribute::FALSE) {
    return;
  }
  if (!component.command_interfaces.empty()) {
    throw std::runtime_error(
        "Joint '" + component.name +
        "' has mimic attribute not set to false: Activated mimic joints cannot "
        "have command interfaces.");
  }
  const std::string& followed = joint.mimic->joint_name;
  const auto found = std::find_if(info.joints.begin(), info.joints.end(),
                                  [&](const auto& other) { return other.name == followed; });
  if (found == info.joints.end()) {
    throw std::runtime_error("Mimic joint '" + followed + "' not found in <ros2_control> tag");
  }
  MimicJoint mimic{};
  mimic.joint_index = index;
  mimic.mimicked_joint_index = static_cast<std::size_t>(found - info.joints.begin());
  mimic.multiplier = joint.mimic->multiplier;
  mimic.offset = joint.mimic->offset;
  info.mimic_joints.push_back(mimic);
}

void add_limits(HardwareInfo& info, const ComponentInfo& component,
                const urdf::JointConstSharedPtr& joint) {
  joint_limits::JointLimits limits;
  joint_limits::getJointLimits(joint, limits);
  apply_interfaces(component, limits);
  info.limits[component.name] = limits;
  joint_limits::SoftJointLimits soft;
  if (joint_limits::getSoftJointLimits(joint, soft)) {
    if (limits.has_position_limits) {
      soft.min_position = std::max(soft.min_position, limits.min_position);
      soft.max_position = std::min(soft.max_position, limits.max_position);
    }
    info.soft_limits[component.name] = soft;
  }
}

using ListOfInterfaces = std::vector<InterfaceInfo> ComponentInfo::*;

std::vector<InterfaceDescription> descriptions(const std::vector<ComponentInfo>& components,
                                               ListOfInterfaces list) {
  std::vector<InterfaceDescription> result;
  for (const ComponentInfo& component : components) {
    for (const InterfaceInfo& interface : component.*list) {
      result.emplace_back(component.name, interface);
    }
  }
  return result;
}

void add_to(std::unordered_map<std::string, InterfaceDescription>& map,
            const std::vector<InterfaceDescription>& found) {
  for (const InterfaceDescription& description : found) {
    map.emplace(description.get_name(), description);
  }
}

}  // namespace

std::vector<HardwareInfo> parse_control_resources_from_urdf(const std::string& urdf) {
  std::vector<HardwareInfo> result = read_control_tags(urdf);
  urdf::Model model;
  if (!model.initString(urdf)) {
    throw std::runtime_error("Failed to parse URDF file");
  }
  for (HardwareInfo& info : result) {
    for (std::size_t i = 0; i < info.joints.size(); ++i) {
      const ComponentInfo& component = info.joints[i];
      const urdf::JointConstSharedPtr joint = model.getJoint(component.name);
      if (!joint) {
        throw std::runtime_error("Joint '" + component.name + "' not found in URDF");
      }
      add_mimic(info, i, *joint);
      if (joint->type == urdf::Joint::FIXED) {
        throw std::runtime_error("Joint '" + component.name +
                                 "' is of type 'fixed'. Fixed joints do not make sense in "
                                 "ros2_control.");
      }
      add_limits(info, component, joint);
    }
  }
  return result;
}

std::vector<InterfaceDescription> parse_state_interface_descriptions(
    const std::vector<ComponentInfo>& component_info) {
  return descriptions(component_info, &ComponentInfo::state_interfaces);
}
void parse_state_interface_descriptions(
    const std::vector<ComponentInfo>& component_info,
    std::unordered_map<std::string, InterfaceDescription>& state_interfaces_map) {
  add_to(state_interfaces_map, parse_state_interface_descriptions(component_info));
}
std::vector<InterfaceDescription> parse_command_interface_descriptions(
    const std::vector<ComponentInfo>& component_info) {
  return descriptions(component_info, &ComponentInfo::command_interfaces);
}
void parse_command_interface_descriptions(
    const std::vector<ComponentInfo>& component_info,
    std::unordered_map<std::string, InterfaceDescription>& command_interfaces_map) {
  add_to(command_interfaces_map, parse_command_interface_descriptions(component_info));
}

}  // namespace hardware_interface
