// Hardware without hardware: commands come back as states, at once or by the laws of motion.
#pragma once

#include <string>
#include <vector>

#include "hardware_interface/handle.hpp"
#include "hardware_interface/hardware_info.hpp"
#include "hardware_interface/system_interface.hpp"
#include "hardware_interface/types/hardware_interface_return_values.hpp"
#include "hardware_interface/types/hardware_interface_type_values.hpp"

using hardware_interface::return_type;

namespace mock_components {

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

static constexpr size_t POSITION_INTERFACE_INDEX = 0;
static constexpr size_t VELOCITY_INTERFACE_INDEX = 1;
static constexpr size_t ACCELERATION_INTERFACE_INDEX = 2;

class GenericSystem : public hardware_interface::SystemInterface {
 public:
  CallbackReturn on_init(
      const hardware_interface::HardwareComponentInterfaceParams& params) override;
  CallbackReturn on_configure(const rclcpp_lifecycle::State& previous_state) override;
  std::vector<hardware_interface::InterfaceDescription>
  export_unlisted_command_interface_descriptions() override;
  return_type prepare_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                          const std::vector<std::string>& stop_interfaces) override;
  return_type perform_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                          const std::vector<std::string>& stop_interfaces) override;
  return_type read(const rclcpp::Time& time, const rclcpp::Duration& period) override;
  return_type write(const rclcpp::Time& /*time*/, const rclcpp::Duration& /*period*/) override {
    return return_type::OK;
  }

 protected:
  const std::vector<std::string> standard_interfaces_ = {
      hardware_interface::HW_IF_POSITION, hardware_interface::HW_IF_VELOCITY,
      hardware_interface::HW_IF_ACCELERATION, hardware_interface::HW_IF_EFFORT};

 private:
  void move_joint(size_t index, double period);
  /// Copies the command of that name into the state; an infinite one is an error.
  return_type mirror(const hardware_interface::Handle& handle);
  return_type mirror_joints();
  void follow_mimicked_joints();
  void set_if_there(const std::string& name, double value);

  bool use_mock_gpio_command_interfaces_ = false;
  bool use_mock_sensor_command_interfaces_ = false;
  double position_state_following_offset_ = 0.0;
  std::string custom_interface_with_following_offset_;
  bool calculate_dynamics_ = false;
  std::vector<size_t> joint_control_mode_;  ///< by joint: the index of the interface in control
  bool command_propagation_disabled_ = false;
};

typedef GenericSystem GenericRobot;

}  // namespace mock_components
