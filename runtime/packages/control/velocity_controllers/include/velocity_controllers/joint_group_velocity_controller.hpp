// Passes commands on to the velocity of several joints. It commands 0 when it is deactivated.
#pragma once

#include "forward_command_controller/joint_group.hpp"

namespace velocity_controllers {

class JointGroupVelocityController : public forward_command_controller::JointGroup {
 public:
  JointGroupVelocityController();
};

}  // namespace velocity_controllers
