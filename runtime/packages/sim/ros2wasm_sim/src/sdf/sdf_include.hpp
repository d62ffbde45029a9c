// Other files in a world or model, by their URIs.
#pragma once

#include "sdf/sdf_model.hpp"

namespace ros2wasm_sim {

/// A model, or a light, or neither when it was not found; a note then says so.
struct Included {
  std::optional<ScopedModel> model;
  std::optional<Light> light;
  RawPose light_pose;
};

Included read_include(Context& context, const Node& node, int depth);

/// The text of a model that needs no file (`sun`, `ground_plane`), or null.
const char* built_in_model(const std::string& uri);

}  // namespace ros2wasm_sim
