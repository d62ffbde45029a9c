// The node around a filter: its inputs, its services, and what it publishes.
#pragma once

#include <list>
#include <memory>
#include <optional>
#include <string>

#include "diagnostic_updater/publisher.hpp"
#include "filter/estimator.hpp"
#include "filter/readings.hpp"
#include "geometry_msgs/msg/accel_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "geometry_msgs/msg/twist_with_covariance_stamped.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "node/filter_parameters.hpp"
#include "node/filter_report.hpp"
#include "node/transforms.hpp"
#include "rclcpp/rclcpp.hpp"
#include "robot_localization/srv/set_pose.hpp"
#include "robot_localization/srv/toggle_filter_processing.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "std_srvs/srv/empty.hpp"
#include "tf2_ros/transform_broadcaster.h"

namespace robot_localization {

class FilterNode : public rclcpp::Node {
 public:
  /// Throws std::invalid_argument for parameters with which it cannot run.
  FilterNode(const std::string& name, std::unique_ptr<Filter> filter);

  /// After the constructor, since diagnostics need a shared node.
  void start();

 private:
  using PoseMessage = geometry_msgs::msg::PoseWithCovarianceStamped;
  using SetPose = robot_localization::srv::SetPose;
  using Toggle = robot_localization::srv::ToggleFilterProcessing;

  /// The pose, the twist or the acceleration of an input: each is a measurement of its own.
  struct Part {
    std::string name;  ///< "odom0_pose"
    Variables update;
    double threshold = kNoThreshold;
    std::optional<int64_t> newest_ns;
    PoseSource poses;
  };
  struct Input {
    InputParameters settings;
    Part pose, twist, acceleration;
    rclcpp::SubscriptionBase::SharedPtr subscription;
  };
  /// A pose and what it is the pose of.
  struct PoseFrames {
    std::string target;
    std::string child;
    bool is_imu = false;
  };

  // Setting up (filter_node.cpp).
  void apply_parameters();
  void create_services();
  void create_outputs();

  // Inputs (filter_inputs.cpp).
  void subscribe();
  Input& add_input(const InputParameters& settings);
  void subscribe_control();
  void take_control(const geometry_msgs::msg::Twist& twist, const rclcpp::Time& stamp);
  void on_odometry(Input& input, const nav_msgs::msg::Odometry& message);
  void on_imu(Input& input, const sensor_msgs::msg::Imu& message);
  void on_pose(Input& input, Part& part, const PoseMessage& message, const PoseFrames& frames);
  void on_twist(Part& part, const geometry_msgs::msg::TwistWithCovarianceStamped& message);
  void on_acceleration(Input& input, const sensor_msgs::msg::Imu& message);
  std::optional<Measurement> begin(Part& part, const builtin_interfaces::msg::Time& stamp);
  void enqueue(Measurement measurement);
  Eigen::Vector3d gravity_of(const Input& input, const sensor_msgs::msg::Imu& message,
                             const Eigen::Matrix3d& base_from_sensor) const;
  std::optional<Eigen::Isometry3d> find_frame(const std::string& part, const std::string& target,
                                              const std::string& source, const rclcpp::Time& time);
  Eigen::Matrix3d checked_rotation(const Part& part, const geometry_msgs::msg::Quaternion& message);

  // Services (filter_node.cpp).
  void set_pose(const PoseMessage& message);
  void reset();
  void reset_after_jump();
  void toggle(bool on, Toggle::Response& response);
  void enable();

  // Every period (filter_output.cpp).
  void update();
  void differentiate(const rclcpp::Time& now);
  /// False when the stamp did not advance, and nothing may be published twice.
  bool publish_odometry();
  void publish_acceleration();
  void publish_transform(const nav_msgs::msg::Odometry& odometry);
  nav_msgs::msg::Odometry odometry() const;

  const FilterState& state() const { return estimator_.state(); }
  rclcpp::Time filter_time() const;

  FilterParameters parameters_;
  Estimator estimator_;
  FilterReport report_{false};
  std::list<Input> inputs_;
  Transforms transforms_;
  Turning turning_;  ///< of the estimate
  Eigen::Matrix3d turning_covariance_ = Eigen::Matrix3d::Zero();
  rclcpp::Time differentiated_at_;
  int64_t newest_published_ns_ = 0;
  int64_t set_pose_ns_ = 0;  ///< measurements from before are ignored
  bool is_enabled_ = true;
  bool is_processing_ = true;

  double least_frequency_ = 0.0;  ///< [Hz], of the diagnostics, as the next
  double most_frequency_ = 0.0;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  std::unique_ptr<diagnostic_updater::HeaderlessTopicDiagnostic> frequency_task_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_publisher_;
  rclcpp::Publisher<geometry_msgs::msg::AccelWithCovarianceStamped>::SharedPtr
      acceleration_publisher_;
  rclcpp::SubscriptionBase::SharedPtr set_pose_subscription_;
  rclcpp::SubscriptionBase::SharedPtr control_subscription_;
  rclcpp::ServiceBase::SharedPtr enable_service_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;  ///< the others
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::JumpHandler::SharedPtr jump_handler_;
  bool has_time_jumped_ = false;  ///< back, since the last reset
};

}  // namespace robot_localization
