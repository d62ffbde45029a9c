// See footprint_subscriber.hpp.
#include "nav2_costmap_2d/footprint_subscriber.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "tf2/utils.h"

namespace nav2_costmap_2d {

using geometry_msgs::msg::PolygonStamped;

FootprintSubscriber::FootprintSubscriber(const nav2_util::LifecycleNode::WeakPtr& parent,
                                         const std::string& topic_name, tf2_ros::Buffer& tf,
                                         std::string robot_base_frame, double transform_tolerance)
    : tf_(tf),
      robot_base_frame_(std::move(robot_base_frame)),
      transform_tolerance_(transform_tolerance) {
  footprint_sub_ = parent.lock()->create_subscription<PolygonStamped>(
      topic_name, rclcpp::SystemDefaultsQoS(),
      [this](const PolygonStamped::SharedPtr message) { footprint_callback(message); });
}

FootprintSubscriber::FootprintSubscriber(const rclcpp::Node::WeakPtr& parent,
                                         const std::string& topic_name, tf2_ros::Buffer& tf,
                                         std::string robot_base_frame, double transform_tolerance)
    : tf_(tf),
      robot_base_frame_(std::move(robot_base_frame)),
      transform_tolerance_(transform_tolerance) {
  footprint_sub_ = parent.lock()->create_subscription<PolygonStamped>(
      topic_name, rclcpp::SystemDefaultsQoS(),
      [this](const PolygonStamped::SharedPtr message) { footprint_callback(message); });
}

bool FootprintSubscriber::getFootprintRaw(std::vector<geometry_msgs::msg::Point>& footprint,
                                          std_msgs::msg::Header& footprint_header) {
  if (!footprint_received_) return false;
  const PolygonStamped::SharedPtr current = std::atomic_load(&footprint_);
  footprint = toPointVector(std::make_shared<geometry_msgs::msg::Polygon>(current->polygon));
  footprint_header = current->header;
  return true;
}

bool FootprintSubscriber::getFootprintInRobotFrame(
    std::vector<geometry_msgs::msg::Point>& footprint, std_msgs::msg::Header& footprint_header) {
  if (!getFootprintRaw(footprint, footprint_header)) return false;
  geometry_msgs::msg::PoseStamped pose;
  if (!nav2_util::getCurrentPose(pose, tf_, footprint_header.frame_id, robot_base_frame_,
                                 transform_tolerance_, footprint_header.stamp)) {
    return false;
  }
  const double yaw = tf2::getYaw(pose.pose.orientation);
  for (auto& point : footprint) {
    const double dx = point.x - pose.pose.position.x;
    const double dy = point.y - pose.pose.position.y;
    point.x = dx * std::cos(yaw) + dy * std::sin(yaw);
    point.y = -dx * std::sin(yaw) + dy * std::cos(yaw);
  }
  footprint_header.frame_id = robot_base_frame_;
  return true;
}

void FootprintSubscriber::footprint_callback(const PolygonStamped::SharedPtr msg) {
  std::atomic_store(&footprint_, msg);
  footprint_received_ = true;
}

}  // namespace nav2_costmap_2d
