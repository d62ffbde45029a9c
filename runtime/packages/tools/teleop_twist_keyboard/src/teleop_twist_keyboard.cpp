// Drives by keys. One thread: between keys the node is spun.
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <stdexcept>
#include <string>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "ros2wasm/keyboard.hpp"

namespace {

constexpr const char* kKeys = R"(
This node takes keypresses from the keyboard and publishes them
as Twist/TwistStamped messages. It works best with a US keyboard layout.
---------------------------
Moving around:
   u    i    o
   j    k    l
   m    ,    .

For Holonomic mode (strafing), hold down the shift key:
---------------------------
   U    I    O
   J    K    L
   M    <    >

t : up (+z)
b : down (-z)

anything else : stop

q/z : increase/decrease max speeds by 10%
w/x : increase/decrease only linear speed by 10%
e/c : increase/decrease only angular speed by 10%

CTRL-C to quit
)";
constexpr char kControlC = '\x03';
/// The keys are printed again after so many changes of speed.
constexpr int kKeysEvery = 15;

/// Directions, in parts of the speeds.
struct Move {
  double x = 0;
  double y = 0;
  double z = 0;
  double turn = 0;
};
const std::map<char, Move> kMoves = {
    {'i', {1, 0, 0, 0}},  {'o', {1, 0, 0, -1}}, {'j', {0, 0, 0, 1}},   {'l', {0, 0, 0, -1}},
    {'u', {1, 0, 0, 1}},  {',', {-1, 0, 0, 0}}, {'.', {-1, 0, 0, 1}},  {'m', {-1, 0, 0, -1}},
    {'O', {1, -1, 0, 0}}, {'I', {1, 0, 0, 0}},  {'J', {0, 1, 0, 0}},   {'L', {0, -1, 0, 0}},
    {'U', {1, 1, 0, 0}},  {'<', {-1, 0, 0, 0}}, {'>', {-1, -1, 0, 0}}, {'M', {-1, 1, 0, 0}},
    {'t', {0, 0, 1, 0}},  {'b', {0, 0, -1, 0}},
};

/// Factors of both speeds.
struct Change {
  double ahead = 1;
  double turn = 1;
};
const std::map<char, Change> kChanges = {
    {'q', {1.1, 1.1}}, {'z', {0.9, 0.9}}, {'w', {1.1, 1}},
    {'x', {0.9, 1}},   {'e', {1, 1.1}},   {'c', {1, 0.9}},
};

class Teleop {
 public:
  Teleop() : node_(std::make_shared<rclcpp::Node>("teleop_twist_keyboard")) {
    rcl_interfaces::msg::ParameterDescriptor fixed;
    fixed.read_only = true;
    const bool is_stamped = node_->declare_parameter("stamped", false, fixed);
    frame_id_ = node_->declare_parameter("frame_id", std::string(), fixed);
    speed_ = node_->declare_parameter("speed", 0.5, fixed);
    turn_ = node_->declare_parameter("turn", 1.0, fixed);
    if (!is_stamped && !frame_id_.empty()) {
      throw std::runtime_error("'frame_id' can only be set when 'stamped' is True");
    }
    if (is_stamped) {
      stamped_ = node_->create_publisher<geometry_msgs::msg::TwistStamped>("cmd_vel", 10);
    } else {
      plain_ = node_->create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    }
  }

  void run() {
    const ros2wasm::Keyboard keyboard;
    std::puts(kKeys);
    say_speeds();
    while (rclcpp::ok()) {
      rclcpp::spin_some(node_);
      if (!ros2wasm::Keyboard::has_something()) continue;
      const auto key = ros2wasm::Keyboard::key();
      if (!key || *key == kControlC) break;
      if (*key != '\n') press(*key);  // the end of a line that was typed at once
    }
    if (rclcpp::ok()) drive({});
  }

 private:
  void press(char key) {
    if (const auto change = kChanges.find(key); change != kChanges.end()) {
      speed_ *= change->second.ahead;
      turn_ *= change->second.turn;
      say_speeds();
      if (++changes_ % kKeysEvery == 0) std::puts(kKeys);
      std::fflush(stdout);
    } else {
      const auto move = kMoves.find(key);
      move_ = move == kMoves.end() ? Move() : move->second;
    }
    drive(move_);
  }

  void drive(const Move& move) {
    geometry_msgs::msg::Twist twist;
    twist.linear.x = move.x * speed_;
    twist.linear.y = move.y * speed_;
    twist.linear.z = move.z * speed_;
    twist.angular.z = move.turn * turn_;
    if (plain_) {
      plain_->publish(twist);
      return;
    }
    geometry_msgs::msg::TwistStamped message;
    message.header.stamp = node_->now();
    message.header.frame_id = frame_id_;
    message.twist = twist;
    stamped_->publish(message);
  }

  void say_speeds() const {
    std::printf("currently:\tspeed %g\tturn %g \n", speed_, turn_);
    std::fflush(stdout);
  }

  rclcpp::Node::SharedPtr node_;
  std::string frame_id_;
  double speed_ = 0;  ///< [m/s]
  double turn_ = 0;   ///< [rad/s]
  Move move_;
  int changes_ = 0;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr plain_;
  rclcpp::Publisher<geometry_msgs::msg::TwistStamped>::SharedPtr stamped_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Teleop().run();
  rclcpp::shutdown();
  return 0;
}
