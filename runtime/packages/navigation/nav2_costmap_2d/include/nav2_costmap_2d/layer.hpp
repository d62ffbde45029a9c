// One source of costs of a costmap: a map, obstacles, their inflation. Layers are plugins: their
// base is nav2_costmap_2d::Layer, their parameters begin with the name of the layer.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_costmap_2d {

class LayeredCostmap;

class Layer {
 public:
  Layer();
  virtual ~Layer() {}

  /// Calls onInitialize().
  void initialize(LayeredCostmap* parent, std::string name, tf2_ros::Buffer* tf,
                  const nav2_util::LifecycleNode::WeakPtr& node,
                  rclcpp::CallbackGroup::SharedPtr callback_group);
  virtual void deactivate() {}
  virtual void activate() {}
  virtual void reset() = 0;
  /// Whether the services that clear a costmap clear this layer.
  virtual bool isClearable() = 0;
  /// Widens the bounds (in the world) by what the layer will change.
  virtual void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x,
                            double* min_y, double* max_x, double* max_y) = 0;
  /// Writes the cells from (min_i, min_j) to before (max_i, max_j).
  virtual void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) = 0;
  /// The costmap has a new size.
  virtual void matchSize() {}
  virtual void onFootprintChanged() {}

  std::string getName() const { return name_; }
  /// Whether its data is as new as it should be.
  bool isCurrent() const { return current_; }
  bool isEnabled() const { return enabled_; }
  /// In the frame of the robot.
  const std::vector<geometry_msgs::msg::Point>& getFootprint() const;

  /// Nothing when it is declared already.
  void declareParameter(const std::string& param_name, const rclcpp::ParameterValue& value);
  void declareParameter(const std::string& param_name, const rclcpp::ParameterType& param_type);
  bool hasParameter(const std::string& param_name);
  /// With the name of the layer.
  std::string getFullName(const std::string& param_name);

 protected:
  virtual void onInitialize() {}

  LayeredCostmap* layered_costmap_;
  std::string name_;
  tf2_ros::Buffer* tf_;
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_costmap_2d")};
  bool current_;
  bool enabled_;
  std::unordered_set<std::string> local_params_;
};

}  // namespace nav2_costmap_2d
