// Passes commands on to the effort of several joints. It commands 0 when it is deactivated.
#pragma once

#include "forward_command_controller/joint_group.hpp"

namespace effort_controllers {

class JointGroupEffortController : public forward_command_controller::JointGroup {
 public:
  JointGroupEffortController();
};

}  // namespace effort_controllers
