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

/// The lights of a world and its links, at most 100. One is an ARROW along its direction: ns is
/// `point`, `directional` or `spot`, the colour has the intensity in it, scale is the range, the
/// outer and the inner angle, and the one point is how it fades (constant, linear, quadratic).
/// mesh_use_embedded_materials says that it casts shadows.
visualization_msgs::msg::MarkerArray light_markers(const World& world);

/// Points where collisions touch, and the forces there as lines, in `world`.
visualization_msgs::msg::MarkerArray contact_markers(const std::vector<Contact>& contacts);

}  // namespace ros2wasm_sim
