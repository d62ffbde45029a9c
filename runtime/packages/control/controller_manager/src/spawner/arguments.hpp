// The command lines of the spawners. Texts in, options out: this file needs no ROS.
#pragma once

#include <string>
#include <vector>

namespace controller_manager {

/// A command line that cannot be read; `text` is for standard error, and the exit code is 2. With
/// exit code 0 the text is the help that was asked for.
struct UsageError {
  std::string text;
  int exit_code = 2;
};

struct ControllerOptions {
  std::string name;
  std::vector<std::string> param_files;
  std::vector<std::string> ros_args;  ///< split at spaces
  bool load_only = false;
  bool inactive = false;
};

struct SpawnerOptions {
  std::vector<ControllerOptions> controllers;
  std::string controller_manager = "controller_manager";
  std::string name_space;
  double controller_manager_timeout = 0.0;  ///< seconds; 0: for ever
  double switch_timeout = 5.0;              ///< seconds
  double service_call_timeout = 10.0;       ///< seconds
  bool unload_on_kill = false;
  bool activate_as_group = false;
  bool switch_asap = true;
};

struct UnspawnerOptions {
  std::vector<std::string> controllers;
  std::string controller_manager = "/controller_manager";
  double switch_timeout = 5.0;
};

struct HardwareSpawnerOptions {
  std::vector<std::string> components;
  std::string controller_manager = "controller_manager";
  double controller_manager_timeout = 0.0;
  bool activate = false;  ///< else configure
};

/// `arguments` without the program's name and without ROS arguments. Throw UsageError.
SpawnerOptions read_spawner_arguments(const std::vector<std::string>& arguments);
UnspawnerOptions read_unspawner_arguments(const std::vector<std::string>& arguments);
HardwareSpawnerOptions read_hardware_spawner_arguments(const std::vector<std::string>& arguments);

}  // namespace controller_manager
