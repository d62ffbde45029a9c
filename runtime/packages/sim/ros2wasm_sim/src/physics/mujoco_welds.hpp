// Links that are attached to each other while the world runs.
#pragma once

#include <mujoco/mujoco.h>

#include "physics/physics.hpp"

namespace ros2wasm_sim {

struct Weld {
  LinkHandle parent, child;
  Pose offset;  ///< of the child, in the parent
};

/// Lets one of the model's welds hold `child` in `parent`; both are bodies of MuJoCo.
inline void hold(mjModel& model, int weld, int parent, int child, const Pose& offset) {
  const Quaternion& q = offset.orientation;
  const Vector3& p = offset.position;
  // A point of the child, the same point in the parent, the child's rotation, and the weight of
  // turning against shifting.
  const mjtNum values[mjNEQDATA] = {0, 0, 0, p.x, p.y, p.z, q.w, q.x, q.y, q.z, 1};
  mju_copy(model.eq_data + mjNEQDATA * weld, values, mjNEQDATA);
  model.eq_obj1id[weld] = parent;
  model.eq_obj2id[weld] = child;
  model.eq_active[weld] = 1;
}

}  // namespace ros2wasm_sim
