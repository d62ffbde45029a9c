// Topics, frames and rates that sensors of Gazebo Sim have when their element does not say.
#pragma once

#include <cmath>
#include <string>

#include "plugins/plugin.hpp"

namespace ros2wasm_sim {

/// `L` as `/link/L`; one of a nested model, `inner::L`, as `/model/inner/link/L`.
inline std::string path_of(std::string name, const std::string& kind) {
  std::string path;
  for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::")) {
    path += "/model/" + name.substr(0, at);
    name.erase(0, at + 2);
  }
  return path + "/" + kind + "/" + name;
}

/// `<topic>`, or `/world/W/model/M/link/L/sensor/S` and `what`, such as `/scan`. A sensor of a
/// joint has `joint/J` in place of `link/L`.
inline std::string sensor_topic(const PluginContext& context, const std::string& what) {
  const std::string& topic = context.sensor->topic;
  if (!topic.empty()) return topic;
  const std::string carrier = context.joint != nullptr ? path_of(context.joint->name, "joint")
                                                       : path_of(context.link->name, "link");
  return "/world/" + context.simulation.world().name + "/model/" + context.model->name + carrier +
         "/sensor/" + context.sensor->name + what;
}

/// `<gz_frame_id>`, or `M/L/S`, or `M/J/S`. Names of nested models are part of it: `M/inner/L/S`.
inline std::string sensor_frame(const PluginContext& context) {
  if (!context.sensor->frame_id.empty()) return context.sensor->frame_id;
  std::string carrier = context.joint != nullptr ? context.joint->name : context.link->name;
  for (std::size_t at = carrier.find("::"); at != std::string::npos; at = carrier.find("::"))
    carrier.replace(at, 2, "/");
  return context.model->name + "/" + carrier + "/" + context.sensor->name;
}

/// Gazebo Sim cuts a period to whole milliseconds: 30 Hz are 30.3.
inline double whole_milliseconds(double hz) {
  if (hz <= 0) return 0;
  const double period_ms = std::floor(1000 / hz);
  return period_ms < 1 ? 0 : 1000 / period_ms;
}

}  // namespace ros2wasm_sim
