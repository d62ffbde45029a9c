// Deactivates and unloads controllers.
#include <cstdio>

#include "arguments.hpp"
#include "manager_client.hpp"

namespace controller_manager {
namespace {

int run(int argc, char** argv) {
  const std::vector<std::string> rest = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const UnspawnerOptions options = read_unspawner_arguments({rest.begin() + 1, rest.end()});
  const auto node = std::make_shared<rclcpp::Node>("unspawner_" + options.controllers.front());
  ManagerClient client(node, full_manager_name(options.controller_manager, node->get_namespace()),
                       0.0, 10.0);
  try {
    // The unloading is tried in any case; the manager prints why a switch is refused.
    client.switch_controllers(options.controllers, {}, true, options.switch_timeout);
    RCLCPP_INFO(node->get_logger(), "Deactivated controller");
    for (const std::string& name : options.controllers) {
      if (!client.unload(name)) {
        RCLCPP_INFO(node->get_logger(), "Failed to unload controller");
        return 1;
      }
      RCLCPP_INFO(node->get_logger(), "Unloaded controller");
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
