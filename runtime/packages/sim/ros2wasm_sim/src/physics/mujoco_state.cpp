// See mujoco_state.hpp.
#include "physics/mujoco_state.hpp"

#include <algorithm>

#include "physics/mujoco_values.hpp"

namespace ros2wasm_sim {

int free_joint_of(const mjModel& model, int number) {
  return mj_name2id(&model, mjOBJ_JOINT, ("f" + std::to_string(number)).c_str());
}

WorldState state_of(const mjModel& model, const mjData& data, const MjcfNames& names,
                    const std::vector<int>& bodies, const std::vector<JointRow>& joints) {
  WorldState state;
  for (const JointRow& row : joints)
    if (row.dof >= 0)
      state.joints[{row.model, row.name}] = {data.qpos[row.position], data.qvel[row.dof]};
  for (const auto& [owner, roots] : names.roots)
    for (const int number : roots) {
      const int joint = free_joint_of(model, number);
      const WorldState::Name key{owner, names.link_names[number].second};
      if (joint < 0) {
        const int body = bodies[number];
        state.fixed[key] = {vector(model.body_pos + 3 * body),
                            quaternion(model.body_quat + 4 * body)};
        continue;
      }
      std::array<double, 13>& values = state.roots[key];
      std::copy_n(data.qpos + model.jnt_qposadr[joint], 7, values.begin());
      std::copy_n(data.qvel + model.jnt_dofadr[joint], 6, values.begin() + 7);
    }
  return state;
}

void restore(const WorldState& state, mjModel& model, mjData& data, const MjcfNames& names,
             const std::vector<int>& bodies, const std::vector<JointRow>& joints) {
  for (const JointRow& row : joints) {
    const auto old = state.joints.find({row.model, row.name});
    if (row.dof < 0 || old == state.joints.end()) continue;
    data.qpos[row.position] = old->second.first;
    data.qvel[row.dof] = old->second.second;
  }
  for (const auto& [owner, roots] : names.roots)
    for (const int number : roots) {
      const WorldState::Name key{owner, names.link_names[number].second};
      const int joint = free_joint_of(model, number);
      if (joint < 0) {
        if (const auto old = state.fixed.find(key); old != state.fixed.end()) {
          put(old->second.position, model.body_pos + 3 * bodies[number]);
          put(old->second.orientation, model.body_quat + 4 * bodies[number]);
        }
        continue;
      }
      const auto old = state.roots.find(key);
      if (old == state.roots.end()) continue;
      std::copy_n(old->second.begin(), 7, data.qpos + model.jnt_qposadr[joint]);
      std::copy_n(old->second.begin() + 7, 6, data.qvel + model.jnt_dofadr[joint]);
    }
}

}  // namespace ros2wasm_sim
