// Nodes that move the robot by a behaviour, and that cancel one.
#include "nav2_behavior_tree/bt_cancel_action_node.hpp"
#include "nav2_msgs/action/assisted_teleop.hpp"
#include "nav2_msgs/action/back_up.hpp"
#include "nav2_msgs/action/drive_on_heading.hpp"
#include "nav2_msgs/action/follow_path.hpp"
#include "nav2_msgs/action/spin.hpp"
#include "nav2_msgs/action/wait.hpp"
#include "nodes/error_code_action.hpp"
#include "nodes/registration.hpp"

namespace nav2_behavior_tree {
namespace {

using BT::InputPort;
namespace action = nav2_msgs::action;

/// Reads ports, and counts as a recovery when it is one.
template <typename ActionT>
class MotionAction : public ErrorCodeAction<ActionT> {
 public:
  using ErrorCodeAction<ActionT>::ErrorCodeAction;

 protected:
  double number(const char* port) const {
    double value = 0.0;
    this->getInput(port, value);
    return value;
  }
  bool flag(const char* port) const {
    bool value = false;
    this->getInput(port, value);
    return value;
  }
  void take_allowance() {
    this->goal_.time_allowance = rclcpp::Duration::from_seconds(number("time_allowance"));
  }
  /// `distance` in m, along x.
  void take_way(const char* distance, const char* speed) {
    this->goal_.target.x = number(distance);
    this->goal_.speed = static_cast<float>(number(speed));
    take_allowance();
  }
};

class Spin : public MotionAction<action::Spin> {
 public:
  using MotionAction::MotionAction;

  static BT::PortsList providedPorts() {
    return ports_and_code({InputPort<double>("spin_dist", 1.57, "Angle [rad]"),
                           InputPort<double>("time_allowance", 10.0, "Seconds it may take"),
                           InputPort<bool>("is_recovery", true, "Whether it is counted as one")});
  }
  void on_tick() override {
    goal_.target_yaw = static_cast<float>(number("spin_dist"));
    take_allowance();
    if (flag("is_recovery")) increment_recovery_count();
  }
};

class BackUp : public MotionAction<action::BackUp> {
 public:
  using MotionAction::MotionAction;

  static BT::PortsList providedPorts() {
    return ports_and_code({InputPort<double>("backup_dist", 0.15, "Distance [m]"),
                           InputPort<double>("backup_speed", 0.025, "Speed [m/s]"),
                           InputPort<double>("time_allowance", 10.0, "Seconds it may take")});
  }
  void on_tick() override {
    take_way("backup_dist", "backup_speed");
    increment_recovery_count();
  }
};

class DriveOnHeading : public MotionAction<action::DriveOnHeading> {
 public:
  using MotionAction::MotionAction;

  static BT::PortsList providedPorts() {
    return ports_and_code({InputPort<double>("dist_to_travel", 0.15, "Distance [m]"),
                           InputPort<double>("speed", 0.025, "Speed [m/s]"),
                           InputPort<double>("time_allowance", 10.0, "Seconds it may take")});
  }
  void on_tick() override { take_way("dist_to_travel", "speed"); }
};

class AssistedTeleop : public MotionAction<action::AssistedTeleop> {
 public:
  using MotionAction::MotionAction;

  static BT::PortsList providedPorts() {
    return ports_and_code({InputPort<double>("time_allowance", 10.0, "Seconds it may take"),
                           InputPort<bool>("is_recovery", false, "Whether it is counted as one")});
  }
  void on_tick() override {
    take_allowance();
    if (flag("is_recovery")) increment_recovery_count();
  }
  /// A person stopped it: a success, unless the robot was to be recovered.
  BT::NodeStatus on_aborted() override {
    const BT::NodeStatus failure = MotionAction::on_aborted();
    return flag("is_recovery") ? failure : BT::NodeStatus::SUCCESS;
  }
};

class Wait : public BtActionNode<action::Wait> {
 public:
  using BtActionNode::BtActionNode;

  static BT::PortsList providedPorts() {
    return providedBasicPorts({InputPort<double>("wait_duration", 1.0, "Seconds")});
  }
  void on_tick() override {
    double seconds = 0.0;
    getInput("wait_duration", seconds);
    if (seconds <= 0) {
      RCLCPP_WARN(node_->get_logger(),
                  "Wait duration is negative or zero (%f). Setting to positive.", seconds);
    }
    goal_.time = rclcpp::Duration::from_seconds(std::abs(seconds));
    increment_recovery_count();
  }
};

template <typename ActionT>
void register_cancel(Factory& factory, const char* id, const char* server) {
  register_client<BtCancelActionNode<ActionT>>(factory, id, server);
}

const NodeLibrary spin("libnav2_spin_action_bt_node.so",
                       [](Factory& factory) { register_client<Spin>(factory, "Spin", "spin"); });
const NodeLibrary back_up("libnav2_back_up_action_bt_node.so", [](Factory& factory) {
  register_client<BackUp>(factory, "BackUp", "backup");
});
const NodeLibrary drive("libnav2_drive_on_heading_bt_node.so", [](Factory& factory) {
  register_client<DriveOnHeading>(factory, "DriveOnHeading", "drive_on_heading");
});
const NodeLibrary teleop("libnav2_assisted_teleop_action_bt_node.so", [](Factory& factory) {
  register_client<AssistedTeleop>(factory, "AssistedTeleop", "assisted_teleop");
});
const NodeLibrary wait("libnav2_wait_action_bt_node.so",
                       [](Factory& factory) { register_client<Wait>(factory, "Wait", "wait"); });

const NodeLibrary cancel_control("libnav2_controller_cancel_bt_node.so", [](Factory& factory) {
  register_cancel<action::FollowPath>(factory, "CancelControl", "follow_path");
});
const NodeLibrary cancel_spin("libnav2_spin_cancel_bt_node.so", [](Factory& factory) {
  register_cancel<action::Spin>(factory, "CancelSpin", "spin");
});
const NodeLibrary cancel_back_up("libnav2_back_up_cancel_bt_node.so", [](Factory& factory) {
  register_cancel<action::BackUp>(factory, "CancelBackUp", "backup");
});
const NodeLibrary cancel_drive("libnav2_drive_on_heading_cancel_bt_node.so", [](Factory& factory) {
  register_cancel<action::DriveOnHeading>(factory, "CancelDriveOnHeading", "drive_on_heading");
});
const NodeLibrary cancel_teleop("libnav2_assisted_teleop_cancel_bt_node.so", [](Factory& factory) {
  register_cancel<action::AssistedTeleop>(factory, "CancelAssistedTeleop", "assisted_teleop");
});
const NodeLibrary cancel_wait("libnav2_wait_cancel_bt_node.so", [](Factory& factory) {
  register_cancel<action::Wait>(factory, "CancelWait", "wait");
});

}  // namespace
}  // namespace nav2_behavior_tree
