// See sim_resource_manager.hpp.
#include "sim_resource_manager.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "hardware_interface/component_parser.hpp"

namespace ros2wasm_sim {
namespace {

bool is_simulated(const std::string& plugin) {
  const char* const names[] = {"gazebo_ros2_control/GazeboSystem",
                               "gz_ros2_control/GazeboSimSystem",
                               "ign_ros2_control/IgnitionSystem"};
  return std::find(std::begin(names), std::end(names), plugin) != std::end(names);
}

}  // namespace

bool SimResourceManager::load_and_initialize_components(
    const hardware_interface::ResourceManagerParams& params) {
  for (const auto& info :
       hardware_interface::parse_control_resources_from_urdf(params.robot_description)) {
    if (!is_simulated(info.hardware_plugin_name)) {
      RCLCPP_ERROR(get_logger(),
                   "The plugin failed to load for some reason. Error: [%s] is not hardware of the "
                   "simulator, such as gz_ros2_control/GazeboSimSystem",
                   info.hardware_plugin_name.c_str());
      continue;
    }
    hardware_interface::HardwareComponentParams own;
    own.hardware_info = info;
    own.logger = get_logger();
    own.clock = get_clock();
    own.node_namespace = params.node_namespace;
    own.executor = params.executor;
    import_component(std::make_unique<SimHardware>(simulation_, settings_), own);
    if (get_components_status().count(info.name) == 0) {
      RCLCPP_FATAL(get_logger(), "Could not initialize robot simulation interface");
      remove_all_components();
      return false;
    }
  }
  components_are_loaded_and_initialized_ = true;
  return true;
}

}  // namespace ros2wasm_sim
