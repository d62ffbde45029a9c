// Gazebo Classic as ROS sees it: the clock and the services of the server.
#pragma once

#include <gazebo_msgs/msg/performance_metrics.hpp>
#include <gazebo_msgs/srv/delete_entity.hpp>
#include <gazebo_msgs/srv/get_model_list.hpp>
#include <gazebo_msgs/srv/spawn_entity.hpp>
#include <rosgraph_msgs/msg/clock.hpp>
#include <std_srvs/srv/empty.hpp>

#include <vector>

#include "ros/host.hpp"
#include "ros/runner.hpp"
#include "ros/scene_publisher.hpp"
#include "ros/world_services.hpp"

namespace ros2wasm_sim {

struct ClassicOptions {
  bool init = false;     ///< libgazebo_ros_init.so: clock, pause, reset
  bool factory = false;  ///< libgazebo_ros_factory.so: spawn and delete
  bool forces = false;   ///< libgazebo_ros_force_system.so: wrenches and efforts
  bool paused = false;
  double initial_time = 0;  ///< seconds
};

class ClassicServer {
 public:
  ClassicServer(Host& host, Simulation& simulation, const ClassicOptions& options);

 private:
  void offer_clock();
  void offer_factory();
  void after_step();
  void publish_clock();
  void publish_metrics();
  /// Time has gone back to 0.
  void restart_clock();
  void spawn(const gazebo_msgs::srv::SpawnEntity::Request& request,
             gazebo_msgs::srv::SpawnEntity::Response& response);

  Host& host_;
  Simulation& simulation_;
  Runner runner_;
  WorldServices world_services_;
  ScenePublisher scene_;
  Rate clock_rate_{10};
  rclcpp::Publisher<rosgraph_msgs::msg::Clock>::SharedPtr clock_;
  Rate metrics_rate_{5};
  rclcpp::Publisher<gazebo_msgs::msg::PerformanceMetrics>::SharedPtr metrics_;
  rclcpp::Clock site_clock_{RCL_STEADY_TIME};
  rclcpp::Time last_site_time_;       ///< when metrics were last due
  std::int64_t last_metrics_ns_ = 0;  ///< of simulated time, then
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace ros2wasm_sim
