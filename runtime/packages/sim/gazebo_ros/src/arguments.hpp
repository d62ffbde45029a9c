// The command line of spawn_entity.py, as Python's argparse reads it. Pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gazebo_ros {

struct Arguments {
  std::string file, topic, database;  ///< one of the sources, or from_stdin
  bool from_stdin = false;
  std::string entity;
  std::string reference_frame, gazebo_namespace, robot_namespace;
  double timeout_s = 30;
  std::optional<double> old_timeout_s;  ///< of the deprecated option
  bool pauses = false, unpauses = false;
  std::string wait_for;  ///< an entity; empty: none
  double x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0;
  bool package_to_model = false;
  bool is_bound = false;  ///< delete the entity at the end
};

/// Either arguments, or a text for the console and an exit code.
struct ReadArguments {
  std::optional<Arguments> arguments;
  std::string text;
  int exit_code = 0;  ///< 0: the text is help, for standard output
};

/// `words`: without the program's name and without what is for ROS.
ReadArguments read_arguments(const std::vector<std::string>& words);

}  // namespace gazebo_ros
