// Smooths a path by pulling each pose to the middle of its neighbours, and back to where it was.
#pragma once

#include <memory>
#include <string>

#include "nav2_core/smoother.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav_msgs/msg/path.hpp"

namespace nav2_smoother {

class SimpleSmoother : public nav2_core::Smoother {
 public:
  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                 std::shared_ptr<tf2_ros::Buffer> tf,
                 std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_sub,
                 std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> footprint_sub) override;
  void cleanup() override { costmap_sub_.reset(); }
  void activate() override {}
  void deactivate() override {}
  /// Throws SmootherTimedOut, and std::runtime_error before there is a costmap.
  bool smooth(nav_msgs::msg::Path& path, const rclcpp::Duration& max_time) override;

 protected:
  double tolerance_ = 0.0;  // m
  double data_w_ = 0.0;
  double smooth_w_ = 0.0;
  int max_its_ = 0;
  int refinement_num_ = 0;
  bool do_refinement_ = true;
  std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_sub_;
  rclcpp::Logger logger_{rclcpp::get_logger("SimpleSmoother")};
};

}  // namespace nav2_smoother
