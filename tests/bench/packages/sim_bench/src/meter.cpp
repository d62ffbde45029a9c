// Lets the robot drive in a circle, and measures how much simulated time passes in eight seconds.
#include <chrono>
#include <cstdlib>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rosgraph_msgs/msg/clock.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

class Meter : public rclcpp::Node {
 public:
  Meter() : Node("meter") {
    const rclcpp::QoS latest = rclcpp::SensorDataQoS();
    commands_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 1);
    count<sensor_msgs::msg::JointState>("joint_states", latest, joints_);
    count<tf2_msgs::msg::TFMessage>("/tf", latest, frames_);
    count<sensor_msgs::msg::LaserScan>("scan", latest, scans_);
    count<sensor_msgs::msg::Image>("camera/image_raw", latest, images_);
    kept_.push_back(create_subscription<nav_msgs::msg::Odometry>("odom", latest, [this](const nav_msgs::msg::Odometry& m) { drive(m); }));
    kept_.push_back(create_subscription<rosgraph_msgs::msg::Clock>("/clock", latest, [this](const rosgraph_msgs::msg::Clock& m) {
      measure(m.clock.sec + 1e-9 * m.clock.nanosec);
    }));
  }

 private:
  using Steady = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kWarm{2}, kWhile{8};

  template <typename Message>
  void count(const char* topic, const rclcpp::QoS& qos, int& counter) {
    kept_.push_back(create_subscription<Message>(topic, qos, [&counter](const Message&) { ++counter; }));
  }

  void drive(const nav_msgs::msg::Odometry& odometry) {
    geometry_msgs::msg::Twist command;
    command.linear.x = 0.2;
    command.angular.z = 0.2;
    commands_->publish(command);
    const auto& p = odometry.pose.pose.position;
    if (!moves_ && p.x * p.x + p.y * p.y > 1e-4) {
      moves_ = true;
      RCLCPP_INFO(get_logger(), "the robot moves");
    }
  }

  void measure(double simulated) {
    const auto now = Steady::now();
    if (first_ < 0) first_ = simulated;
    if (simulated > first_ && begin_ == Steady::time_point()) begin_ = now;
    if (begin_ == Steady::time_point() || now < begin_ + kWarm) return;
    if (from_ < 0) {
      from_ = simulated;
      joints_ = frames_ = scans_ = images_ = 0;
      begin_ = now - kWarm;
      return;
    }
    if (now < begin_ + kWarm + kWhile || done_) return;
    done_ = true;
    const double wall = std::chrono::duration<double>(now - begin_ - kWarm).count();
    RCLCPP_INFO(get_logger(), "%.4f s of simulation in %.4f s: scans %d, images %d, joint states %d, frames %d",
                simulated - from_, wall, scans_, images_, joints_, frames_);
  }

  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> kept_;
  int joints_ = 0, frames_ = 0, scans_ = 0, images_ = 0;
  double first_ = -1, from_ = -1;  // seconds of simulation
  Steady::time_point begin_;
  bool done_ = false, moves_ = false;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Meter>());
  rclcpp::shutdown();
}
