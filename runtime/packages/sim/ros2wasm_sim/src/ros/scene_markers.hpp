// The shapes of a world as markers for a viewer.
#pragma once

#include <visualization_msgs/msg/marker_array.hpp>

#include <vector>

#include "physics/physics.hpp"

namespace ros2wasm_sim {

enum class SceneShapes { kVisuals, kCollisions };

struct SceneMarkers {
  /// Begins with DELETEALL.
  visualization_msgs::msg::MarkerArray message;
  std::size_t skipped = 0;  ///< shapes that did not fit into a message of bounded size
};

/// `meshes` is asked for parts of files only.
SceneMarkers scene_markers(const World& world, SceneShapes shapes, const MeshReader& meshes);

/// Points where collisions touch, and the forces there as lines, in `world`.
visualization_msgs::msg::MarkerArray contact_markers(const std::vector<Contact>& contacts);

}  // namespace ros2wasm_sim
