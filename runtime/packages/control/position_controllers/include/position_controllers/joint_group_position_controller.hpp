// Passes commands on to the position of several joints.
#pragma once

#include "forward_command_controller/joint_group.hpp"

namespace position_controllers {

class JointGroupPositionController : public forward_command_controller::JointGroup {
 public:
  JointGroupPositionController();
};

}  // namespace position_controllers
