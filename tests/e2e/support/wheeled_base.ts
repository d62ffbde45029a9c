// A base for tests of Nav2, as the text of a C++ node: it does what `cmd_vel` commands and publishes odometry and transforms at 50 Hz. `place`
// moves it elsewhere. Its map has 8 m by 8 m and a wall at x 1 m.

export const wheeledBase = `
#include <cmath>

#include "geometry_msgs/msg/pose2_d.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"

using namespace std::chrono_literals;

class Base : public rclcpp::Node {
 public:
  Base() : Node("base"), moves_(this), fixed_(this) {
    geometry_msgs::msg::TransformStamped origin;
    origin.header.frame_id = "map";
    origin.child_frame_id = "odom";
    origin.transform.rotation.w = 1;
    fixed_.sendTransform(origin);
    maps_ = create_publisher<nav_msgs::msg::OccupancyGrid>("map", rclcpp::QoS(1).transient_local());
    publish_map();
    odometry_ = create_publisher<nav_msgs::msg::Odometry>("odom", 10);
    commands_ = create_subscription<geometry_msgs::msg::Twist>("cmd_vel", 1, [this](const geometry_msgs::msg::Twist& twist) { twist_ = twist; });
    places_ = create_subscription<geometry_msgs::msg::Pose2D>("place", 1, [this](const geometry_msgs::msg::Pose2D& pose) { pose_ = pose; });
    last_ = now();
    timer_ = create_wall_timer(20ms, [this] { step(); });
  }

 private:
  void publish_map() {
    nav_msgs::msg::OccupancyGrid map;
    map.header.frame_id = "map";
    map.info.resolution = 0.05f;
    map.info.width = map.info.height = 160;
    map.info.origin.position.x = map.info.origin.position.y = -4;
    map.info.origin.orientation.w = 1;
    map.data.assign(160 * 160, 0);
    for (int y = 0; y < 160; ++y) map.data[y * 160 + 100] = 100;
    maps_->publish(map);
  }
  void step() {
    const double dt = (now() - last_).seconds();
    last_ = now();
    const double v = twist_.linear.x, w = twist_.angular.z;
    pose_.x += v * dt * std::cos(pose_.theta + w * dt / 2);
    pose_.y += v * dt * std::sin(pose_.theta + w * dt / 2);
    pose_.theta += w * dt;
    nav_msgs::msg::Odometry message;
    message.header.stamp = last_;
    message.header.frame_id = "odom";
    message.child_frame_id = "base_link";
    message.pose.pose.position.x = pose_.x;
    message.pose.pose.position.y = pose_.y;
    message.pose.pose.orientation = nav2_util::geometry_utils::orientationAroundZAxis(pose_.theta);
    message.twist.twist = twist_;
    odometry_->publish(message);
    geometry_msgs::msg::TransformStamped transform;
    transform.header = message.header;
    transform.child_frame_id = "base_link";
    transform.transform.translation.x = pose_.x;
    transform.transform.translation.y = pose_.y;
    transform.transform.rotation = message.pose.pose.orientation;
    moves_.sendTransform(transform);
  }
  tf2_ros::TransformBroadcaster moves_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  rclcpp::Publisher<nav_msgs::msg::OccupancyGrid>::SharedPtr maps_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Subscription<geometry_msgs::msg::Pose2D>::SharedPtr places_;
  rclcpp::TimerBase::SharedPtr timer_;
  geometry_msgs::msg::Twist twist_;
  geometry_msgs::msg::Pose2D pose_;
  rclcpp::Time last_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Base>());
}
`;
