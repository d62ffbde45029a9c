// See joint_group_velocity_controller.hpp.
#include "velocity_controllers/joint_group_velocity_controller.hpp"

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace velocity_controllers {

JointGroupVelocityController::JointGroupVelocityController()
    : JointGroup(hardware_interface::HW_IF_VELOCITY, AtTheEnd::kCommandsZero) {}

}  // namespace velocity_controllers

PLUGINLIB_EXPORT_CLASS(velocity_controllers::JointGroupVelocityController,
                       controller_interface::ControllerInterface)
