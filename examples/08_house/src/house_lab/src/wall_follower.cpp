// Drives along the wall at the robot's right, at a distance that it holds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_msgs/msg/float64.hpp"

class WallFollower : public rclcpp::Node {
 public:
  WallFollower() : Node("wall_follower") {
    declare_parameter("enabled", false);
    declare_parameter("distance", 0.5, described("to the wall, in metres", 0.25, 1.5));
    declare_parameter("speed", 0.35, described("m/s", 0.0, 0.5));
    declare_parameter("k", 2.0, described("rad/s for a metre too far", 0.0, 10.0));
    declare_parameter("damping", 1.5, described("rad/s for a radian away from the wall's direction", 0.0, 5.0));
    commands_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    distances_ = create_publisher<std_msgs::msg::Float64>("wall_distance", 10);
    scans_ = create_subscription<sensor_msgs::msg::LaserScan>(
        "scan", rclcpp::SensorDataQoS(), [this](const sensor_msgs::msg::LaserScan& scan) { follow(scan); });
    odometry_ = create_subscription<nav_msgs::msg::Odometry>(
        "odom", 10, [this](const nav_msgs::msg::Odometry& odometry) { count_turns(odometry); });
  }

 private:
  static rcl_interfaces::msg::ParameterDescriptor described(const std::string& text, double from, double to) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = text;
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].from_value = from;
    descriptor.floating_point_range[0].to_value = to;
    return descriptor;
  }

  /// The least range between two angles, in degrees to the left of straight ahead.
  static double least(const sensor_msgs::msg::LaserScan& scan, double from, double to) {
    double result = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < scan.ranges.size(); ++i) {
      const double degrees = (scan.angle_min + i * scan.angle_increment) * 180 / M_PI;
      const double range = scan.ranges[i];
      if (degrees >= from && degrees <= to && range > 0) result = std::min(result, range);
    }
    return result;
  }

  void follow(const sensor_msgs::msg::LaserScan& scan) {
    const bool enabled = get_parameter("enabled").as_bool();
    if (!enabled) {
      if (was_enabled_) commands_->publish(geometry_msgs::msg::Twist());
      was_enabled_ = false;
      return;
    }
    if (!was_enabled_) {
      way_ = 0;
      found_ = went_around_ = false;
    }
    was_enabled_ = true;
    const double wanted = get_parameter("distance").as_double(), speed = get_parameter("speed").as_double();
    const double right = least(scan, -100, -50), behind_right = least(scan, -130, -100), ahead = least(scan, -25, 25);
    std_msgs::msg::Float64 distance;
    distance.data = right;
    distances_->publish(distance);

    if (!found_ && right < 1.3 * wanted) {
      found_ = true;
      way_ = 0;
    }

    geometry_msgs::msg::Twist command;
    if (ahead < wanted + 0.1) {
      command.angular.z = 0.8;  // a corner, or something in the way: to the left
    } else if (std::isinf(right) || right > 2 * wanted) {
      // The wall ends, or there is none yet: around its edge, or on to the next one.
      command.linear.x = speed;
      command.angular.z = !found_ ? 0 : behind_right < 2 * wanted ? -speed / wanted : -0.3;
    } else {
      command.linear.x = speed;
      const double towards = std::atan2(behind_right * 0.6 - right * 0.6, 0.5);
      command.angular.z = std::clamp(-get_parameter("k").as_double() * (right - wanted) +
                                         get_parameter("damping").as_double() * towards,
                                     -1.0, 1.0);
    }
    commands_->publish(command);
  }

  /// Once around the house is a way of at least 15 m along the wall that ends where it began.
  void count_turns(const nav_msgs::msg::Odometry& odometry) {
    const auto& p = odometry.pose.pose.position;
    way_ += std::hypot(p.x - x_, p.y - y_);
    if (was_enabled_ && found_) {
      if (way_ < 0.5) {
        first_x_ = p.x;
        first_y_ = p.y;
      } else if (!went_around_ && way_ > 15 && std::hypot(p.x - first_x_, p.y - first_y_) < 0.4) {
        went_around_ = true;
        RCLCPP_INFO(get_logger(), "once around: %.1f m", way_);
      }
    }
    x_ = p.x;
    y_ = p.y;
  }

  double x_ = 0, y_ = 0, first_x_ = 0, first_y_ = 0, way_ = 0;  // metres
  bool was_enabled_ = false, found_ = false, went_around_ = false;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr distances_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scans_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odometry_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<WallFollower>());
  rclcpp::shutdown();
}
