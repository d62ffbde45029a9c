// See joint_group_position_controller.hpp.
#include "position_controllers/joint_group_position_controller.hpp"

#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace position_controllers {

JointGroupPositionController::JointGroupPositionController()
    : JointGroup(hardware_interface::HW_IF_POSITION, AtTheEnd::kCommandStays) {}

}  // namespace position_controllers

PLUGINLIB_EXPORT_CLASS(position_controllers::JointGroupPositionController,
                       controller_interface::ControllerInterface)
