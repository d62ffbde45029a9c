// The part that the groups of position, velocity and effort controllers share: one kind of
// interface.
#pragma once

#include <string>

#include "forward_command_controller/forward_command_controller.hpp"

namespace forward_command_controller {

class JointGroup : public ForwardCommandController {
 public:
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;

 protected:
  enum class AtTheEnd { kCommandStays, kCommandsZero };
  JointGroup(const std::string& interface, AtTheEnd at_the_end) : at_the_end_(at_the_end) {
    interface_name_ = interface;
  }

 private:
  AtTheEnd at_the_end_;
};

}  // namespace forward_command_controller
