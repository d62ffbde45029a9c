// Passes commands on to the position of several joints.
#pragma once

#include "forward_command_controller/forward_command_controller.hpp"

namespace position_controllers {

class JointGroupPositionController : public forward_command_controller::ForwardCommandController {
 public:
  JointGroupPositionController();

  controller_interface::CallbackReturn on_init() override;
};

}  // namespace position_controllers
