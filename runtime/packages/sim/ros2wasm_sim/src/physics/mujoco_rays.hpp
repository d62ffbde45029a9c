// Rays of lidars against the shapes of MuJoCo.
#pragma once

#include <mujoco/mujoco.h>

#include "physics/physics.hpp"

namespace ros2wasm_sim {

/// The distance along a ray to the nearest shape of a group, or infinity. Shapes that are only seen
/// are not hit from inside: renderers do not draw the back of a face, so a lidar looks out of its
/// own housing. The model is the same after the call.
double distance_along(mjModel& model, const mjData& data, const Ray& ray, RaySees sees,
                      int without_body);

}  // namespace ros2wasm_sim
