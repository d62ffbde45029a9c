// Publishes a costmap in two forms, whole and as changes, and offers a service for it.
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "map_msgs/msg/occupancy_grid_update.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_msgs/msg/costmap.hpp"
#include "nav2_msgs/msg/costmap_update.hpp"
#include "nav2_msgs/srv/get_costmap.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_costmap_2d {

class Costmap2DPublisher {
 public:
  /// Topics `topic_name` (an OccupancyGrid), `topic_name`_raw (costs), and `_updates` of each.
  Costmap2DPublisher(const nav2_util::LifecycleNode::WeakPtr& parent, Costmap2D* costmap,
                     std::string global_frame, std::string topic_name,
                     bool always_send_full_costmap = false, double map_vis_z = 0.0);
  ~Costmap2DPublisher();

  void on_configure() {}
  void on_activate();
  void on_deactivate();
  void on_cleanup() {}

  /// Adds to what has changed since the last message.
  void updateBounds(unsigned int x0, unsigned int xn, unsigned int y0, unsigned int yn) {
    x0_ = std::min(x0, x0_);
    xn_ = std::max(xn, xn_);
    y0_ = std::min(y0, y0_);
    yn_ = std::max(yn, yn_);
  }
  /// Whole at first, when its size or place has changed, or when somebody new listens; else what
  /// has changed. Nothing for a layer that is disabled.
  void publishCostmap();
  bool active() { return active_; }

 private:
  using Grid = nav_msgs::msg::OccupancyGrid;
  using GridUpdate = map_msgs::msg::OccupancyGridUpdate;
  using Costs = nav2_msgs::msg::Costmap;
  using CostsUpdate = nav2_msgs::msg::CostmapUpdate;

  std::unique_ptr<Grid> prepareGrid() const;
  std::unique_ptr<Costs> prepareCostmap() const;
  std::unique_ptr<GridUpdate> createGridUpdateMsg() const;
  std::unique_ptr<CostsUpdate> createCostmapUpdateMsg() const;
  bool isMoved() const;
  bool hasNewListener();
  void rememberPlace();
  void publishWhole();
  void publishChange();

  rclcpp::Clock::SharedPtr clock_;
  Costmap2D* costmap_;
  std::string global_frame_;
  bool always_send_full_costmap_;
  double map_vis_z_;
  bool active_ = false;
  // Changed cells; none while x0_ is not less than xn_.
  unsigned int x0_;
  unsigned int xn_ = 0;
  unsigned int y0_;
  unsigned int yn_ = 0;
  bool published_once_ = false;
  size_t listeners_ = 0;
  // The map of the last whole message.
  double saved_origin_x_ = 0.0;
  double saved_origin_y_ = 0.0;
  double grid_resolution_ = 0.0;
  unsigned int grid_width_ = 0;
  unsigned int grid_height_ = 0;
  rclcpp_lifecycle::LifecyclePublisher<Grid>::SharedPtr costmap_pub_;
  rclcpp_lifecycle::LifecyclePublisher<GridUpdate>::SharedPtr costmap_update_pub_;
  rclcpp_lifecycle::LifecyclePublisher<Costs>::SharedPtr costmap_raw_pub_;
  rclcpp_lifecycle::LifecyclePublisher<CostsUpdate>::SharedPtr costmap_raw_update_pub_;
  rclcpp::Service<nav2_msgs::srv::GetCostmap>::SharedPtr costmap_service_;
};

}  // namespace nav2_costmap_2d
