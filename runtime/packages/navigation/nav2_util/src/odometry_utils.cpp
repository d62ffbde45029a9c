// See odometry_utils.hpp.
#include "nav2_util/odometry_utils.hpp"

#include <utility>

namespace nav2_util {
namespace {

/// Adds a velocity times a factor.
void add(geometry_msgs::msg::Twist& sum, const geometry_msgs::msg::Twist& twist, double factor) {
  sum.linear.x += factor * twist.linear.x;
  sum.linear.y += factor * twist.linear.y;
  sum.linear.z += factor * twist.linear.z;
  sum.angular.x += factor * twist.angular.x;
  sum.angular.y += factor * twist.angular.y;
  sum.angular.z += factor * twist.angular.z;
}

template <typename NodeT, typename CallbackT>
auto subscribe(const std::weak_ptr<NodeT>& parent, const std::string& topic, CallbackT callback) {
  return parent.lock()->template create_subscription<nav_msgs::msg::Odometry>(
      topic, rclcpp::SystemDefaultsQoS(), std::move(callback));
}

}  // namespace

OdomSmoother::OdomSmoother(const rclcpp::Node::WeakPtr& parent, double filter_duration,
                           const std::string& odom_topic)
    : odom_history_duration_(rclcpp::Duration::from_seconds(filter_duration)) {
  odom_sub_ = subscribe(parent, odom_topic, [this](nav_msgs::msg::Odometry::SharedPtr message) {
    odomCallback(std::move(message));
  });
}

OdomSmoother::OdomSmoother(const nav2_util::LifecycleNode::WeakPtr& parent, double filter_duration,
                           const std::string& odom_topic)
    : odom_history_duration_(rclcpp::Duration::from_seconds(filter_duration)) {
  odom_sub_ = subscribe(parent, odom_topic, [this](nav_msgs::msg::Odometry::SharedPtr message) {
    odomCallback(std::move(message));
  });
}

void OdomSmoother::odomCallback(nav_msgs::msg::Odometry::SharedPtr msg) {
  const std::lock_guard<std::mutex> lock(odom_mutex_);
  const rclcpp::Time now(msg->header.stamp);
  while (!odom_history_.empty() &&
         now - rclcpp::Time(odom_history_.front().header.stamp) > odom_history_duration_) {
    add(odom_cumulate_.twist.twist, odom_history_.front().twist.twist, -1.0);
    odom_history_.pop_front();
  }
  odom_history_.push_back(*msg);
  updateState();
}

void OdomSmoother::updateState() {
  const nav_msgs::msg::Odometry& newest = odom_history_.back();
  add(odom_cumulate_.twist.twist, newest.twist.twist, 1.0);
  vel_smooth_.header = newest.header;
  vel_smooth_.twist = geometry_msgs::msg::Twist();
  add(vel_smooth_.twist, odom_cumulate_.twist.twist,
      1.0 / static_cast<double>(odom_history_.size()));
}

}  // namespace nav2_util
