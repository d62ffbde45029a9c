// Meshes that stand still as what others touch, and things that are put into each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "physics/mesh_pieces.hpp"
#include "physics/physics.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

/// Appends a box with its faces outwards.
void add_box(TriangleMesh& mesh, const Vector3& low, const Vector3& high) {
  const int first = static_cast<int>(mesh.vertices.size() / 3);
  for (int i = 0; i < 8; ++i)
    for (const double value :
         {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z})
      mesh.vertices.push_back(static_cast<float>(value));
  for (const int corner : {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                           2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5})
    mesh.faces.push_back(first + corner);
}

/// Four walls in one piece around the origin: 4 m outside, 3.6 m inside, 1 m high, open above and
/// below.
TriangleMesh ring() {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0})
    for (const double half : {2.0, 1.8})
      for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
        for (const double value : {half * x, half * y, z})
          mesh.vertices.push_back(static_cast<float>(value));
  const auto side = [&](int a, int b, int c, int d) {
    for (const int corner : {a, b, c, a, c, d}) mesh.faces.push_back(corner);
  };
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    side(i, next, 8 + next, 8 + i);            // outside
    side(4 + next, 4 + i, 12 + i, 12 + next);  // inside
    side(8 + i, 8 + next, 12 + next, 12 + i);  // top
    side(next, i, 4 + i, 4 + next);            // bottom
  }
  return mesh;
}

TriangleMesh square(double half) {
  const auto h = static_cast<float>(half);
  return {{-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0}, {0, 1, 2, 0, 2, 3}};
}

Geometry mesh_at(const std::string& path) {
  Mesh mesh;
  mesh.uri = mesh.path = path;
  return mesh;
}

std::unique_ptr<Physics> physics_of(std::vector<Model> models, const TriangleMesh& mesh) {
  World world;
  world.models = std::move(models);
  auto physics =
      make_physics([mesh](const Mesh&) { return std::make_shared<const TriangleMesh>(mesh); });
  physics->set_world(world);
  return physics;
}

TEST(MeshPieces, AConvexMeshIsWhole) {
  TriangleMesh box;
  add_box(box, {0, 0, 0}, {1, 2, 3});
  const auto pieces = mesh_pieces(box, {1, 1, 1});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0].points.empty());
}

TEST(MeshPieces, PartsThatDoNotTouchAreApart) {
  TriangleMesh boxes;
  add_box(boxes, {0, 0, 0}, {1, 1, 1});
  add_box(boxes, {3, 0, 0}, {4, 1, 1});
  const auto pieces = mesh_pieces(boxes, {1, 1, 2});
  ASSERT_EQ(pieces.size(), 2U);
  for (const MeshPiece& piece : pieces) {
    EXPECT_EQ(piece.points.size(), 8U);
    EXPECT_EQ(std::max_element(piece.points.begin(), piece.points.end(),
                               [](const auto& a, const auto& b) { return a.z < b.z; })
                  ->z,
              2);
  }
}

TEST(MeshPieces, FacesOfAConcavePartAreSlabs) {
  // Eight walls, and an edge around the opening above and below, which is made of single
  // trapezoids.
  const auto pieces = mesh_pieces(ring(), {1, 1, 1});
  ASSERT_EQ(pieces.size(), 8U + 2 * 8);
  for (const MeshPiece& piece : pieces) {
    EXPECT_NEAR(length(piece.normal), 1, 1e-6);
    const double front = dot(piece.points[0], piece.normal);
    for (std::size_t i = 0; i < piece.points.size(); ++i)
      EXPECT_NEAR(dot(piece.points[i], piece.normal), front - (i % 2 == 0 ? 0 : kSlabThickness),
                  1e-6);
  }
}

TEST(MeshPieces, AShellWithAnOpeningIsHollow) {
  TriangleMesh box;
  add_box(box, {0, 0, 0}, {1, 2, 3});
  box.faces.resize(box.faces.size() - 6);  // without one of its sides
  const auto pieces = mesh_pieces(box, {1, 1, 1});
  EXPECT_EQ(pieces.size(), 5U);
  for (const MeshPiece& piece : pieces) EXPECT_TRUE(piece.box.has_value());
}

TEST(MeshPieces, AThinSheetWithTwoSidesIsTwoSlabs) {
  TriangleMesh sheet = square(1);
  sheet.faces.insert(sheet.faces.end(), {0, 2, 1, 0, 3, 2});
  EXPECT_EQ(mesh_pieces(sheet, {1, 1, 1}).size(), 2U);
}

TEST(MeshPieces, ATerrainOfTooManyFacesIsNotTakenApart) {
  TriangleMesh hills;
  constexpr int kSide = 40;
  for (int y = 0; y <= kSide; ++y)
    for (int x = 0; x <= kSide; ++x)
      for (const double value : {1.0 * x, 1.0 * y, std::sin(x) * std::cos(y)})
        hills.vertices.push_back(static_cast<float>(value));
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int at = y * (kSide + 1) + x;
      for (const int corner : {at, at + 1, at + kSide + 2, at, at + kSide + 2, at + kSide + 1})
        hills.faces.push_back(corner);
    }
  EXPECT_TRUE(mesh_pieces(hills, {1, 1, 1}).empty());
}

TEST(SimulatorMesh, ARoomOfOneMeshIsHollow) {
  Model ball = solid("ball", Sphere{0.1}, {0, 0, 0.1});
  ball.links.front().collisions.front().surface.mu = 0;
  const auto physics = physics_of(
      {fixed(solid("ground", Plane{}, {})), fixed(solid("room", mesh_at("ring"), {0, 0, 0})), ball},
      ring());
  const LinkHandle link = physics->link("ball", "link");
  run(*physics, 500);
  EXPECT_LT(length(physics->pose(link).position - Vector3{0, 0, 0.1}), 1e-3);
  physics->set_model_velocity("ball", {{1, 0, 0}, {}});
  run(*physics, 1500);
  EXPECT_NEAR(physics->pose(link).position.x, 1.5, 0.01);
  run(*physics, 300);  // the wall is at 1.8
  EXPECT_LT(physics->pose(link).position.x, 1.71);
  EXPECT_GT(physics->pose(link).position.x, 1.6);
  std::vector<double> distances;
  physics->cast({{{0, 0, 0.5}, {0, 1, 0}}}, RaySees::kCollisions, {}, distances);
  EXPECT_NEAR(distances[0], 1.8, 1e-6);
}

TEST(SimulatorMesh, ARoomThatIsHeldByAFixedJointIsHollowToo) {
  Model room = solid("room", mesh_at("ring"), {});
  Joint joint;
  joint.name = "held";
  joint.parent = "world";
  joint.child = "link";
  room.joints.push_back(joint);
  const auto physics = physics_of(
      {fixed(solid("ground", Plane{}, {})), room, solid("ball", Sphere{0.1}, {0, 0, 0.1})}, ring());
  run(*physics, 500);
  EXPECT_LT(length(physics->pose(physics->link("ball", "link")).position - Vector3{0, 0, 0.1}),
            1e-3);
}

TEST(SimulatorMesh, AFlatMeshCarries) {
  const auto physics = physics_of({fixed(solid("floor", mesh_at("square"), {0, 0, 2})),
                                   solid("box", Box{{0.4, 0.4, 0.4}}, {0.3, 0, 2.3})},
                                  square(1));
  run(*physics, 2000);
  EXPECT_NEAR(physics->pose(physics->link("box", "link")).position.z, 2.2, 0.001);
  std::vector<double> distances;
  physics->cast({{{-0.5, 0.5, 3}, {0, 0, -1}}}, RaySees::kCollisions, {}, distances);
  EXPECT_NEAR(distances[0], 1, 1e-6);
  EXPECT_TRUE(physics->take_warnings().empty());
}

/// The highest place that a box reaches in two seconds, that begins `depth` below where it would
/// rest.
double highest_from(double depth) {
  const auto physics = physics_of(
      {fixed(solid("ground", Plane{}, {})), solid("box", Box{{1, 1, 1}}, {0, 0, 0.5 - depth})},
      square(1));
  const LinkHandle box = physics->link("box", "link");
  double highest = 0;
  for (int i = 0; i < 2000; ++i) {
    physics->step();
    highest = std::max(highest, physics->pose(box).position.z);
  }
  EXPECT_NEAR(physics->pose(box).position.z, 0.5, 0.001);
  return highest;
}

TEST(Simulator, WhatIsPutIntoTheGroundRisesOutOfIt) {
  // At 0.3 m/s it could fly 4.6 mm high.
  EXPECT_LT(highest_from(0.3), 0.5 + 0.3 * 0.3 / (2 * 9.8) + 0.001);
}

}  // namespace
}  // namespace ros2wasm_sim
