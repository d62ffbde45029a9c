// A hardware component as the tag `<ros2_control>` of a robot description tells it. The parser
// fills these structs; plugins read them in on_init. This file needs no ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "joint_limits/joint_limits.hpp"

namespace hardware_interface {

struct InterfaceInfo {
  std::string name;
  /// As written; empty when the description has none.
  std::string min = "";
  std::string max = "";
  std::string initial_value = "";
  std::string data_type = "double";
  int size = 1;
  std::unordered_map<std::string, std::string> parameters;
  bool enable_limits = true;
};

/// A joint that follows another: position = offset + multiplier * position of the other.
struct MimicJoint {
  std::size_t joint_index;  ///< of HardwareInfo::joints
  std::size_t mimicked_joint_index;
  double multiplier = 1.0;
  double offset = 0.0;
};

enum class MimicAttribute { NOT_SET, TRUE, FALSE };

/// A joint, sensor or gpio.
struct ComponentInfo {
  std::string name;
  std::string type;
  MimicAttribute is_mimic = MimicAttribute::NOT_SET;
  bool enable_limits = true;
  std::vector<InterfaceInfo> command_interfaces;
  std::vector<InterfaceInfo> state_interfaces;
  std::unordered_map<std::string, std::string> parameters;
};

struct JointInfo {
  std::string name;
  std::vector<std::string> state_interfaces;
  std::vector<std::string> command_interfaces;
  std::string role;
  double mechanical_reduction = 1.0;
  double offset = 0.0;
  bool read_only = false;
};

struct ActuatorInfo {
  std::string name;
  std::vector<std::string> state_interfaces;
  std::vector<std::string> command_interfaces;
  std::string role;
  double mechanical_reduction = 1.0;
  double offset = 0.0;
  bool read_only = false;
};

struct TransmissionInfo {
  std::string name;
  std::string type;
  std::vector<JointInfo> joints;
  std::vector<ActuatorInfo> actuators;
  std::unordered_map<std::string, std::string> parameters;
};

/// The value of an interface that has its own; a handle to a user's double has none.
using HANDLE_DATATYPE = std::variant<std::monostate, double, float, bool, std::uint8_t, std::int8_t,
                                     std::uint16_t, std::int16_t, std::uint32_t, std::int32_t>;

class HandleDataType {
 public:
  enum Value : std::int8_t {
    UNKNOWN = -1,
    DOUBLE,
    FLOAT32,
    BOOL,
    UINT8,
    INT8,
    UINT16,
    INT16,
    UINT32,
    INT32,
  };

  HandleDataType() = default;
  constexpr HandleDataType(Value value) : value_(value) {}  // NOLINT: as in ROS
  explicit HandleDataType(const std::string& data_type);

  operator Value() const { return value_; }
  explicit operator bool() const = delete;
  constexpr bool operator==(HandleDataType other) const { return value_ == other.value_; }
  constexpr bool operator!=(HandleDataType other) const { return value_ != other.value_; }
  constexpr bool operator==(Value other) const { return value_ == other; }
  constexpr bool operator!=(Value other) const { return value_ != other; }

  std::string to_string() const;
  bool is_castable_to_double() const { return value_ != UNKNOWN; }
  /// Throws std::runtime_error for an unknown type, std::bad_variant_access for another one.
  double cast_to_double(const HANDLE_DATATYPE& value) const;
  HandleDataType from_string(const std::string& data_type) { return HandleDataType(data_type); }

 private:
  Value value_ = UNKNOWN;
};

/// An interface with the name of the joint, sensor or gpio that has it.
struct InterfaceDescription {
  InterfaceDescription(const std::string& prefix_name_in, const InterfaceInfo& interface_info_in)
      : prefix_name(prefix_name_in),
        interface_info(interface_info_in),
        interface_name(prefix_name + "/" + interface_info.name) {}

  std::string prefix_name;
  InterfaceInfo interface_info;
  std::string interface_name;

  const std::string& get_prefix_name() const { return prefix_name; }
  const std::string& get_interface_name() const { return interface_info.name; }
  const std::string& get_name() const { return interface_name; }
  const std::string& get_data_type_string() const { return interface_info.data_type; }
  HandleDataType get_data_type() const { return HandleDataType(interface_info.data_type); }
};

struct HardwareAsyncParams {
  int thread_priority = 50;
  std::string scheduling_policy = "synchronized";
  std::vector<int> cpu_affinity_cores = {};
  bool print_warnings = true;
};

struct HardwareInfo {
  std::string name;
  std::string type;          ///< system, actuator or sensor
  std::string group;         ///< components of one group are activated together
  unsigned int rw_rate = 0;  ///< Hz; 0: that of the controller manager
  bool is_async = false;
  int thread_priority = 50;
  HardwareAsyncParams async_params;
  std::string hardware_plugin_name;
  std::unordered_map<std::string, std::string> hardware_parameters;
  std::vector<ComponentInfo> joints;
  std::vector<MimicJoint> mimic_joints;
  std::vector<ComponentInfo> sensors;
  std::vector<ComponentInfo> gpios;
  std::vector<TransmissionInfo> transmissions;
  std::string original_xml;  ///< the whole robot description
  std::unordered_map<std::string, joint_limits::JointLimits> limits;  ///< by joint
  std::unordered_map<std::string, joint_limits::SoftJointLimits> soft_limits;
};

}  // namespace hardware_interface
