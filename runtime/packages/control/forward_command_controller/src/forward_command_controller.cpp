// See forward_command_controller.hpp.
#include "forward_command_controller/forward_command_controller.hpp"

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace forward_command_controller {
namespace {

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("joints", params.joints, {"Name of the joints to control"});
  of.add("interface_name", params.interface_name, {"Name of the interface to command"});
}

}  // namespace

using controller_interface::CallbackReturn;

void ForwardCommandController::declare_parameters() {
  param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
}

CallbackReturn ForwardCommandController::read_parameters() {
  params_ = param_listener_->get_params();
  if (params_.joints.empty()) {
    RCLCPP_ERROR(get_node()->get_logger(), "'joints' parameter was empty");
    return CallbackReturn::ERROR;
  }
  if (params_.interface_name.empty()) {
    RCLCPP_ERROR(get_node()->get_logger(), "'interface_name' parameter was empty");
    return CallbackReturn::ERROR;
  }
  command_interface_types_.clear();
  for (const std::string& joint : params_.joints) {
    command_interface_types_.push_back(joint + "/" + params_.interface_name);
  }
  return CallbackReturn::SUCCESS;
}

}  // namespace forward_command_controller

PLUGINLIB_EXPORT_CLASS(forward_command_controller::ForwardCommandController,
                       controller_interface::ControllerInterface)
