// Gazebo Sim has a bus of its own. Here its topics and services are hidden topics and services of
// ROS below /_gz, with the ROS type that belongs to the Gazebo type, so that a bridge carries them
// and `ros2 topic list` does not show them.
#pragma once

#include <cctype>
#include <string>

namespace ros2wasm_sim {

/// The hidden ROS name of a topic or service of Gazebo. Signs that ROS names cannot have become
/// `_`.
inline std::string hidden_name(const std::string& gz_name) {
  std::string name = "/_gz";
  if (gz_name.empty() || gz_name.front() != '/') name += '/';
  for (const char sign : gz_name)
    name +=
        std::isalnum(static_cast<unsigned char>(sign)) || sign == '/' || sign == '_' ? sign : '_';
  return name;
}

/// Latched (transient local, depth 1, std_msgs/msg/String): the name of the world, as soon as it is
/// loaded.
inline const char* const kWorldName = "/_gz/gazebo/worlds";

/// Hidden topics that the page's view of the world has, and Gazebo does not.
inline bool is_of_view(const std::string& hidden) {
  for (const char* name :
       {"collisions", "contacts", "hand", "paused", "poses", "scene", "state_hash", "stats"})
    if (hidden == hidden_name(name)) return true;
  return false;
}

/// The node of the server, which has all of Gazebo's ends of topics.
inline const char* const kServerNode = "_gz_sim";

}  // namespace ros2wasm_sim
