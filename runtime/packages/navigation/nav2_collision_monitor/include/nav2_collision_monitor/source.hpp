// A sensor, or another node, that says where obstacles are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_collision_monitor/types.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/header.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2/time.h"
#include "tf2_ros/buffer.h"

namespace nav2_collision_monitor {

class Source {
 public:
  Source(const nav2_util::LifecycleNode::WeakPtr& node, const std::string& source_name,
         const std::shared_ptr<tf2_ros::Buffer> tf_buffer, const std::string& base_frame_id,
         const std::string& global_frame_id, const tf2::Duration& transform_tolerance,
         const rclcpp::Duration& source_timeout, const bool base_shift_correction);
  virtual ~Source();

  /// Reads parameters and subscribes. Throws for a parameter that cannot be used.
  virtual void configure();
  /// Appends obstacles in the frame of the robot as it is at that time. False: the source cannot be
  /// used, and the robot has to stop.
  virtual bool getData(const rclcpp::Time& curr_time, std::vector<Point>& data) = 0;

  bool getEnabled() const { return enabled_; }
  std::string getSourceName() const { return source_name_; }
  rclcpp::Duration getSourceTimeout() const { return source_timeout_; }

 protected:
  void getCommonParameters(std::string& source_topic);
  /// False, with a warning, when the data is too old.
  bool sourceValid(const rclcpp::Time& source_time, const rclcpp::Time& curr_time) const;
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);
  /// From the frame of the data to the robot; with `base_shift_correction`, the robot moved since.
  bool getTransform(const rclcpp::Time& curr_time, const std_msgs::msg::Header& data_header,
                    tf2::Transform& tf_transform) const;

  nav2_util::LifecycleNode::WeakPtr node_;
  rclcpp::Logger logger_{rclcpp::get_logger("collision_monitor")};
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  std::string source_name_;
  std::shared_ptr<tf2_ros::Buffer> tf_buffer_;
  std::string base_frame_id_;
  std::string global_frame_id_;
  tf2::Duration transform_tolerance_;
  rclcpp::Duration source_timeout_;  // 0: data does not age
  bool base_shift_correction_;
  bool enabled_ = true;
};

/// The points in another frame, without their height.
void appendTransformed(const std::vector<Point>& points, const tf2::Transform& transform,
                       std::vector<Point>& data);

}  // namespace nav2_collision_monitor
