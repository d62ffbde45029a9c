// Drives a distance ahead, and compares it with how much nearer the wall came.
#include <cmath>
#include <functional>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"

using std::placeholders::_1;

class DriveAhead : public rclcpp::Node {
public:
  DriveAhead() : Node("drive_ahead") {
    distance_ = declare_parameter<double>("distance", 1.0);
    cmd_pub_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", rclcpp::QoS(10));
    odom_sub_ = create_subscription<nav_msgs::msg::Odometry>("odom", rclcpp::QoS(10), std::bind(&DriveAhead::onOdom, this, _1));
    scan_sub_ = create_subscription<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS(), std::bind(&DriveAhead::onScan, this, _1));
  }

private:
  enum class State { Waiting, Driving, Stopping, Done };

  void onScan(const sensor_msgs::msg::LaserScan::SharedPtr scan) {
    ahead_ = scan->ranges[scan->ranges.size() / 2];
    left_ = scan->ranges.back();
    scan_time_ = rclcpp::Time(scan->header.stamp).seconds();
  }

  void onOdom(const nav_msgs::msg::Odometry::SharedPtr odom) {
    const double now = rclcpp::Time(odom->header.stamp).seconds();
    const double x = odom->pose.pose.position.x;
    geometry_msgs::msg::Twist command;
    switch (state_) {
      case State::Waiting:
        if (since_ < 0) since_ = now;
        if (now < since_ + 0.5 || scan_time_ < since_ + 0.4) return;
        start_x_ = x;
        start_ahead_ = ahead_;
        RCLCPP_INFO(get_logger(), "start at %.2f m, wall %.2f m ahead, %.2f m to the left", x, ahead_, left_);
        state_ = State::Driving;
        break;
      case State::Driving:
        // Slower towards the end, so that it stops where it should.
        command.linear.x = std::min(0.5, 0.05 + 2 * (distance_ - (x - start_x_)));
        if (x - start_x_ >= distance_) {
          command.linear.x = 0.0;
          since_ = now;
          state_ = State::Stopping;
        }
        break;
      case State::Stopping:
        if (now < since_ + 0.5 || scan_time_ < since_ + 0.4) break;
        RCLCPP_INFO(get_logger(), "drove %.2f m, the wall came %.2f m nearer", x - start_x_, start_ahead_ - ahead_);
        state_ = State::Done;
        break;
      case State::Done:
        return;
    }
    cmd_pub_->publish(command);
  }

  double distance_, start_x_ = 0, start_ahead_ = 0, ahead_ = 0, left_ = 0, since_ = -1, scan_time_ = -1;
  State state_ = State::Waiting;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr cmd_pub_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odom_sub_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scan_sub_;
};

int main(int argc, char * argv[]) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<DriveAhead>();
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
