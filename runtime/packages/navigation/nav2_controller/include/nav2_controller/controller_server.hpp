// Follows paths: in a loop it asks the controller plugin of a goal for velocities until the goal
// checker says that the end is reached.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_core/controller.hpp"
#include "nav2_core/controller_exceptions.hpp"
#include "nav2_core/goal_checker.hpp"
#include "nav2_core/progress_checker.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_msgs/action/follow_path.hpp"
#include "nav2_msgs/msg/speed_limit.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/simple_action_server.hpp"
#include "nav2_util/twist_publisher.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "pluginlib/class_loader.hpp"

namespace nav2_controller {

class ControllerServer : public nav2_util::LifecycleNode {
 public:
  explicit ControllerServer(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~ControllerServer();

 protected:
  using Action = nav2_msgs::action::FollowPath;
  using ActionServer = nav2_util::SimpleActionServer<Action>;

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  /// The work of a goal.
  void computeControl();
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

 private:
  /// Plugins of one base, by their names.
  template <typename BaseT>
  struct Plugins {
    Plugins(const std::string& kind_name, const std::string& base)
        : kind(kind_name), loader("nav2_core", base) {}
    std::string kind;  // as the log names it
    pluginlib::ClassLoader<BaseT> loader;
    std::unordered_map<std::string, std::shared_ptr<BaseT>> loaded;
    std::string names;  // for messages
    std::string current;
  };

  template <typename BaseT, typename PrepareT>
  bool load(Plugins<BaseT>& plugins, const std::string& parameter, PrepareT prepare);
  void declareDefaultTypes();
  bool findController(const std::string& name);
  bool findGoalChecker(const std::string& name);
  bool findProgressChecker(const std::string& name, std::string& found);

  void begin(const Action::Goal& goal);
  void followUntilReached();
  /// Whether the goal was given up.
  bool isCancelled();
  void waitForCostmap();
  void updateGlobalPath();
  void setPlannerPath(const nav_msgs::msg::Path& path);
  bool isGoalReached();
  void computeAndPublishVelocity();
  geometry_msgs::msg::TwistStamped nextVelocity(const geometry_msgs::msg::PoseStamped& pose);
  void publishFeedback(const geometry_msgs::msg::PoseStamped& pose,
                       const geometry_msgs::msg::Twist& velocity);
  void fail(uint16_t code, const std::exception& error);
  void publishVelocity(const geometry_msgs::msg::TwistStamped& velocity);
  void publishZeroVelocity();
  geometry_msgs::msg::TwistStamped stopped() const;
  /// From the odometry; parts that are below their thresholds are 0.
  geometry_msgs::msg::Twist currentVelocity();

  Plugins<nav2_core::ProgressChecker> progress_checkers_;
  Plugins<nav2_core::GoalChecker> goal_checkers_;
  Plugins<nav2_core::Controller> controllers_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros_;
  std::unique_ptr<nav2_util::NodeThread> costmap_thread_;
  std::unique_ptr<ActionServer> action_server_;
  std::unique_ptr<nav2_util::TwistPublisher> vel_publisher_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odom_sub_;
  rclcpp::Subscription<nav2_msgs::msg::SpeedLimit>::SharedPtr speed_limit_sub_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  std::mutex dynamic_params_lock_;
  std::mutex odom_lock_;
  geometry_msgs::msg::Twist odom_;

  double controller_frequency_ = 20.0;  // Hz
  double min_x_velocity_threshold_ = 1e-4;
  double min_y_velocity_threshold_ = 1e-4;
  double min_theta_velocity_threshold_ = 1e-4;
  double failure_tolerance_ = 0.0;  // s; -1: for ever
  rclcpp::Duration costmap_update_timeout_;

  geometry_msgs::msg::PoseStamped end_pose_;
  nav_msgs::msg::Path current_path_;
  rclcpp::Time last_valid_cmd_time_;
};

}  // namespace nav2_controller
