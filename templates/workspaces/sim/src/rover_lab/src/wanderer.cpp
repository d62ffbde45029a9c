// Drives forward, and turns on the spot while something is near.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"

class Wanderer : public rclcpp::Node {
 public:
  Wanderer() : Node("wanderer") {
    declare_parameter("speed", 0.25);     // m/s
    declare_parameter("distance", 0.6);   // m, at which it turns away
    commands_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    scans_ = create_subscription<sensor_msgs::msg::LaserScan>(
        "scan", rclcpp::SensorDataQoS(), [this](const sensor_msgs::msg::LaserScan& scan) { look(scan); });
  }

 private:
  void look(const sensor_msgs::msg::LaserScan& scan) {
    // The nearest thing within 45 degrees of the direction of travel.
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      if (std::abs(angle) < 0.8) nearest = std::min(nearest, scan.ranges[i]);
    }
    const bool is_near = nearest < get_parameter("distance").as_double();
    if (is_near && !turning_) RCLCPP_INFO(get_logger(), "a wall in %.2f m: turning away", nearest);
    turning_ = is_near;

    geometry_msgs::msg::Twist command;
    command.linear.x = turning_ ? 0.0 : get_parameter("speed").as_double();
    command.angular.z = turning_ ? 0.8 : 0.0;
    commands_->publish(command);
  }

  bool turning_ = false;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scans_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Wanderer>());
  rclcpp::shutdown();
  return 0;
}
