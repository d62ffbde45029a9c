// A robot with two driven wheels and a laser: takes /cmd_vel, tells /odom, /tf, /joint_states, /scan, /map and /trail.
// Its wheels take time to follow, walls stop it, and what it measures can be made to err.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "nav_msgs/msg/path.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "world.hpp"

namespace {

constexpr double kPeriod = 0.04;        // seconds
constexpr double kPatience = 0.5;       // seconds after the last /cmd_vel
constexpr double kAcceleration = 0.8;   // metres per second, per second
constexpr double kTurnAcceleration = 4.0;  // radians per second, per second
constexpr double kFastest = 1.0;        // metres per second
constexpr double kFastestTurn = 3.0;    // radians per second
constexpr double kRadius = 0.21;        // metres, of the robot; the sizes are those of its description
constexpr double kWheelRadius = 0.08;
constexpr double kWheelDistance = 0.4;
constexpr int kRays = 180;
constexpr double kNearest = 0.05;       // metres, what the laser can see
constexpr double kFarthest = 8.0;
constexpr std::size_t kMostTrail = 400;

struct Place {
  double x = 0;
  double y = 0;
  double heading = 0;
};

/// Along an arc of which the middle's direction is taken.
Place moved(const Place& from, double way, double turn) {
  const double direction = from.heading + turn / 2;
  return {from.x + way * std::cos(direction), from.y + way * std::sin(direction),
          std::remainder(from.heading + turn, 2 * M_PI)};
}

geometry_msgs::msg::Quaternion rotation(double heading) {
  geometry_msgs::msg::Quaternion q;
  q.z = std::sin(heading / 2);
  q.w = std::cos(heading / 2);
  return q;
}

class Simulator : public rclcpp::Node {
public:
  Simulator() : Node("simulator"), frames_(this), fixed_frames_(this) {
    declare("laser_noise", 0.01, 0.2, "standard deviation of what the laser measures, in metres");
    declare("odometry_error", 0.0, 0.2, "share by which odometry counts ways too long and turns too short");
    odometry_ = create_publisher<nav_msgs::msg::Odometry>("odom", 10);
    joints_ = create_publisher<sensor_msgs::msg::JointState>("joint_states", 10);
    scan_ = create_publisher<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS());
    trail_publisher_ = create_publisher<nav_msgs::msg::Path>("trail", 1);
    map_ = create_publisher<nav_msgs::msg::OccupancyGrid>("map", rclcpp::QoS(1).transient_local());
    command_ = create_subscription<geometry_msgs::msg::Twist>(
        "cmd_vel", 10, [this](const geometry_msgs::msg::Twist& twist) {
          if (!std::isfinite(twist.linear.x) || !std::isfinite(twist.angular.z)) return;
          wanted_ = twist;
          since_command_ = 0;
        });
    trail_.header.frame_id = "odom";
    tell_map();
    const rclcpp::Duration period = rclcpp::Duration::from_seconds(kPeriod);
    timer_ = rclcpp::create_timer(this, get_clock(), period, [this] { step(); });
    scan_timer_ = rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(0.1),
                                       [this] { tell_scan(); });
    trail_timer_ = rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(0.25),
                                        [this] { tell_trail(); });
    RCLCPP_INFO(get_logger(), "A world of %.0f by %.0f metres", world::kColumns * world::kCell,
                world::kRows * world::kCell);
  }

private:
  void declare(const std::string& name, double value, double most, const std::string& description) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = description;
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].to_value = most;
    declare_parameter(name, value, descriptor);
  }

  void tell_map() {
    nav_msgs::msg::OccupancyGrid map;
    map.header.frame_id = "map";
    map.header.stamp = now();
    map.info.resolution = static_cast<float>(world::kCell);
    map.info.width = world::kColumns;
    map.info.height = world::kRows;
    map.info.origin.position.x = world::kLeft;
    map.info.origin.position.y = world::kBottom;
    map.data = world::cells();
    map_->publish(map);
    // Nothing corrects odometry here: the map's frame is where the robot began.
    geometry_msgs::msg::TransformStamped origin;
    origin.header = map.header;
    origin.child_frame_id = "odom";
    fixed_frames_.sendTransform(origin);
  }

  void step() {
    since_command_ += kPeriod;
    if (since_command_ > kPatience) wanted_ = geometry_msgs::msg::Twist();
    const auto toward = [](double now, double wanted, double most) {
      return now + std::clamp(wanted - now, -most, most);
    };
    speed_ = toward(speed_, std::clamp(wanted_.linear.x, -kFastest, kFastest), kAcceleration * kPeriod);
    turn_ = toward(turn_, std::clamp(wanted_.angular.z, -kFastestTurn, kFastestTurn),
                   kTurnAcceleration * kPeriod);

    Place next = moved(truth_, speed_ * kPeriod, turn_ * kPeriod);
    if (!world::has_room(next.x, next.y, kRadius)) {
      RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 2000, "Bumped into a wall");
      speed_ = 0;
      next = moved(truth_, 0, turn_ * kPeriod);
    }
    truth_ = next;
    const double error = get_parameter("odometry_error").as_double();
    counted_ = moved(counted_, speed_ * kPeriod * (1 + error), turn_ * kPeriod * (1 - error));
    const double half = turn_ * kWheelDistance / 2;
    wheels_[0] = std::remainder(wheels_[0] + (speed_ - half) * kPeriod / kWheelRadius, 2 * M_PI);
    wheels_[1] = std::remainder(wheels_[1] + (speed_ + half) * kPeriod / kWheelRadius, 2 * M_PI);
    tell_place();
  }

  void tell_place() {
    nav_msgs::msg::Odometry odometry;
    odometry.header.stamp = now();
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.pose.pose.position.x = counted_.x;
    odometry.pose.pose.position.y = counted_.y;
    odometry.pose.pose.orientation = rotation(counted_.heading);
    odometry.twist.twist.linear.x = speed_;
    odometry.twist.twist.angular.z = turn_;
    odometry_->publish(odometry);

    geometry_msgs::msg::TransformStamped frame;
    frame.header = odometry.header;
    frame.child_frame_id = odometry.child_frame_id;
    frame.transform.translation.x = counted_.x;
    frame.transform.translation.y = counted_.y;
    frame.transform.rotation = odometry.pose.pose.orientation;
    frames_.sendTransform(frame);

    sensor_msgs::msg::JointState state;
    state.header.stamp = odometry.header.stamp;
    state.name = {"left_wheel_joint", "right_wheel_joint"};
    state.position = {wheels_[0], wheels_[1]};
    joints_->publish(state);
  }

  void tell_scan() {
    sensor_msgs::msg::LaserScan scan;
    scan.header.stamp = now();
    scan.header.frame_id = "laser";
    scan.angle_increment = static_cast<float>(2 * M_PI / kRays);
    scan.angle_min = static_cast<float>(-M_PI);
    scan.angle_max = scan.angle_min + static_cast<float>(kRays - 1) * scan.angle_increment;
    scan.scan_time = 0.1F;
    scan.range_min = static_cast<float>(kNearest);
    scan.range_max = static_cast<float>(kFarthest);
    const double noise = get_parameter("laser_noise").as_double();
    for (int i = 0; i < kRays; ++i) {
      const double angle = truth_.heading - M_PI + 2 * M_PI * i / kRays;
      const double range = world::ray(truth_.x, truth_.y, angle, kFarthest);
      // Infinity is what ROS calls a ray that hits nothing.
      scan.ranges.push_back(range < kFarthest ? static_cast<float>(range + noise * normal_(random_))
                                              : static_cast<float>(HUGE_VAL));
    }
    scan_->publish(scan);
  }

  void tell_trail() {
    if (!trail_.poses.empty()) {
      const auto& last = trail_.poses.back().pose.position;
      if (std::hypot(counted_.x - last.x, counted_.y - last.y) < 0.02) return;
    }
    geometry_msgs::msg::PoseStamped pose;
    pose.header.stamp = now();
    pose.header.frame_id = "odom";
    pose.pose.position.x = counted_.x;
    pose.pose.position.y = counted_.y;
    pose.pose.position.z = 0.02;  // above the map
    pose.pose.orientation = rotation(counted_.heading);
    if (trail_.poses.size() == kMostTrail) trail_.poses.erase(trail_.poses.begin());
    trail_.poses.push_back(pose);
    trail_.header.stamp = pose.header.stamp;
    trail_publisher_->publish(trail_);
  }

  Place truth_;    ///< where the robot is
  Place counted_;  ///< where it takes itself to be
  double speed_ = 0;
  double turn_ = 0;
  std::array<double, 2> wheels_{};  ///< radians, the left one first
  geometry_msgs::msg::Twist wanted_;
  double since_command_ = 0;
  nav_msgs::msg::Path trail_;
  std::mt19937 random_{5};  // the same noise in each run
  std::normal_distribution<double> normal_;
  tf2_ros::TransformBroadcaster frames_;
  tf2_ros::StaticTransformBroadcaster fixed_frames_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Publisher<sensor_msgs::msg::JointState>::SharedPtr joints_;
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scan_;
  rclcpp::Publisher<nav_msgs::msg::Path>::SharedPtr trail_publisher_;
  rclcpp::Publisher<nav_msgs::msg::OccupancyGrid>::SharedPtr map_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr command_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::TimerBase::SharedPtr scan_timer_;
  rclcpp::TimerBase::SharedPtr trail_timer_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Simulator>());
  rclcpp::shutdown();
  return 0;
}
