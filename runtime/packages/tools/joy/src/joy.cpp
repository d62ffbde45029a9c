// joy_node: a gamepad with the axes and buttons of its device.
#include "gamepad_node.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace joy {

class Joy : public GamepadNode {
 public:
  explicit Joy(const rclcpp::NodeOptions& options)
      : GamepadNode("joy_node", GamepadLayout::kJoystick, options) {}

 private:
  void say_connected(const Devices&, const std::string&) override {}

  void say_no_device_named(const std::string& name) override {
    RCLCPP_WARN(get_logger(), "Could not get joystick with name %s: ", name.c_str());
  }

  void say_opened(const GamepadDevice& device, double deadzone) override {
    if (!device.can_rumble) {
      RCLCPP_INFO(get_logger(), "No haptic (rumble) available, skipping initialization");
    }
    RCLCPP_INFO(get_logger(), "Opened joystick: %s.  deadzone: %f", device.name.c_str(), deadzone);
  }

  void say_removed(const GamepadDevice&) override {}
};

}  // namespace joy

RCLCPP_COMPONENTS_REGISTER_NODE(joy::Joy)
