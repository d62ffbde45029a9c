// See joint_group_effort_controller.hpp.
#include "effort_controllers/joint_group_effort_controller.hpp"

#include <cstdio>
#include <exception>

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/parameter.hpp"

namespace effort_controllers {

using controller_interface::CallbackReturn;
using forward_command_controller::ForwardCommandController;

JointGroupEffortController::JointGroupEffortController() {
  interface_name_ = hardware_interface::HW_IF_EFFORT;
}

CallbackReturn JointGroupEffortController::on_init() {
  const CallbackReturn done = ForwardCommandController::on_init();
  if (done != CallbackReturn::SUCCESS) return done;
  try {
    get_node()->set_parameter(rclcpp::Parameter("interface_name", interface_name_));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

CallbackReturn JointGroupEffortController::on_deactivate(
    const rclcpp_lifecycle::State& previous_state) {
  const CallbackReturn done = ForwardCommandController::on_deactivate(previous_state);
  for (auto& command_interface : command_interfaces_) {
    if (!command_interface.set_value(0.0)) {
      RCLCPP_ERROR(get_node()->get_logger(), "Unable to set command interface value to 0.0");
      return CallbackReturn::SUCCESS;
    }
  }
  return done;
}

}  // namespace effort_controllers

PLUGINLIB_EXPORT_CLASS(effort_controllers::JointGroupEffortController,
                       controller_interface::ControllerInterface)
