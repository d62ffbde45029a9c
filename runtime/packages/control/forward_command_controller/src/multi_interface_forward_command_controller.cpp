// See multi_interface_forward_command_controller.hpp.
#include "forward_command_controller/multi_interface_forward_command_controller.hpp"

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace forward_command_controller {
namespace {

void describe(ros2wasm_parameters::Declarations& of, MultiInterfaceParams& params) {
  of.add("joint", params.joint, {"Name of the joint to control"});
  of.add("interface_names", params.interface_names, {"Names of the interfaces to command"});
}

}  // namespace

using controller_interface::CallbackReturn;

void MultiInterfaceForwardCommandController::declare_parameters() {
  param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
}

CallbackReturn MultiInterfaceForwardCommandController::read_parameters() {
  params_ = param_listener_->get_params();
  if (params_.joint.empty()) {
    RCLCPP_ERROR(get_node()->get_logger(), "'joint' parameter is empty");
    return CallbackReturn::ERROR;
  }
  if (params_.interface_names.empty()) {
    RCLCPP_ERROR(get_node()->get_logger(), "'interfaces' parameter is empty");
    return CallbackReturn::ERROR;
  }
  command_interface_types_.clear();
  for (const std::string& name : params_.interface_names) {
    command_interface_types_.push_back(params_.joint + "/" + name);
  }
  return CallbackReturn::SUCCESS;
}

}  // namespace forward_command_controller

PLUGINLIB_EXPORT_CLASS(forward_command_controller::MultiInterfaceForwardCommandController,
                       controller_interface::ControllerInterface)
