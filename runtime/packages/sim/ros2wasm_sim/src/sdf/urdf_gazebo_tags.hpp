// The <gazebo> elements of a URDF: of links and joints, before fixed joints are lumped, and of the
// model, afterwards.
#pragma once

#include "sdf/urdf_robot.hpp"

namespace ros2wasm_sim {

/// Changes the links and joints that are named by `reference`. Unknown names are warnings.
void apply_references(Context& context, const Node& robot, UrdfRobot& value);

/// Changes the model by the elements without `reference`. `scope` has its links and frames.
void apply_model_tags(Context& context, const Node& robot, const Scope& scope, Model& model);

}  // namespace ros2wasm_sim
