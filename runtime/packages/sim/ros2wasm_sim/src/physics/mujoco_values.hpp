// Our vectors and rotations as arrays of MuJoCo, and facts about the state that it holds.
#pragma once

#include <mujoco/mujoco.h>

#include <cstdint>
#include <cstring>

#include "world/geometry.hpp"

namespace ros2wasm_sim {

inline Vector3 vector(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}
inline Quaternion quaternion(const mjtNum* q) {
  return {q[0], q[1], q[2], q[3]};
}
inline void put(const Vector3& v, mjtNum* out) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}
inline void put(const Quaternion& q, mjtNum* out) {
  out[0] = q.w;
  out[1] = q.x;
  out[2] = q.y;
  out[3] = q.z;
}

/// FNV-1a over the bits of positions and velocities.
inline std::uint64_t hash_of_state(const mjModel& model, const mjData& data) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](const mjtNum* values, int count) {
    for (int i = 0; i < count; ++i) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, values + i, sizeof bits);
      for (int byte = 0; byte < 8; ++byte)
        hash = (hash ^ (bits >> (8 * byte) & 0xff)) * 1099511628211ULL;
    }
  };
  add(data.qpos, model.nq);
  add(data.qvel, model.nv);
  return hash;
}

/// The degree of freedom that the engine's last warning about the state is about, or -1.
inline int dof_of_warning(const mjModel& model, const mjData& data) {
  int dof = -1;
  if (data.warning[mjWARN_BADQPOS].number > 0)
    for (int joint = 0; joint < model.njnt; ++joint)
      if (model.jnt_qposadr[joint] <= data.warning[mjWARN_BADQPOS].lastinfo)
        dof = model.jnt_dofadr[joint];
  for (const int kind : {mjWARN_BADQVEL, mjWARN_BADQACC})
    if (data.warning[kind].number > 0) dof = data.warning[kind].lastinfo;
  return dof;
}

}  // namespace ros2wasm_sim
