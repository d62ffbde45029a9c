// Models of SDF: their links, joints, frames and the models in them.
#pragma once

#include <memory>

#include "sdf/sdf_frames.hpp"
#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// Values of an <include> that take the place of the model's own.
struct ModelChanges {
  std::string name;
  std::optional<RawPose> pose;
  std::optional<bool> is_static;
  std::string placement_frame;
  std::vector<Plugin> plugins;
};

/// A model whose place is not known yet.
struct ScopedModel {
  Model model;  ///< without its pose
  std::shared_ptr<Scope> scope;
  RawPose pose;
  Pose placement;  ///< of the model's root in what `pose` puts in its place
  Node where;
};

/// `depth` counts the models and includes that this one is in.
std::optional<ScopedModel> read_model_element(Context& context, const Node& node,
                                              const ModelChanges& changes, int depth);

}  // namespace ros2wasm_sim
