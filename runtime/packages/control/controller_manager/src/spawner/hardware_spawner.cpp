// Configures or activates hardware components.
#include <algorithm>
#include <cstdio>

#include "arguments.hpp"
#include "controller_manager_msgs/srv/list_hardware_components.hpp"
#include "controller_manager_msgs/srv/set_hardware_component_state.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "manager_client.hpp"

namespace controller_manager {
namespace {

namespace srv = controller_manager_msgs::srv;
using lifecycle_msgs::msg::State;

/// A state as Python prints the message.
std::string printed(const State& state) {
  return "lifecycle_msgs.msg.State(id=" + std::to_string(state.id) + ", label='" + state.label +
         "')";
}

void lead(const rclcpp::Logger& logger, ManagerClient& client, const std::string& component,
          bool activate) {
  srv::SetHardwareComponentState::Request request;
  request.name = component;
  request.target_state.id = activate ? State::PRIMARY_STATE_ACTIVE : State::PRIMARY_STATE_INACTIVE;
  request.target_state.label = activate ? "active" : "inactive";
  const char* const action = activate ? "activated" : "configured";
  const auto answer =
      client.call<srv::SetHardwareComponentState>("set_hardware_component_state", request);
  if (!answer->ok) {
    RCLCPP_WARN(logger, "Could not %s component '%s'. Service call failed. Wrong component name?",
                action, component.c_str());
  } else if (answer->state != request.target_state) {
    RCLCPP_WARN(logger,
                "Could not %s component '%s'. Service call returned ok=True, but state: %s is not "
                "equal to target state '%s'.",
                action, component.c_str(), printed(answer->state).c_str(),
                printed(request.target_state).c_str());
  } else {
    RCLCPP_INFO(logger, "%s component '%s'. Hardware now in state: %s.", action, component.c_str(),
                printed(answer->state).c_str());
  }
}

int run(int argc, char** argv) {
  const std::vector<std::string> rest = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const HardwareSpawnerOptions options =
      read_hardware_spawner_arguments({rest.begin() + 1, rest.end()});
  const auto node = std::make_shared<rclcpp::Node>("hardware_spawner");
  ManagerClient client(node, full_manager_name(options.controller_manager, node->get_namespace()),
                       options.controller_manager_timeout, 10.0);
  try {
    for (const std::string& name : options.components) {
      const auto known = client.call<srv::ListHardwareComponents>(
          "list_hardware_components", srv::ListHardwareComponents::Request());
      if (std::none_of(known->component.begin(), known->component.end(),
                       [&name](const auto& one) { return one.name == name; })) {
        RCLCPP_WARN(node->get_logger(),
                    "Hardware Component is not loaded - state can not be changed.");
      } else {
        lead(node->get_logger(), client, name, options.activate);
      }
    }
    return 0;
  } catch (const Interrupted&) {
    return 0;
  } catch (const std::exception& error) {
    RCLCPP_FATAL(node->get_logger(), "%s", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace controller_manager

int main(int argc, char** argv) {
  try {
    const int exit_code = controller_manager::run(argc, argv);
    rclcpp::shutdown();
    return exit_code;
  } catch (const controller_manager::UsageError& error) {
    std::fputs(error.text.c_str(), error.exit_code == 0 ? stdout : stderr);
    return error.exit_code;
  }
}
