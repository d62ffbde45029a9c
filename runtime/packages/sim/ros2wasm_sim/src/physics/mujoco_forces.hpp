// Contact forces and joint wrenches of a step of MuJoCo, and which shapes are near a point. It
// reads the state of the engine and never changes it.
#pragma once

#include <mujoco/mujoco.h>

#include <string>
#include <vector>

#include "physics/physics.hpp"

namespace ros2wasm_sim {

/// A contact of the engine, by the numbers of its collisions in MjcfNames.
struct Touch {
  int first = -1, second = -1;
  ContactPoint point;
};

/// Geom to collision; -1 for shapes that do not collide.
std::vector<int> collisions_of_geoms(const mjModel& model);

/// The contacts whose forces the engine has just computed.
void read_touches(const mjModel& model, const mjData& data, const std::vector<int>& collisions,
                  std::vector<Touch>& touches);

/// Grouped by pair. The names are views into `names`.
std::vector<Contact> contacts_between(const std::vector<Touch>& touches,
                                      const std::vector<std::string>& names);

/// How a body's parent acts on it, in the body's axes about its origin; mj_rnePostConstraint() was
/// called before.
Wrench wrench_of_parent(const mjModel& model, const mjData& data, int body);

/// See Physics::is_near().
bool is_geom_near(const mjModel& model, const mjData& data, const Vector3& point, double distance,
                  int group, int without_body);

}  // namespace ros2wasm_sim
