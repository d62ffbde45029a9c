// libgazebo_ros_force_system.so: services that push links and drive joints for a time.
#pragma once

#include <gazebo_msgs/srv/apply_joint_effort.hpp>
#include <gazebo_msgs/srv/apply_link_wrench.hpp>
#include <gazebo_msgs/srv/joint_request.hpp>
#include <gazebo_msgs/srv/link_request.hpp>

#include <string>
#include <vector>

#include "ros/host.hpp"

namespace ros2wasm_sim {

class ClassicForces final : public System {
 public:
  ClassicForces(rclcpp::Node& node, Simulation& simulation);
  void before_step(const Now& now) override;
  void on_reset() override;

 private:
  /// When a force acts, in nanoseconds of the simulation.
  struct Span {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    bool is_endless = false;

    bool covers(std::int64_t time) const { return time >= begin && (is_endless || time < end); }
    bool is_over(std::int64_t time) const { return !is_endless && time >= end; }
  };
  /// Along the axes of the world, at the centre of mass.
  struct LinkForce {
    std::string name;
    LinkHandle link;
    Vector3 force, torque;
    Span span;
  };
  struct JointForce {
    std::string name;
    JointHandle joint;
    double effort = 0;
    Span span;
  };

  Span span_of(const builtin_interfaces::msg::Time& start,
               const builtin_interfaces::msg::Duration& duration) const;
  void push(const gazebo_msgs::srv::ApplyLinkWrench::Request& request,
            gazebo_msgs::srv::ApplyLinkWrench::Response& response);
  void drive(const gazebo_msgs::srv::ApplyJointEffort::Request& request,
             gazebo_msgs::srv::ApplyJointEffort::Response& response);
  /// The joint of any model that has this name, or `model::joint`.
  JointHandle joint_named(const std::string& name);

  Simulation& simulation_;
  rclcpp::Logger logger_;
  std::vector<LinkForce> links_;
  std::vector<JointForce> joints_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace ros2wasm_sim
