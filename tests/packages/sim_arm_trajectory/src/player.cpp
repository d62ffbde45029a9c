// Sends a trajectory of three points, and says when each is reached.
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "trajectory_msgs/msg/joint_trajectory.hpp"

using namespace std::chrono_literals;

class Player : public rclcpp::Node
{
public:
  Player()
  : Node("player")
  {
    publisher_ = create_publisher<trajectory_msgs::msg::JointTrajectory>("joint_trajectory", 10);
    subscription_ = create_subscription<sensor_msgs::msg::JointState>(
      "joint_states", 10, [this](sensor_msgs::msg::JointState::ConstSharedPtr msg) {on_joints(*msg);});
  }

private:
  struct Point { double shoulder, elbow, lift; };
  const std::vector<std::string> names_{"shoulder", "elbow", "lift"};
  const std::vector<Point> points_{{0.8, -0.5, 0.1}, {-0.4, 1.2, 0.1}, {0.0, 0.0, -0.05}};

  void send()
  {
    trajectory_msgs::msg::JointTrajectory trajectory;
    trajectory.joint_names = names_;
    for (size_t i = 0; i < points_.size(); ++i) {
      trajectory_msgs::msg::JointTrajectoryPoint point;
      point.positions = {points_[i].shoulder, points_[i].elbow, points_[i].lift};
      point.time_from_start = rclcpp::Duration::from_seconds(2.0 * (i + 1));
      trajectory.points.push_back(point);
    }
    publisher_->publish(trajectory);
    RCLCPP_INFO(get_logger(), "sent %zu points", trajectory.points.size());
  }

  void on_joints(const sensor_msgs::msg::JointState & msg)
  {
    std::map<std::string, double> at;
    for (size_t i = 0; i < msg.name.size(); ++i) {at[msg.name[i]] = msg.position[i];}
    if (!sent_) {
      sent_ = true;
      send();
    }
    if (reached_ == points_.size()) {return;}
    const Point & to = points_[reached_];
    if (std::abs(at["shoulder"] - to.shoulder) > 0.01 || std::abs(at["elbow"] - to.elbow) > 0.01 ||
      std::abs(at["lift"] - to.lift) > 0.005) {return;}
    ++reached_;
    // Where the quill is, by the lengths of the arm: 0.4 m and 0.3 m.
    const double x = 0.4 * std::cos(at["shoulder"]) + 0.3 * std::cos(at["shoulder"] + at["elbow"]);
    const double y = 0.4 * std::sin(at["shoulder"]) + 0.3 * std::sin(at["shoulder"] + at["elbow"]);
    RCLCPP_INFO(get_logger(), "point %zu: %.1f %.1f %.2f, the quill is at %.2f %.2f",
      reached_, at["shoulder"], at["elbow"], at["lift"], x, y);
  }

  bool sent_ = false;
  size_t reached_ = 0;
  rclcpp::Publisher<trajectory_msgs::msg::JointTrajectory>::SharedPtr publisher_;
  rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr subscription_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Player>());
  rclcpp::shutdown();
  return 0;
}
