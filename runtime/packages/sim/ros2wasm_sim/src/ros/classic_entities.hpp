// Models, links and lights by the names that services of Gazebo Classic take.
#pragma once

#include <string>

#include "core/simulation.hpp"

namespace ros2wasm_sim {

/// The names of the world itself.
inline bool is_world(const std::string& frame) {
  return frame.empty() || frame == "world" || frame == "map" || frame == "/map";
}

/// `model::link`. Not valid when there is none.
inline LinkHandle scoped_link(Simulation& simulation, const std::string& name) {
  const std::size_t colons = name.find("::");
  if (colons == std::string::npos) return {};
  return simulation.physics().link(name.substr(0, colons), name.substr(colons + 2));
}

/// The link that a model's pose follows.
inline std::string canonical_link(const Model& model) {
  return model.canonical_link.empty() ? model.links.front().name : model.canonical_link;
}

/// Where the world, a model, a link or a light is, and how it moves. False when there is none.
inline bool find_entity(Simulation& simulation, const std::string& name, Pose& pose,
                        Motion& motion) {
  if (is_world(name)) return true;
  Physics& physics = simulation.physics();
  if (const Model* model = simulation.model(name)) {
    pose = simulation.model_pose(*model);
    motion = physics.velocity(physics.link(name, canonical_link(*model)));
    return true;
  }
  for (const Light& light : simulation.world().lights)
    if (light.name == name) {
      pose = light.pose;
      return true;
    }
  const LinkHandle link = scoped_link(simulation, name);
  pose = physics.pose(link);
  motion = physics.velocity(link);
  return link.valid();
}

}  // namespace ros2wasm_sim
