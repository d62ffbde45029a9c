// The elements that controllers of joints in Gazebo Sim share.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "checks/model_checks.hpp"
#include "plugins/gz_topics.hpp"
#include "plugins/pid.hpp"

namespace ros2wasm_sim {

/// A joint of the plugin's model. Throws PluginError when there is none.
inline JointHandle gz_joint(const PluginContext& context, const std::string& name) {
  const JointHandle joint =
      context.physics().joint(context.model->name, context.plugin.model_scope + name);
  if (!joint.valid())
    throw PluginError("Failed to find joint [" + name + "] for model [" + context.model->name +
                      "]" + nearest_joint(*context.model, context.plugin.model_scope + name));
  return joint;
}

/// All joints that the plugin names; at least one.
inline std::vector<JointHandle> gz_joints(const PluginContext& context, const Parameters& given) {
  std::vector<JointHandle> joints;
  for (const std::string& name : given.all("joint_name")) joints.push_back(gz_joint(context, name));
  if (joints.empty())
    throw PluginError("the plugin [" + context.plugin.name + "] of model [" + context.model->name +
                      "] needs a <joint_name>");
  return joints;
}

/// `<topic>`, or `/model/M/` and `<sub_topic>`, or the default.
inline std::string command_topic(const PluginContext& context, const Parameters& given,
                                 const std::string& otherwise) {
  const std::string below = given.text("sub_topic", "");
  return topic_of(given, "topic",
                  below.empty() ? otherwise : "/model/" + context.model->name + "/" + below);
}

/// The elements `p_gain`, `i_max`, `cmd_offset` and so on; what is missing is as in `otherwise`.
inline PidSettings read_pid(const Parameters& given, const PidSettings& otherwise) {
  PidSettings settings;
  settings.p = given.number("p_gain", otherwise.p);
  settings.i = given.number("i_gain", otherwise.i);
  settings.d = given.number("d_gain", otherwise.d);
  settings.i_max = given.number("i_max", otherwise.i_max);
  settings.i_min = given.number("i_min", otherwise.i_min);
  settings.command_max = given.number("cmd_max", otherwise.command_max);
  settings.command_min = given.number("cmd_min", otherwise.command_min);
  settings.offset = given.number("cmd_offset", otherwise.offset);
  return settings;
}

/// The strongest motor that the engine takes, for joints without a limit of their own.
inline double motor_effort(const Physics& physics, JointHandle joint) {
  constexpr double kStrongest = 1e6;
  return std::min(physics.effort_limit(joint), kStrongest);
}

/// Commands of type actuator_msgs/Actuators are not in the embedded channel.
inline void refuse_actuators(const PluginContext& context, const Parameters& given) {
  if (given.flag("use_actuator_msg", false))
    throw PluginError("the plugin [" + context.plugin.name + "] of model [" + context.model->name +
                      "] is skipped: <use_actuator_msg> is not supported; without it the plugin "
                      "takes std_msgs/msg/Float64");
}

}  // namespace ros2wasm_sim
