// Shows a velocity as an arrow above the robot.
#include <cmath>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <string>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "visualization_msgs/msg/marker.hpp"

namespace twist_mux {
namespace {

/// Width of the shaft and of the head, in parts of the parameter `scale` [m].
constexpr double kShaft = 0.05;
constexpr double kHead = 2 * kShaft;
/// An arrow without a length is an error of whoever draws it.
constexpr double kShortest = 0.01;

class TwistMarker : public rclcpp::Node {
 public:
  TwistMarker() : Node("twist_marker") {
    marker_.header.frame_id = declare_parameter("frame_id", "base_footprint");
    const double scale = declare_parameter("scale", 1.0);
    const bool is_stamped = declare_parameter("use_stamped", true);
    marker_.pose.position.z = declare_parameter("vertical_position", 2.0);
    marker_.type = visualization_msgs::msg::Marker::ARROW;
    marker_.points.resize(2);
    marker_.points[1].z = kShortest;
    marker_.scale.x = kShaft * scale;
    marker_.scale.y = kHead * scale;
    marker_.color.a = 1.0;
    marker_.color.g = 1.0;
    publisher_ = create_publisher<visualization_msgs::msg::Marker>(
        "marker", rclcpp::QoS(rclcpp::KeepLast(1)));
    if (is_stamped) {
      subscription_ = create_subscription<geometry_msgs::msg::TwistStamped>(
          "twist", rclcpp::SystemDefaultsQoS(),
          [this](const geometry_msgs::msg::TwistStamped& message) { show(message.twist); });
    } else {
      subscription_ = create_subscription<geometry_msgs::msg::Twist>(
          "twist", rclcpp::SystemDefaultsQoS(),
          [this](const geometry_msgs::msg::Twist& message) { show(message); });
    }
  }

 private:
  void show(const geometry_msgs::msg::Twist& twist) {
    const bool is_sideways = std::abs(twist.linear.y) > std::abs(twist.angular.z);
    marker_.points[1].x = twist.linear.x;
    marker_.points[1].y = is_sideways ? twist.linear.y : twist.angular.z;
    publisher_->publish(marker_);
  }

  visualization_msgs::msg::Marker marker_;
  rclcpp::Publisher<visualization_msgs::msg::Marker>::SharedPtr publisher_;
  rclcpp::SubscriptionBase::SharedPtr subscription_;
};

}  // namespace
}  // namespace twist_mux

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<twist_mux::TwistMarker>());
  rclcpp::shutdown();
  return 0;
}
