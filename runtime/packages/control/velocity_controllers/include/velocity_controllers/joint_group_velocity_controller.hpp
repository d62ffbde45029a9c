// Passes commands on to the velocity of several joints.
#pragma once

#include "forward_command_controller/forward_command_controller.hpp"

namespace velocity_controllers {

class JointGroupVelocityController : public forward_command_controller::ForwardCommandController {
 public:
  JointGroupVelocityController();

  controller_interface::CallbackReturn on_init() override;
  /// Commands 0 to all joints.
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;
};

}  // namespace velocity_controllers
