// Costs of a map that is published, for instance by map_server.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

#include "map_msgs/msg/occupancy_grid_update.hpp"
#include "nav2_costmap_2d/costmap_layer.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {

class StaticLayer : public CostmapLayer {
 public:
  StaticLayer();
  virtual ~StaticLayer();

  virtual void onInitialize();
  virtual void activate();
  virtual void deactivate();
  virtual void reset();
  virtual bool isClearable() { return false; }
  virtual void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x,
                            double* min_y, double* max_x, double* max_y);
  virtual void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);
  virtual void matchSize();

 protected:
  void getParameters();
  /// Takes a map, and gives the costmap its size unless that moves with the robot.
  void processMap(const nav_msgs::msg::OccupancyGrid& new_map);
  void incomingMap(const nav_msgs::msg::OccupancyGrid::SharedPtr new_map);
  void incomingUpdate(map_msgs::msg::OccupancyGridUpdate::ConstSharedPtr update);
  /// The cost of an occupancy; 255 is unknown.
  unsigned char interpretValue(unsigned char value);
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);
  void updateFootprint(double robot_x, double robot_y, double robot_yaw, double* min_x,
                       double* min_y, double* max_x, double* max_y);
  /// For a costmap that moves with the robot, or is in another frame.
  void updateRolling(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);

  std::vector<geometry_msgs::msg::Point> transformed_footprint_;
  bool footprint_clearing_enabled_ = false;
  std::string global_frame_;
  std::string map_frame_;
  bool has_updated_data_ = false;
  unsigned int x_ = 0;
  unsigned int y_ = 0;
  unsigned int width_ = 0;
  unsigned int height_ = 0;
  rclcpp::Subscription<nav_msgs::msg::OccupancyGrid>::SharedPtr map_sub_;
  rclcpp::Subscription<map_msgs::msg::OccupancyGridUpdate>::SharedPtr map_update_sub_;
  std::string map_topic_;
  bool map_subscribe_transient_local_ = true;
  bool subscribe_to_updates_ = false;
  bool track_unknown_space_ = false;
  bool use_maximum_ = false;
  unsigned char lethal_threshold_ = 100;
  unsigned char unknown_cost_value_ = 255;
  bool trinary_costmap_ = true;
  std::atomic<bool> map_received_{false};
  bool map_received_in_update_bounds_ = false;
  tf2::Duration transform_tolerance_{};
  nav_msgs::msg::OccupancyGrid::SharedPtr map_buffer_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
};

}  // namespace nav2_costmap_2d
