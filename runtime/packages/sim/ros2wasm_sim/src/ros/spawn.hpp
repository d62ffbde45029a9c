// Adds a model to the world that runs, as the services of Gazebo Sim and of simulators of any make
// ask for it.
#pragma once

#include <string>

#include "core/simulation.hpp"
#include "ros/host.hpp"

namespace ros2wasm_sim {

struct SpawnOrder {
  std::string name;  ///< empty: the model's own
  bool allow_renaming = false;
  std::string text;        ///< SDF or URDF
  std::string uri;         ///< names a file; used when `text` is empty
  std::string name_space;  ///< of the topics of its plugins
  Pose pose;               ///< in the world, in place of the model's own
};

enum class SpawnProblem { kNone, kNotFound, kUnreadable, kNameTaken, kNotSimulated };

struct Spawned {
  SpawnProblem problem = SpawnProblem::kNone;
  std::string error;  ///< for people; it has not been logged
  std::string name;   ///< that the model has got
};

/// Puts the topics of all plugins of the model below a namespace.
void set_namespace(Model& model, const std::string& name_space);

[[nodiscard]] Spawned spawn(Host& host, Simulation& simulation, const SpawnOrder& order);

}  // namespace ros2wasm_sim
