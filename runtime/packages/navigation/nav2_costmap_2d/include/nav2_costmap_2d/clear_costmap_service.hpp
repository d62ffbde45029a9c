// The services that make costs unknown again: entirely, or around the robot or a pose.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_costmap_2d/costmap_layer.hpp"
#include "nav2_msgs/srv/clear_costmap_around_pose.hpp"
#include "nav2_msgs/srv/clear_costmap_around_robot.hpp"
#include "nav2_msgs/srv/clear_costmap_except_region.hpp"
#include "nav2_msgs/srv/clear_entire_costmap.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {

class Costmap2DROS;

class ClearCostmapService {
 public:
  ClearCostmapService(const nav2_util::LifecycleNode::WeakPtr& parent, Costmap2DROS& costmap);
  ClearCostmapService() = delete;
  ~ClearCostmapService();

  /// A square around the robot with this side [m]; `invert`: all but that.
  void clearRegion(double reset_distance, bool invert);
  void clearAroundPose(const geometry_msgs::msg::PoseStamped& pose, double reset_distance);
  void clearEntirely();

 private:
  using ExceptRegion = nav2_msgs::srv::ClearCostmapExceptRegion;
  using AroundRobot = nav2_msgs::srv::ClearCostmapAroundRobot;
  using AroundPose = nav2_msgs::srv::ClearCostmapAroundPose;
  using Entirely = nav2_msgs::srv::ClearEntireCostmap;

  void clearSquare(double x, double y, double reset_distance, bool invert);
  void clearLayerRegion(CostmapLayer& layer, double x, double y, double reset_distance,
                        bool invert);

  rclcpp::Logger logger_;
  Costmap2DROS& costmap_;
  rclcpp::Service<ExceptRegion>::SharedPtr clear_except_service_;
  rclcpp::Service<AroundRobot>::SharedPtr clear_around_service_;
  rclcpp::Service<AroundPose>::SharedPtr clear_around_pose_service_;
  rclcpp::Service<Entirely>::SharedPtr clear_entire_service_;
};

}  // namespace nav2_costmap_2d
