// Conditions on the battery, on odometry, and on what the planner says of a path.
#include <optional>
#include <string>

#include "nav2_behavior_tree/bt_service_node.hpp"
#include "nav2_msgs/srv/is_path_valid.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "nodes/registration.hpp"
#include "nodes/tree_state.hpp"
#include "sensor_msgs/msg/battery_state.hpp"

namespace nav2_behavior_tree {
namespace {

using BT::ConditionNode;
using BT::InputPort;
using BT::NodeStatus;
using sensor_msgs::msg::BatteryState;

/// By the last message of the battery.
class BatteryCondition : public ConditionNode {
 public:
  using ConditionNode::ConditionNode;

  static BT::PortsList ports(BT::PortsList more) {
    more.insert(InputPort<std::string>("battery_topic", "/battery_status", "Topic of the battery"));
    return more;
  }

  NodeStatus tick() override {
    if (!topic_) subscribe();
    topic_->receive();
    return is_so_ ? NodeStatus::SUCCESS : NodeStatus::FAILURE;
  }

 protected:
  void subscribe() {
    std::string name = "/battery_status";
    getInput("battery_topic", name);
    topic_.emplace(ros_node_of(*this), name, rclcpp::SystemDefaultsQoS(),
                   [this](const BatteryState& state) { is_so_ = judge(state); });
  }

 private:
  virtual bool judge(const BatteryState& state) const = 0;

  bool is_so_ = false;
  std::optional<TreeTopic<BatteryState>> topic_;
};

class IsBatteryCharging : public BatteryCondition {
 public:
  IsBatteryCharging(const std::string& name, const BT::NodeConfiguration& conf)
      : BatteryCondition(name, conf) {
    subscribe();
  }
  static BT::PortsList providedPorts() { return ports({}); }

 private:
  bool judge(const BatteryState& state) const override {
    return state.power_supply_status == BatteryState::POWER_SUPPLY_STATUS_CHARGING;
  }
};

class IsBatteryLow : public BatteryCondition {
 public:
  using BatteryCondition::BatteryCondition;
  static BT::PortsList providedPorts() {
    return ports({InputPort<double>("min_battery", "Least share from 0 to 1, or voltage [V]"),
                  InputPort<bool>("is_voltage", false, "Whether it is a voltage")});
  }

 private:
  bool judge(const BatteryState& state) const override {
    double least = 0.0;
    bool is_voltage = false;
    getInput("min_battery", least);
    getInput("is_voltage", is_voltage);
    return (is_voltage ? state.voltage : state.percentage) <= least;
  }
};

/// Whether the robot was braked harder than it brakes itself.
class IsStuck : public ConditionNode {
 public:
  IsStuck(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf),
        topic_(ros_node_of(*this), "odom", rclcpp::SystemDefaultsQoS(),
               [this](const nav_msgs::msg::Odometry& message) { take(message); }) {
    RCLCPP_INFO_ONCE(ros_node_of(*this)->get_logger(), "Waiting on odometry");
  }

  static BT::PortsList providedPorts() { return {}; }

  NodeStatus tick() override {
    topic_.receive();
    if (said_ != is_stuck_) {
      RCLCPP_INFO(ros_node_of(*this)->get_logger(), "%s",
                  is_stuck_ ? "Robot got stuck!" : "Robot is free");
    }
    said_ = is_stuck_;
    return is_stuck_ ? NodeStatus::SUCCESS : NodeStatus::FAILURE;
  }

 private:
  struct Sample {
    double time;   ///< [s]
    double speed;  ///< [m/s]
  };

  void take(const nav_msgs::msg::Odometry& message) {
    constexpr double kHardest = -10.0;  // m/s^2
    const Sample now{rclcpp::Time(message.header.stamp).seconds(), message.twist.twist.linear.x};
    if (last_ && now.time > last_->time) {
      is_stuck_ = (now.speed - last_->speed) / (now.time - last_->time) < kHardest;
    }
    last_ = now;
  }

  std::optional<Sample> last_;
  std::optional<bool> said_;
  bool is_stuck_ = false;
  TreeTopic<nav_msgs::msg::Odometry> topic_;
};

/// Asks the planner's costmap. It waits for the answer within one tick.
class IsPathValid : public ConditionNode {
  using Service = nav2_msgs::srv::IsPathValid;

 public:
  IsPathValid(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf),
        node_(ros_node_of(*this)),
        group_(node_->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false)) {
    executor_.add_callback_group(group_, node_->get_node_base_interface());
    client_ = node_->create_client<Service>("is_path_valid", rclcpp::ServicesQoS(), group_);
  }

  static BT::PortsList providedPorts() {
    return {InputPort<nav_msgs::msg::Path>("path", "The path"),
            InputPort<std::chrono::milliseconds>("server_timeout")};
  }

  NodeStatus tick() override {
    auto request = std::make_shared<Service::Request>();
    getInput("path", request->path);
    auto answer = client_->async_send_request(request);
    const bool came =
        executor_.spin_until_future_complete(answer, detail::timeout_of(*this, "server_timeout")) ==
        rclcpp::FutureReturnCode::SUCCESS;
    if (!came) client_->remove_pending_request(answer);
    return came && answer.get()->is_valid ? NodeStatus::SUCCESS : NodeStatus::FAILURE;
  }

 private:
  rclcpp::Node::SharedPtr node_;
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::executors::SingleThreadedExecutor executor_;
  rclcpp::Client<Service>::SharedPtr client_;
};

const NodeLibrary charging("libnav2_is_battery_charging_condition_bt_node.so",
                           [](Factory& factory) {
                             factory.registerNodeType<IsBatteryCharging>("IsBatteryCharging");
                           });
const NodeLibrary low("libnav2_is_battery_low_condition_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<IsBatteryLow>("IsBatteryLow");
});
const NodeLibrary stuck("libnav2_is_stuck_condition_bt_node.so",
                        [](Factory& factory) { factory.registerNodeType<IsStuck>("IsStuck"); });
const NodeLibrary valid("libnav2_is_path_valid_condition_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<IsPathValid>("IsPathValid");
});

}  // namespace
}  // namespace nav2_behavior_tree
