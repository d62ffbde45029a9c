// Drives to a goal pose: sees it in the robot's own frame, turns towards it, goes there, and takes its heading. Between goals
// it says nothing on /cmd_vel, so that one can drive by hand. It also draws the trail of the robot's odometry.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "nav_msgs/msg/path.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_msgs/msg/float64.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

namespace {

constexpr double kPeriod = 0.05;          // seconds
constexpr double kHeadingTolerance = 0.05;  // radians
constexpr double kAhead = 0.5;            // radians to either side that count as ahead
constexpr int kPatience = 40;             // periods without the goal's frame
constexpr double kTrailStep = 0.05;       // metres between poses of the trail
constexpr std::size_t kMostTrail = 400;

class Controller : public rclcpp::Node {
public:
  Controller() : Node("controller"), buffer_(get_clock()), listener_(buffer_, this, false) {
    declare("k_distance", 1.0, 0.1, 5, "speed for each metre to the goal");
    declare("k_heading", 2.5, 0.1, 10, "turn for each radian that the goal is to the side");
    declare("k_damping", 0.2, 0, 2, "turn for each radian per second at which that angle changes");
    declare("max_speed", 0.6, 0.05, 1, "metres per second");
    declare("max_turn", 2.0, 0.1, 3, "radians per second");
    declare("tolerance", 0.05, 0.01, 0.5, "metres from the goal that are near enough");
    declare("stop_distance", 0.35, 0, 2, "metres of room ahead, measured by the laser, below which it goes no further");
    command_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    distance_ = create_publisher<std_msgs::msg::Float64>("distance", 10);
    heading_error_ = create_publisher<std_msgs::msg::Float64>("heading_error", 10);
    goals_ = create_subscription<geometry_msgs::msg::PoseStamped>(
        "goal_pose", 10, [this](const geometry_msgs::msg::PoseStamped& goal) { take(goal); });
    scan_ = create_subscription<sensor_msgs::msg::LaserScan>(
        "scan", rclcpp::SensorDataQoS(), [this](const sensor_msgs::msg::LaserScan& scan) { look(scan); });
    odometry_ = create_subscription<nav_msgs::msg::Odometry>(
        "odom", 10, [this](const nav_msgs::msg::Odometry& odometry) { draw(odometry); });
    trail_publisher_ = create_publisher<nav_msgs::msg::Path>("trail", 1);
    timer_ = rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(kPeriod),
                                  [this] { step(); });
    if (!declare_parameter("drive", true)) {
      RCLCPP_INFO(get_logger(), "Waiting for a goal");
      return;
    }
    geometry_msgs::msg::PoseStamped first;
    first.header.frame_id = "map";
    first.pose.position.x = 2.5;
    first.pose.position.y = 1.5;
    first.pose.orientation.w = 1;
    take(first);
  }

private:
  void declare(const std::string& name, double value, double least, double most,
               const std::string& description) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = description;
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].from_value = least;
    descriptor.floating_point_range[0].to_value = most;
    declare_parameter(name, value, descriptor);
  }

  [[nodiscard]] double value(const char* name) const { return get_parameter(name).as_double(); }

  void take(const geometry_msgs::msg::PoseStamped& goal) {
    goal_ = goal;
    goal_->header.stamp = rclcpp::Time();  // where it is in the newest frames
    is_there_ = false;
    last_error_.reset();
    unseen_ = 0;
    RCLCPP_INFO(get_logger(), "Driving to %.2f, %.2f in %s", goal.pose.position.x, goal.pose.position.y,
                goal.header.frame_id.c_str());
  }

  void look(const sensor_msgs::msg::LaserScan& scan) {
    room_ = scan.range_max;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      if (std::abs(angle) < kAhead && scan.ranges[i] >= scan.range_min)
        room_ = std::min(room_, static_cast<double>(scan.ranges[i]));
    }
  }

  void draw(const nav_msgs::msg::Odometry& odometry) {
    geometry_msgs::msg::PoseStamped pose;
    pose.header = odometry.header;
    pose.pose = odometry.pose.pose;
    pose.pose.position.z = 0.02;  // above the map
    if (!trail_.poses.empty()) {
      const auto& last = trail_.poses.back().pose.position;
      if (std::hypot(pose.pose.position.x - last.x, pose.pose.position.y - last.y) < kTrailStep) return;
    }
    if (trail_.poses.size() == kMostTrail) trail_.poses.erase(trail_.poses.begin());
    trail_.poses.push_back(pose);
    trail_.header = pose.header;
    trail_publisher_->publish(trail_);
  }

  void step() {
    if (!goal_) return;
    geometry_msgs::msg::PoseStamped seen;
    try {
      buffer_.transform(*goal_, seen, "base_link");
    } catch (const tf2::TransformException& error) {
      // At the start it takes some time until all have said where they are.
      if (++unseen_ < kPatience) return;
      RCLCPP_WARN(get_logger(), "Goal given up: %s", error.what());
      stop();
      return;
    }
    unseen_ = 0;
    const double distance = std::hypot(seen.pose.position.x, seen.pose.position.y);
    const double heading = tf2::getYaw(seen.pose.orientation);
    // At the goal its direction says nothing; what is left is its heading.
    is_there_ = is_there_ || distance < value("tolerance");
    const double error = is_there_ ? heading : std::atan2(seen.pose.position.y, seen.pose.position.x);
    tell(*distance_, distance);
    tell(*heading_error_, error);
    if (is_there_ && std::abs(heading) < kHeadingTolerance) {
      RCLCPP_INFO(get_logger(), "Goal reached: %.2f m and %.1f degrees off", distance,
                  std::abs(heading) * 180 / M_PI);
      stop();
      return;
    }

    // Across the back, the angle jumps by a whole turn; that is not a change.
    const double change = last_error_ ? std::remainder(error - *last_error_, 2 * M_PI) / kPeriod : 0;
    last_error_ = error;
    geometry_msgs::msg::Twist twist;
    const double most = value("max_turn");
    twist.angular.z = std::clamp(value("k_heading") * error + value("k_damping") * change, -most, most);
    if (!is_there_)
      twist.linear.x = std::min(value("max_speed"), value("k_distance") * distance) * std::max(0.0, std::cos(error));
    if (twist.linear.x > 0 && room_ < std::min(value("stop_distance"), distance)) {
      RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 3000, "Something is %.2f m ahead: no further", room_);
      twist.linear.x = 0;
    }
    command_->publish(twist);
  }

  void stop() {
    goal_.reset();
    command_->publish(geometry_msgs::msg::Twist());
  }

  static void tell(rclcpp::Publisher<std_msgs::msg::Float64>& publisher, double number) {
    std_msgs::msg::Float64 message;
    message.data = number;
    publisher.publish(message);
  }

  std::optional<geometry_msgs::msg::PoseStamped> goal_;
  bool is_there_ = false;
  std::optional<double> last_error_;
  int unseen_ = 0;
  double room_ = HUGE_VAL;  ///< metres ahead
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr command_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr distance_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr heading_error_;
  rclcpp::Subscription<geometry_msgs::msg::PoseStamped>::SharedPtr goals_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scan_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Publisher<nav_msgs::msg::Path>::SharedPtr trail_publisher_;
  nav_msgs::msg::Path trail_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Controller>());
  rclcpp::shutdown();
  return 0;
}
