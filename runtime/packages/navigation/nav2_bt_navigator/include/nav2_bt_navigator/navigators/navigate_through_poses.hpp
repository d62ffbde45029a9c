// Goes through poses: the action navigate_through_poses.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_core/behavior_tree_navigator.hpp"
#include "nav2_msgs/action/navigate_through_poses.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "nav_msgs/msg/path.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_bt_navigator {

class NavigateThroughPosesNavigator
    : public nav2_core::BehaviorTreeNavigator<nav2_msgs::action::NavigateThroughPoses> {
 public:
  using ActionT = nav2_msgs::action::NavigateThroughPoses;
  using Goals = std::vector<geometry_msgs::msg::PoseStamped>;

  bool configure(rclcpp_lifecycle::LifecycleNode::WeakPtr node,
                 std::shared_ptr<nav2_util::OdomSmoother> odom_smoother) override;
  std::string getName() override { return "navigate_through_poses"; }
  std::string getDefaultBTFilepath(rclcpp_lifecycle::LifecycleNode::WeakPtr node) override;

 protected:
  bool goalReceived(ActionT::Goal::ConstSharedPtr goal) override;
  void onLoop() override;
  void onPreempt(ActionT::Goal::ConstSharedPtr goal) override;
  void goalCompleted(typename ActionT::Result::SharedPtr result,
                     const nav2_behavior_tree::BtStatus final_bt_status) override;
  /// False, with a message: a goal cannot be seen from the global frame.
  bool initializeGoalPoses(ActionT::Goal::ConstSharedPtr goal);

  rclcpp::Time start_time_;
  std::string goals_blackboard_id_;
  std::string path_blackboard_id_;
  std::shared_ptr<nav2_util::OdomSmoother> odom_smoother_;
};

}  // namespace nav2_bt_navigator
