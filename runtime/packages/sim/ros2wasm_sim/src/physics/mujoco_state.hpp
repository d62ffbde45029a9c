// Joints and links as the physics keeps them, and the state of a world that goes on in another
// model.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "physics/mjcf.hpp"

namespace ros2wasm_sim {

struct Motor {
  bool on = false;
  double velocity = 0;
  double max_effort = 0;
};

struct JointRow {
  std::string model = {}, name = {};
  int id = -1;   ///< of MuJoCo
  int dof = -1;  ///< -1 for joints that have no single axis
  int position = -1;
  Motor motor = {};
  double base_friction = 0;  ///< that the world gives
  double effort = 0;         ///< of the last step
  double effort_limit = kInfinity;
};

struct LinkRow {
  std::string model = {}, name = {};
  int body = -1;
  bool is_watched = false;
  Wrench wrench = {};  ///< of the last step, when it is watched
};

/// Where the parts of a world are, by model and name.
struct WorldState {
  using Name = std::pair<std::string, std::string>;
  std::map<Name, std::pair<double, double>> joints;  ///< position and velocity
  std::map<Name, std::array<double, 13>> roots;      ///< pose and velocity of free links
  std::map<Name, Pose> fixed;
};

/// The free joint of a root link, or -1.
int free_joint_of(const mjModel& model, int number);

WorldState state_of(const mjModel& model, const mjData& data, const MjcfNames& names,
                    const std::vector<int>& bodies, const std::vector<JointRow>& joints);
/// Parts that the state does not have stay where they are.
void restore(const WorldState& state, mjModel& model, mjData& data, const MjcfNames& names,
             const std::vector<int>& bodies, const std::vector<JointRow>& joints);

}  // namespace ros2wasm_sim
