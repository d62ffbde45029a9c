// Gazebo Sim: its clock, and the services of its world, on the hidden names that a bridge carries.
#pragma once

#include <memory>

#include <rosgraph_msgs/msg/clock.hpp>
#include <std_msgs/msg/string.hpp>

#include "ros/host.hpp"
#include "ros/runner.hpp"
#include "ros/scene_publisher.hpp"
#include "ros/simulation_services.hpp"
#include "ros/world_services.hpp"

namespace ros2wasm_sim {

struct SimOptions {
  bool runs = false;        ///< `-r`
  std::uint64_t steps = 0;  ///< `--iterations`; 0: no limit
  double initial_time = 0;  ///< seconds
  bool any_make = false;    ///< offers the services of simulation_interfaces too
};

class SimServer {
 public:
  SimServer(Host& host, Simulation& simulation, const SimOptions& options);

 private:
  void publish_clock();

  Host& host_;
  Simulation& simulation_;
  Runner runner_;
  WorldServices services_;
  ScenePublisher scene_;
  std::unique_ptr<SimulationServices> any_make_;
  rclcpp::Publisher<rosgraph_msgs::msg::Clock>::SharedPtr clock_, world_clock_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr name_;
};

}  // namespace ros2wasm_sim
