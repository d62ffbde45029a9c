// Friction that differs by direction, such as that of mecanum wheels (SDF: fdir1, mu and mu2).
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "physics/mjcf.hpp"

namespace ros2wasm_sim {

struct FrictionDirection {
  int geom = -1;
  int frame = -1;  ///< the body whose axes `direction` has
  double mu = 1;   ///< along `direction`
  double mu2 = 1;
  Vector3 direction;
};

std::vector<FrictionDirection> friction_directions(const mjModel& model, const MjcfNames& names);

/// The first half of MuJoCo's step: all that follows from positions and velocities. The engine
/// takes two frictions of a contact from pairs of shapes only, which have no direction of their
/// own; here they are set between the search for contacts and the constraints that follow from
/// them.
void begin_step(const mjModel* model, mjData* data,
                const std::vector<FrictionDirection>& directions);

}  // namespace ros2wasm_sim
