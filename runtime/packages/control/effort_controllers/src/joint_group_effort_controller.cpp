// See joint_group_effort_controller.hpp.
#include "effort_controllers/joint_group_effort_controller.hpp"

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace effort_controllers {

JointGroupEffortController::JointGroupEffortController()
    : JointGroup(hardware_interface::HW_IF_EFFORT, AtTheEnd::kCommandsZero) {}

}  // namespace effort_controllers

PLUGINLIB_EXPORT_CLASS(effort_controllers::JointGroupEffortController,
                       controller_interface::ControllerInterface)
