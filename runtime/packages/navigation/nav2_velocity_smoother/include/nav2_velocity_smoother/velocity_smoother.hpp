// Passes commands of velocity on such that they change only as fast as the robot can. It does not
// wake up while there is nothing to smooth.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "nav2_util/robot_utils.hpp"
#include "nav2_util/twist_publisher.hpp"
#include "nav2_util/twist_subscriber.hpp"

namespace nav2_velocity_smoother {

class VelocitySmoother : public nav2_util::LifecycleNode {
 public:
  explicit VelocitySmoother(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~VelocitySmoother();

  /// The factor that brings the change of an axis into its limits; -1 when it is within them.
  double findEtaConstraint(const double v_curr, const double v_cmd, const double accel,
                           const double decel);
  /// The velocity of an axis one cycle later.
  double applyConstraints(const double v_curr, const double v_cmd, const double accel,
                          const double decel, const double eta);

 protected:
  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  void inputCommandCallback(const geometry_msgs::msg::Twist::SharedPtr msg);
  void inputCommandStampedCallback(const geometry_msgs::msg::TwistStamped::SharedPtr msg);
  void smootherTimer();
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

  std::unique_ptr<nav2_util::OdomSmoother> odom_smoother_;
  std::unique_ptr<nav2_util::TwistPublisher> smoothed_cmd_pub_;
  std::unique_ptr<nav2_util::TwistSubscriber> cmd_sub_;
  rclcpp::TimerBase::SharedPtr timer_;
  geometry_msgs::msg::TwistStamped last_cmd_;
  geometry_msgs::msg::TwistStamped::SharedPtr command_;

  double smoothing_frequency_ = 20.0;  // Hz
  double odom_duration_ = 0.1;         // s
  std::string odom_topic_;
  bool open_loop_ = true;
  bool stopped_ = true;
  bool scale_velocities_ = false;
  bool stamp_smoothed_velocity_with_smoothing_time_ = false;
  // Along x, along y, about z.
  std::vector<double> max_velocities_;
  std::vector<double> min_velocities_;
  std::vector<double> max_accels_;
  std::vector<double> max_decels_;
  std::vector<double> deadband_velocities_;
  rclcpp::Duration velocity_timeout_{0, 0};
  rclcpp::Time last_command_time_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;

 private:
  void declareParameters();
  /// A message when a parameter cannot be used, else an empty text.
  std::string readParameters();
  void apply(const rclcpp::Parameter& parameter);
  void startTimer();
  /// Starts a timer that stopped.
  void wake();
  void listenToOdometry();
  /// Whether the robot stands and nobody commands it. Turns an old command into one to stop.
  bool isIdle(const rclcpp::Duration& age);
  geometry_msgs::msg::Twist nextVelocity();
};

}  // namespace nav2_velocity_smoother
