// Values that tools may watch. A site has no such tools: the macros compile and record nothing.
#pragma once

#include "hardware_interface/macros.hpp"

namespace hardware_interface {

constexpr char DEFAULT_REGISTRY_KEY[] = "ros2_control";
constexpr char DEFAULT_INTROSPECTION_TOPIC[] = "~/introspection_data";
constexpr char CM_STATISTICS_KEY[] = "cm_execution_statistics";
constexpr char CM_STATISTICS_TOPIC[] = "~/statistics";

}  // namespace hardware_interface

#define REGISTER_ROS2_CONTROL_INTROSPECTION(ID, ENTITY) \
  static_cast<void>(ID);                                \
  static_cast<void>(ENTITY)
#define UNREGISTER_ROS2_CONTROL_INTROSPECTION(ID) static_cast<void>(ID)
#define CLEAR_ALL_ROS2_CONTROL_INTROSPECTION_REGISTRIES() static_cast<void>(0)
