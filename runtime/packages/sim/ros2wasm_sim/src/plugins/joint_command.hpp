// A joint of Gazebo Sim that a topic gives one number to: a position or a velocity.
#pragma once

#include <std_msgs/msg/float64.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "plugins/gz_joints.hpp"

namespace ros2wasm_sim {

class JointCommand : public System {
 public:
  void on_reset() override {
    pid_.reset();
    target_ = initial_;
  }

 protected:
  struct Kind {
    const char* name;     ///< of the plugin
    const char* initial;  ///< the element with the target at the start
    const char* topic;    ///< the end of the topic's name, after that of the joint
    PidSettings pid;      ///< for elements that are missing
  };

  JointCommand(const PluginContext& context, const Kind& kind) : physics_(context.physics()) {
    const Parameters given(context.plugin.xml);
    refuse_actuators(context, given);
    joints_ = gz_joints(context, given);
    pid_ = Pid(read_pid(given, kind.pid));
    initial_ = target_ = given.number(kind.initial, 0);
    const std::string topic = command_topic(
        context, given,
        "/model/" + context.model->name + "/joint/" + given.text("joint_name", "") + kind.topic);
    // A number that is not finite is ignored: the last target holds.
    subscription_ = subscribe_gz<std_msgs::msg::Float64>(
        context.host, topic, [this](const std_msgs::msg::Float64& message) {
          if (std::isfinite(message.data)) target_ = message.data;
        });
    RCLCPP_INFO(context.host.node()->get_logger(), "[%s] subscribed to Double messages on [%s]",
                kind.name, topic.c_str());
  }

  JointHandle measured() const { return joints_.front(); }
  double target() const { return target_; }
  /// Gives all joints the force of the PID.
  void act_by_force(double error, double step) {
    const double force = pid_.update(error, step);
    for (const JointHandle joint : joints_) physics_.add_effort(joint, force);
  }
  void act_by_motor(double speed) {
    for (const JointHandle joint : joints_)
      physics_.set_motor(joint, speed, motor_effort(physics_, joint));
  }

  Physics& physics_;

 private:
  std::vector<JointHandle> joints_;  ///< the first is measured, all get the same command
  Pid pid_;
  double initial_ = 0, target_ = 0;  ///< rad or m, or rad/s or m/s
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr subscription_;
};

}  // namespace ros2wasm_sim
