// A world as MuJoCo's own model language has it. It is pure: no engine is needed to write one.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "physics/physics.hpp"
#include "world/world.hpp"

namespace ros2wasm_sim {

/// A shape whose friction is not the same in all directions.
struct DirectedShape {
  std::string geom;
  int body = 0;   ///< our number
  double mu = 1;  ///< along `direction`
  double mu2 = 1;
  Vector3 direction;  ///< of length 1, in the link `frame` of the same model
  std::string frame;
};

/// A name of a world, and the number that its parts have in the model: body `b7`, joint `j3`.
struct MjcfNames {
  std::map<std::pair<std::string, std::string>, int> links;   ///< (model, link)
  std::map<std::pair<std::string, std::string>, int> joints;  ///< (model, joint)
  /// Model to its root links. Those of a model that moves have a free joint `f7` of the body's
  /// number.
  std::map<std::string, std::vector<int>> roots;
  std::vector<std::pair<std::string, std::string>> link_names;  ///< of the bodies, by number
  std::vector<int> weightless;                ///< bodies that gravity does not pull
  std::map<std::string, std::string> meshes;  ///< name in the model to path
  /// The heightmaps `heights0`, `heights1`, ...: their heights are set when the model is there.
  std::vector<std::shared_ptr<const TriangleMesh>> heights;
  std::vector<DirectedShape> directed;
  /// `model::link::collision` of the geoms `c0`, `c1`, ... A wheel's tread, `c2t`, is part of `c2`.
  std::vector<std::string> collisions;
};

struct Mjcf {
  std::string xml;
  MjcfNames names;
  std::vector<std::string> warnings;
};

/// Groups of shapes: those that collide and that a lidar of type `ray` meets, those that only
/// collide, and those that are seen.
constexpr int kCollisionGroup = 0;
constexpr int kContactOnlyGroup = 1;
constexpr int kVisualGroup = 2;

/// Welds that hold nothing until links are attached to each other.
constexpr int kSpareWelds = 8;

/// The sizes of the engine's work memory.
struct MjcfLimits {
  int contacts = 200;
  int stack = 2'000'000;  ///< in numbers of 8 bytes
};

/// Throws PhysicsError for a world that would take minutes or all memory.
void check_size(const World& world);

Mjcf write_mjcf(const World& world, const MeshReader& meshes, const MjcfLimits& limits);

}  // namespace ros2wasm_sim
