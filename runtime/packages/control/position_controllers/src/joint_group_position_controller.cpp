// See joint_group_position_controller.hpp.
#include "position_controllers/joint_group_position_controller.hpp"

#include <cstdio>
#include <exception>

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/parameter.hpp"

namespace position_controllers {

using controller_interface::CallbackReturn;
using forward_command_controller::ForwardCommandController;

JointGroupPositionController::JointGroupPositionController() {
  interface_name_ = hardware_interface::HW_IF_POSITION;
}

CallbackReturn JointGroupPositionController::on_init() {
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

}  // namespace position_controllers

PLUGINLIB_EXPORT_CLASS(position_controllers::JointGroupPositionController,
                       controller_interface::ControllerInterface)
