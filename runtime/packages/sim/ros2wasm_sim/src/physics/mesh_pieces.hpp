// A mesh as convex pieces, for an engine that gives a mesh the contacts of its convex hull.
#pragma once

#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace ros2wasm_sim {

/// In the frame of the mesh and with its scale.
struct MeshPiece {
  std::vector<Vector3> points;  ///< the piece is their hull
  std::optional<Vector3> box;   ///< its sides, when it is a box: it stands at `pose` then
  Pose pose;
  /// Out of the surface that the piece is a slab below; zero when it is a whole convex part.
  Vector3 normal{0, 0, 0};
};

/// How far a slab reaches behind its surface (m).
constexpr double kSlabThickness = 0.02;
/// More are not made: each costs time in every step.
constexpr std::size_t kMostPieces = 2000;

/// Parts that do not touch are pieces of their own when they are convex. The faces of others become
/// slabs: one for each flat area that is convex, else one for each triangle. One piece without
/// points: the hull of the whole mesh is right as it is. Empty: there would be more than
/// kMostPieces.
std::vector<MeshPiece> mesh_pieces(const TriangleMesh& mesh, const Vector3& scale);

/// The same, or a flat mesh with a second side a little behind it: the engine refuses what has no
/// volume.
TriangleMesh with_thickness(const TriangleMesh& mesh, const Vector3& scale);

}  // namespace ros2wasm_sim
