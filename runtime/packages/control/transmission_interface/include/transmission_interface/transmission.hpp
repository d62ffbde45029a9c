// Values of actuators as values of joints, and back.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "transmission_interface/handle.hpp"

namespace transmission_interface {

constexpr auto HW_IF_ABSOLUTE_POSITION = "absolute_position";

class Transmission {
 public:
  virtual ~Transmission() = default;

  /// Throws Exception for handles that the transmission cannot use.
  virtual void configure(const std::vector<JointHandle>& joint_handles,
                         const std::vector<ActuatorHandle>& actuator_handles) = 0;
  virtual std::vector<std::string> get_supported_joint_interfaces() const {
    return {hardware_interface::HW_IF_POSITION, hardware_interface::HW_IF_VELOCITY,
            hardware_interface::HW_IF_EFFORT};
  }
  virtual std::vector<std::string> get_supported_actuator_interfaces() const {
    return get_supported_joint_interfaces();
  }
  virtual double get_actuator_position_offset() const { return 0.0; }
  virtual double get_joint_position_offset() const { return 0.0; }
  /// The first for states, the second for commands.
  virtual void actuator_to_joint() = 0;
  virtual void joint_to_actuator() = 0;
  virtual std::size_t num_actuators() const = 0;
  virtual std::size_t num_joints() const = 0;
};

typedef std::shared_ptr<Transmission> TransmissionSharedPtr;

}  // namespace transmission_interface
