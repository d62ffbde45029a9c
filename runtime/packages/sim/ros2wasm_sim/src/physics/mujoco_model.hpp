// Models of MuJoCo: their texts compiled, and who owns them.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

namespace ros2wasm_sim {

struct FreeModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct FreeData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, FreeModel>;
using DataPointer = std::unique_ptr<mjData, FreeData>;

/// Throws PhysicsError with the engine's message.
ModelPointer compile_model(const std::string& xml);

}  // namespace ros2wasm_sim
