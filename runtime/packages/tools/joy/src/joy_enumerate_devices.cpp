// Prints a table of the gamepads that the page sees.
#include <chrono>
#include <cstdio>
#include <map>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <vector>

#include "gamepad_device.hpp"
#include "sensor_msgs/msg/joy.hpp"

namespace {

using sensor_msgs::msg::Joy;
/// The page looks for those who want gamepads several times in this time.
constexpr std::chrono::seconds kPatience{2};

/// Their names by their numbers.
std::map<int, std::string> find_devices() {
  const auto node = std::make_shared<rclcpp::Node>("_joy_enumerate_devices");
  std::map<int, std::string> found;
  std::vector<rclcpp::Subscription<Joy>::SharedPtr> gamepads;
  for (int number = 0; number < joy::kMostDevices; ++number) {
    gamepads.push_back(node->create_subscription<Joy>(
        joy::device_topic(joy::GamepadLayout::kJoystick, number), rclcpp::QoS(1).transient_local(),
        [&found, number](const Joy& raw) {
          const auto device = joy::parse_device(raw.header.frame_id);
          const bool is_gone = raw.axes.empty() && raw.buttons.empty();
          if (device && !is_gone) found[number] = device->name;
        }));
  }
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  const auto end = std::chrono::steady_clock::now() + kPatience;
  for (auto now = end - kPatience; now < end && rclcpp::ok();
       now = std::chrono::steady_clock::now()) {
    executor.spin_once(end - now);
  }
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const std::map<int, std::string> devices = find_devices();
  std::puts("Joystick Device ID : Joystick Device Name");
  std::puts("-----------------------------------------");
  for (const auto& [number, name] : devices) std::printf("%18d : %s\n", number, name.c_str());
  if (devices.empty()) {
    std::fputs("A page sees a gamepad after one of its buttons is pressed.\n", stderr);
  }
  rclcpp::shutdown();
}
