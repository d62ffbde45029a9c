// Passes commands on to the effort of several joints.
#pragma once

#include "forward_command_controller/forward_command_controller.hpp"

namespace effort_controllers {

class JointGroupEffortController : public forward_command_controller::ForwardCommandController {
 public:
  JointGroupEffortController();

  controller_interface::CallbackReturn on_init() override;
  /// Commands 0 to all joints.
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;
};

}  // namespace effort_controllers
