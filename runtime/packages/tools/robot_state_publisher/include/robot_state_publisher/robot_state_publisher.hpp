// A node that tells where each link of a robot is: fixed ones once, others when their joints move.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "builtin_interfaces/msg/time.hpp"
#include "rclcpp/rclcpp.hpp"
#include "robot_state_publisher/kinematics.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_msgs/msg/string.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"

namespace robot_state_publisher {

class RobotStatePublisher : public rclcpp::Node {
 public:
  /// Throws std::runtime_error for a description or a frequency that is none.
  explicit RobotStatePublisher(const rclcpp::NodeOptions& options);

 protected:
  void setupURDF(const std::string& urdf_xml);
  void publishFixedTransforms();
  void publishTransforms(const std::map<std::string, double>& joint_positions,
                         const builtin_interfaces::msg::Time& time);
  void callbackJointState(const sensor_msgs::msg::JointState::ConstSharedPtr state);
  rcl_interfaces::msg::SetParametersResult parameterUpdate(
      const std::vector<rclcpp::Parameter>& parameters);
  void takeParameters(const std::vector<rclcpp::Parameter>& parameters);

 private:
  std::string described_by(const std::vector<std::string>& arguments) const;
  geometry_msgs::msg::TransformStamped transform_of(const Segment& segment, double position,
                                                    const rclcpp::Time& stamp) const;

  Kinematics kinematics_;
  double publish_frequency_ = 20;
  std::string frame_prefix_;
  bool ignore_timestamp_ = false;
  rclcpp::Time last_callback_time_;
  std::map<std::string, rclcpp::Time> last_publish_time_;  ///< of each joint

  std::unique_ptr<tf2_ros::TransformBroadcaster> tf_broadcaster_;
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> static_tf_broadcaster_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr description_pub_;
  rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr joint_state_sub_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr param_cb_;
  rclcpp::node_interfaces::PostSetParametersCallbackHandle::SharedPtr param_taken_cb_;
};

}  // namespace robot_state_publisher
