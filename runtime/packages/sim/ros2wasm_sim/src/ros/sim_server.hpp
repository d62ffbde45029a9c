// Gazebo Sim: its clock, and the services of its world, on the hidden names that a bridge carries.
#pragma once

#include <ros_gz_interfaces/srv/control_world.hpp>
#include <ros_gz_interfaces/srv/delete_entity.hpp>
#include <ros_gz_interfaces/srv/set_entity_pose.hpp>
#include <ros_gz_interfaces/srv/spawn_entity.hpp>
#include <rosgraph_msgs/msg/clock.hpp>
#include <std_msgs/msg/string.hpp>

#include <vector>

#include "ros/host.hpp"
#include "ros/runner.hpp"

namespace ros2wasm_sim {

struct SimOptions {
  bool runs = false;        ///< `-r`
  std::uint64_t steps = 0;  ///< `--iterations`; 0: no limit
  double initial_time = 0;  ///< seconds
};

class SimServer {
 public:
  SimServer(Host& host, Simulation& simulation, const SimOptions& options);

 private:
  void publish_clock();
  bool create(const ros_gz_interfaces::msg::EntityFactory& factory);
  bool remove(const ros_gz_interfaces::msg::Entity& entity);
  void control(const ros_gz_interfaces::msg::WorldControl& control);

  Host& host_;
  Simulation& simulation_;
  Runner runner_;
  rclcpp::Publisher<rosgraph_msgs::msg::Clock>::SharedPtr clock_, world_clock_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr name_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace ros2wasm_sim
