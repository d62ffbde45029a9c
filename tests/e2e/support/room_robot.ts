// A room of 5 m by 5 m with a wall, and a robot in it that does what it is commanded: for tests of navigation.

/** A base that does what it is commanded: odometry and transforms at 50 Hz. */
export const base = `
#include <cmath>

#include "geometry_msgs/msg/twist.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/bool.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"

using namespace std::chrono_literals;

class Base : public rclcpp::Node {
 public:
  Base() : Node("base"), moves_(this), fixed_(this) {
    geometry_msgs::msg::TransformStamped origin;
    origin.header.frame_id = "map";
    origin.child_frame_id = "odom";
    origin.transform.translation.x = origin.transform.translation.y = -1.975;
    origin.transform.rotation.w = 1;
    fixed_.sendTransform(origin);
    odometry_ = create_publisher<nav_msgs::msg::Odometry>("odom", 10);
    commands_ = create_subscription<geometry_msgs::msg::Twist>("cmd_vel", 1, [this](const geometry_msgs::msg::Twist& twist) { twist_ = twist; });
    brakes_ = create_subscription<std_msgs::msg::Bool>("brake", 1, [this](const std_msgs::msg::Bool& brake) { is_held_ = brake.data; });
    last_ = now();
    timer_ = create_wall_timer(20ms, [this] { step(); });
  }

 private:
  void step() {
    const double dt = (now() - last_).seconds();
    last_ = now();
    const double v = is_held_ ? 0 : twist_.linear.x;
    const double w = is_held_ ? 0 : twist_.angular.z;
    x_ += v * dt * std::cos(yaw_ + w * dt / 2);
    y_ += v * dt * std::sin(yaw_ + w * dt / 2);
    yaw_ += w * dt;
    geometry_msgs::msg::TransformStamped transform;
    transform.header.stamp = last_;
    transform.header.frame_id = "odom";
    transform.child_frame_id = "base_link";
    transform.transform.translation.x = x_;
    transform.transform.translation.y = y_;
    transform.transform.rotation = nav2_util::geometry_utils::orientationAroundZAxis(yaw_);
    moves_.sendTransform(transform);
    nav_msgs::msg::Odometry message;
    message.header = transform.header;
    message.child_frame_id = "base_link";
    message.pose.pose.position.x = x_;
    message.pose.pose.position.y = y_;
    message.pose.pose.orientation = transform.transform.rotation;
    message.twist.twist.linear.x = v;
    message.twist.twist.angular.z = w;
    odometry_->publish(message);
  }
  tf2_ros::TransformBroadcaster moves_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr brakes_;
  rclcpp::TimerBase::SharedPtr timer_;
  geometry_msgs::msg::Twist twist_;
  rclcpp::Time last_;
  bool is_held_ = false;
  double x_ = 0, y_ = 0, yaw_ = 0;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Base>());
}
`;

/** Parameters of a costmap over the room's map, whose layers `more` lists. */
export const costmap = (name: string, frame: string, more: string): string => `
${name}:
  ${name}:
    ros__parameters:
      update_frequency: 10.0
      publish_frequency: 5.0
      global_frame: ${frame}
      robot_base_frame: base_link
      robot_radius: 0.15
      resolution: 0.05
${more}
      static_layer:
        plugin: "nav2_costmap_2d::StaticLayer"
        map_topic: /map
      inflation_layer:
        plugin: "nav2_costmap_2d::InflationLayer"
        cost_scaling_factor: 5.0
        inflation_radius: 0.4
`;

/** 100 x 100 pixels, the first row at the top: a border, and a wall from the bottom at x 50 over 70 rows. */
export function room(): Buffer {
  const rows = Array.from({ length: 100 }, (_, row) => {
    const y = 99 - row;
    return Array.from({ length: 100 }, (_column, x) => (x === 0 || y === 0 || x === 99 || y === 99 || (x === 50 && y < 70) ? 0 : 254));
  });
  return Buffer.concat([Buffer.from('P5\n100 100\n255\n'), Buffer.from(rows.flat())]);
}

/** Its description: cells of 0.05 m, the origin in the middle. */
export const roomYaml = 'image: room.pgm\nresolution: 0.05\norigin: [-2.5, -2.5, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n';

/** The lines that a node logs, without their heads. */
export function said(output: string, node: string): string[] {
  const line = new RegExp(`\\[${node}\\]: (.*)$`);
  return output.split('\n').flatMap((text) => line.exec(text.replace(/\x1b\[\d*m/g, ''))?.[1] ?? []); // eslint-disable-line no-control-regex
}
