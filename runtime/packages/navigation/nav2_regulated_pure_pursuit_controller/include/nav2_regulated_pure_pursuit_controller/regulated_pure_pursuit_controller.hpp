// A controller that steers to a point ahead on the path, slower in tight turns, near obstacles and
// near the goal.
#pragma once

#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose2_d.hpp"
#include "nav2_core/controller.hpp"
#include "nav2_core/controller_exceptions.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_costmap_2d/footprint_collision_checker.hpp"
#include "nav_msgs/msg/path.hpp"
#include "std_msgs/msg/bool.hpp"

namespace nav2_regulated_pure_pursuit_controller {

/// The parameters of the plugin, under their names. Lengths in m, times in s, angles in rad.
struct Parameters {
  double desired_linear_vel = 0.5;
  double base_desired_linear_vel = 0.5;  // without a speed limit
  double lookahead_dist = 0.6;
  double min_lookahead_dist = 0.3;
  double max_lookahead_dist = 0.9;
  double lookahead_time = 1.5;
  double rotate_to_heading_angular_vel = 1.8;
  double transform_tolerance = 0.1;
  bool use_velocity_scaled_lookahead_dist = false;
  double min_approach_linear_velocity = 0.05;
  double approach_velocity_scaling_dist = 0.6;
  double max_allowed_time_to_collision_up_to_carrot = 1.0;
  bool use_regulated_linear_velocity_scaling = true;
  bool use_cost_regulated_linear_velocity_scaling = true;
  double cost_scaling_dist = 0.6;
  double cost_scaling_gain = 1.0;
  double inflation_cost_scaling_factor = 3.0;
  double regulated_linear_scaling_min_radius = 0.9;
  double regulated_linear_scaling_min_speed = 0.25;
  bool use_fixed_curvature_lookahead = false;
  double curvature_lookahead_dist = 0.6;
  bool use_rotate_to_heading = true;
  double rotate_to_heading_min_angle = 0.785;
  double max_angular_accel = 3.2;
  bool use_cancel_deceleration = false;
  double cancel_deceleration = 3.2;
  bool allow_reversing = false;
  double max_robot_pose_search_dist = std::numeric_limits<double>::max();
  bool interpolate_curvature_after_goal = false;
  bool use_collision_detection = true;
  bool stateful = true;
};

class RegulatedPurePursuitController : public nav2_core::Controller {
 public:
  RegulatedPurePursuitController() = default;
  ~RegulatedPurePursuitController() override = default;

  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                 std::shared_ptr<tf2_ros::Buffer> tf,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override;
  void cleanup() override;
  void activate() override;
  void deactivate() override;
  void setPlan(const nav_msgs::msg::Path& path) override;
  geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker) override;
  bool cancel() override;
  void setSpeedLimit(const double& speed_limit, const bool& percentage) override;
  void reset() override;

 private:
  using PoseStamped = geometry_msgs::msg::PoseStamped;
  using Path = nav_msgs::msg::Path;
  struct Speeds {
    double linear = 0.0;   // m/s
    double angular = 0.0;  // rad/s
  };
  template <typename MessageT>
  using Publisher = std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<MessageT>>;

  // parameters.cpp
  void readParameters();
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);
  // plan_window.cpp: the part of the plan that is ahead and within the costmap, in the robot's
  // frame.
  Path planAhead(const PoseStamped& pose);
  PoseStamped transformed(const PoseStamped& pose, const std::string& frame) const;

  geometry_msgs::msg::Point pointAhead(double distance, const Path& path,
                                       bool goes_beyond_end = false) const;
  double lookAheadDistance(double speed) const;
  /// To the first pose where the path turns back.
  double distanceToCusp(const Path& path) const;
  Speeds speedsFor(const PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
                   const Path& path, const geometry_msgs::msg::Point& carrot,
                   const geometry_msgs::msg::Point& curvature_carrot);
  double drivingSpeed(const PoseStamped& pose, const Path& path, double curvature) const;
  double brakingSpeed(double speed, double direction);
  bool turnsToGoal(const geometry_msgs::msg::Point& carrot);
  bool isCollisionImminent(const PoseStamped& pose, const Speeds& speeds, double carrot_distance);
  bool isInCollision(double x, double y, double theta);
  double costAt(double x, double y) const;
  void showPoint(const Publisher<geometry_msgs::msg::PointStamped>& publisher,
                 const geometry_msgs::msg::Point& point, const std_msgs::msg::Header& header) const;

  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  rclcpp::Logger logger_{rclcpp::get_logger("RegulatedPurePursuitController")};
  std::string plugin_name_;
  std::shared_ptr<tf2_ros::Buffer> tf_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros_;
  nav2_costmap_2d::Costmap2D* costmap_ = nullptr;
  std::unique_ptr<nav2_costmap_2d::FootprintCollisionChecker<nav2_costmap_2d::Costmap2D*>> checker_;
  std::mutex mutex_;  // of the parameters
  Parameters params_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;

  Path global_plan_;                // what is left of it
  double control_duration_ = 0.05;  // s
  double goal_dist_tol_ = 0.25;     // m, of the goal checker
  bool has_reached_xy_tolerance_ = false;
  bool is_rotating_to_heading_ = false;
  bool cancelling_ = false;
  bool finished_cancelling_ = false;

  Publisher<Path> global_path_pub_;
  Publisher<geometry_msgs::msg::PointStamped> carrot_pub_;
  Publisher<geometry_msgs::msg::PointStamped> curvature_carrot_pub_;
  Publisher<std_msgs::msg::Bool> is_rotating_to_heading_pub_;
  Publisher<Path> carrot_arc_pub_;
};

}  // namespace nav2_regulated_pure_pursuit_controller
