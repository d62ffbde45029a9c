// Joints of SDF.
#pragma once

#include "sdf/sdf_frames.hpp"
#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// A joint whose place is known in `scope`; nothing, with an error or warning, when it is wrong.
std::optional<Joint> read_joint(Context& context, const Node& node, const Scope& scope);

/// Limits as they are meant: 1e16 and more is infinity, and so is an effort or velocity below zero.
/// Limits in the wrong order are swapped with a warning.
void tidy_limits(Context& context, const Node& where, const std::string& joint, JointAxis& axis);

/// Reports each of the <joint> elements that mimics a joint that is not one of `joints`, which are
/// all joints of the model.
void check_mimics(Context& context, const std::vector<Node>& nodes,
                  const std::vector<Joint>& joints);

}  // namespace ros2wasm_sim
