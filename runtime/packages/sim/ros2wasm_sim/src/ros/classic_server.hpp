// Gazebo Classic as ROS sees it: the clock and the services of the server.
#pragma once

#include <gazebo_msgs/srv/delete_entity.hpp>
#include <gazebo_msgs/srv/get_entity_state.hpp>
#include <gazebo_msgs/srv/get_model_list.hpp>
#include <gazebo_msgs/srv/set_entity_state.hpp>
#include <gazebo_msgs/srv/spawn_entity.hpp>
#include <rosgraph_msgs/msg/clock.hpp>
#include <std_srvs/srv/empty.hpp>

#include <vector>

#include "ros/host.hpp"
#include "ros/runner.hpp"

namespace ros2wasm_sim {

struct ClassicOptions {
  bool init = false;     ///< libgazebo_ros_init.so: clock, pause, reset
  bool factory = false;  ///< libgazebo_ros_factory.so: spawn and delete
  bool state = false;    ///< libgazebo_ros_state.so of the world: states of models
  bool paused = false;
  double initial_time = 0;  ///< seconds
};

class ClassicServer {
 public:
  ClassicServer(Host& host, Simulation& simulation, const ClassicOptions& options);

 private:
  void offer_clock();
  void offer_factory();
  void offer_state();
  void publish_clock();
  void spawn(const gazebo_msgs::srv::SpawnEntity::Request& request,
             gazebo_msgs::srv::SpawnEntity::Response& response);
  /// The pose of a frame: the world, a model or a link as `model::link`.
  bool frame_pose(const std::string& frame, Pose& pose);

  Host& host_;
  Simulation& simulation_;
  Runner runner_;
  Rate clock_rate_{10};
  rclcpp::Publisher<rosgraph_msgs::msg::Clock>::SharedPtr clock_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace ros2wasm_sim
