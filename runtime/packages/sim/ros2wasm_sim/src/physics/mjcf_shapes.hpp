// Collisions and visuals as geoms of MuJoCo's model language.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "physics/mjcf.hpp"

namespace ros2wasm_sim {

std::string number(double value);
std::string text(const Vector3& v);
/// ` pos="..." quat="..."`.
std::string placed(const Pose& pose);

/// How a link is held.
struct Mount {
  const Joint* joint = nullptr;  ///< that it hangs on, or null
  bool moves = false;
  Pose pose;  ///< in the body above it, which is the world when it does not move
};

class ShapeWriter {
 public:
  ShapeWriter(const World& world, const MeshReader& meshes);

  std::string shapes_of(const Link& link, const Mount& mount, Mjcf& mjcf);
  bool collides(int body) const { return colliding_.count(body) != 0; }
  /// The meshes that were used.
  const std::string& assets() const { return assets_; }

 private:
  std::string collision(const Collision& shape, const Link& link, const Mount& mount, Mjcf& mjcf);
  std::string visual(const Visual& shape, Mjcf& mjcf);
  /// ` type="box" size="..." pos="..." quat="..."`, or nothing when the geometry cannot be had.
  std::string form(const Geometry& geometry, const Pose& pose, bool moves, const std::string& what,
                   Mjcf& mjcf);
  std::string mesh(const Mesh& mesh, const std::string& what, Mjcf& mjcf);
  /// The name of a heightmap's asset, or nothing when it cannot be read.
  std::string heights(const Mesh& map, const std::string& what, Mjcf& mjcf);
  /// A convex piece of a mesh.
  struct Piece {
    std::string asset;  ///< empty: it is a box
    Vector3 box;        ///< its sides
    Pose pose;          ///< in the frame of the mesh
    Vector3 normal;     ///< as MeshPiece has it
  };
  /// Pieces of a mesh that stands still; none: its hull is taken.
  const std::vector<Piece>& pieces_of(const Mesh& mesh, const std::string& what, Mjcf& mjcf);
  int priority(double mu) const;

  const MeshReader& meshes_;
  double step_;  ///< seconds
  std::map<double, int> priorities_;
  std::map<std::string, std::string> mesh_names_;     ///< by path, part and scale
  std::map<std::string, std::vector<Piece>> pieces_;  ///< by the same
  std::string assets_;
  int assets_written_ = 0;
  std::set<int> colliding_;
};

}  // namespace ros2wasm_sim
