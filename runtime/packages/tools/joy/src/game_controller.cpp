// game_controller_node: a gamepad with the axes and buttons of SDL's game controllers.
#include "gamepad_node.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace joy {

class GameController : public GamepadNode {
 public:
  explicit GameController(const rclcpp::NodeOptions& options)
      : GamepadNode("game_controller_node", GamepadLayout::kController, options) {}

 private:
  void say_connected(const Devices& devices, const std::string& wanted) override {
    for (const auto& [number, device] : devices) {
      RCLCPP_INFO(get_logger(), "Controller Found: device_id=%i, device_name=%s", number,
                  device.name.c_str());
      if (!wanted.empty() && device.name == wanted) return;
    }
  }

  void say_no_device_named(const std::string& name) override {
    RCLCPP_WARN(get_logger(), "Could not get game controller with name %s: ", name.c_str());
  }

  void say_opened(const GamepadDevice& device, double deadzone) override {
    RCLCPP_INFO(get_logger(), "Opened game controller: %s,  deadzone: %f, rumble: %s",
                device.name.c_str(), deadzone, device.can_rumble ? "Yes" : "No");
  }

  void say_removed(const GamepadDevice& device) override {
    RCLCPP_INFO(get_logger(), "Game controller Removed: %s.", device.name.c_str());
  }
};

}  // namespace joy

RCLCPP_COMPONENTS_REGISTER_NODE(joy::GameController)
