// Smooths a path by a filter over its poses. It looks at no costmap.
#pragma once

#include <memory>
#include <string>

#include "nav2_core/smoother.hpp"
#include "nav_msgs/msg/path.hpp"

namespace nav2_smoother {

class SavitzkyGolaySmoother : public nav2_core::Smoother {
 public:
  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                 std::shared_ptr<tf2_ros::Buffer> tf,
                 std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_sub,
                 std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> footprint_sub) override;
  void cleanup() override {}
  void activate() override {}
  void deactivate() override {}
  /// Throws SmootherTimedOut.
  bool smooth(nav_msgs::msg::Path& path, const rclcpp::Duration& max_time) override;

 protected:
  bool do_refinement_ = true;
  int refinement_num_ = 0;
  rclcpp::Logger logger_{rclcpp::get_logger("SGSmoother")};
};

}  // namespace nav2_smoother
