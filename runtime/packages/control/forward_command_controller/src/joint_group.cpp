// See joint_group.hpp.
#include "forward_command_controller/joint_group.hpp"

#include <cstdio>
#include <exception>

#include "rclcpp/logging.hpp"
#include "rclcpp/parameter.hpp"

namespace forward_command_controller {

using controller_interface::CallbackReturn;

CallbackReturn JointGroup::on_init() {
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

CallbackReturn JointGroup::on_deactivate(const rclcpp_lifecycle::State& previous_state) {
  const CallbackReturn done = ForwardCommandController::on_deactivate(previous_state);
  if (at_the_end_ == AtTheEnd::kCommandStays) return done;
  for (auto& command_interface : command_interfaces_) {
    if (!command_interface.set_value(0.0)) {
      RCLCPP_ERROR(get_node()->get_logger(), "Unable to set command interface value to 0.0");
      return CallbackReturn::SUCCESS;
    }
  }
  return done;
}

}  // namespace forward_command_controller
