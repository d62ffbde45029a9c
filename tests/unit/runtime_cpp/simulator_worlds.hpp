// Worlds, models and runs that tests of the simulator share.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/simulation.hpp"

namespace ros2wasm_sim {

inline constexpr double kPi = 3.141592653589793;

class NoPlugins final : public SystemMaker {
 public:
  std::vector<std::unique_ptr<System>> systems_of(const Model&, Simulation&) override { return {}; }
  std::vector<std::unique_ptr<System>> systems_of(const World&, Simulation&) override { return {}; }
};

/// One link that collides, of 1 kg.
inline Model solid(const std::string& name, const Geometry& geometry, const Vector3& position) {
  Model model;
  model.name = name;
  model.pose.position = position;
  Link link;
  link.name = "link";
  link.inertial.ixx = link.inertial.iyy = link.inertial.izz = 0.01;
  Collision shape;
  shape.name = "shape";
  shape.geometry = geometry;
  link.collisions.push_back(shape);
  model.links.push_back(link);
  return model;
}

inline Model fixed(Model model) {
  model.is_static = true;
  return model;
}

inline Model ground() {
  return fixed(solid("ground", Plane{}, {}));
}

inline std::unique_ptr<Physics> physics_of(std::vector<Model> models,
                                           const Vector3& gravity = {0, 0, -9.8}) {
  World world;
  world.models = std::move(models);
  world.gravity = gravity;
  auto physics = make_physics({});
  physics->set_world(world);
  return physics;
}

inline void run(Physics& physics, int steps) {
  for (int i = 0; i < steps; ++i) physics.step();
}

}  // namespace ros2wasm_sim
