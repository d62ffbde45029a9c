// The base of plugins that score trajectories: less is better.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dwb_msgs/msg/trajectory2_d.hpp"
#include "geometry_msgs/msg/pose2_d.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav_2d_msgs/msg/path2_d.hpp"
#include "nav_2d_msgs/msg/twist2_d.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/point_cloud.hpp"

namespace dwb_core {

class TrajectoryCritic {
 public:
  using Ptr = std::shared_ptr<dwb_core::TrajectoryCritic>;
  virtual ~TrajectoryCritic() {}

  /// Reads `<ns>.<name>.scale` and calls onInit(). `ns` is the name of the controller.
  void initialize(const nav2_util::LifecycleNode::SharedPtr& nh, const std::string& name,
                  const std::string& ns,
                  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) {
    node_ = nh;
    name_ = name;
    costmap_ros_ = costmap_ros;
    dwb_plugin_name_ = ns;
    const std::string parameter = ns + "." + name + ".scale";
    if (!nh->has_parameter(parameter)) {
      nh->declare_parameter(parameter, rclcpp::ParameterValue(1.0));
    }
    nh->get_parameter(parameter, scale_);
    onInit();
  }
  virtual void onInit() {}

  /// There is a new path.
  virtual void reset() {}
  /// Before the trajectories of one cycle: the robot's pose and velocity, the goal, and the part of
  /// the path near the robot, in the frame of the local costmap. False is logged only.
  virtual bool prepare(const geometry_msgs::msg::Pose2D&, const nav_2d_msgs::msg::Twist2D&,
                       const geometry_msgs::msg::Pose2D&, const nav_2d_msgs::msg::Path2D&) {
    return true;
  }
  /// At least 0. Throws IllegalTrajectoryException to forbid the trajectory.
  virtual double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) = 0;
  /// The command that was chosen.
  virtual void debrief(const nav_2d_msgs::msg::Twist2D&) {}
  /// Adds values for all cells of the costmap, as a channel of the topic `cost_cloud`.
  virtual void addCriticVisualization(std::vector<std::pair<std::string, std::vector<float>>>&) {}

  std::string getName() { return name_; }
  virtual double getScale() const { return scale_; }
  void setScale(const double scale) { scale_ = scale; }

 protected:
  std::string name_;
  std::string dwb_plugin_name_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros_;
  double scale_ = 1.0;
  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
};

}  // namespace dwb_core
