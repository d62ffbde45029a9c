// Heightmaps: what the picture says is where things come to rest, what rays meet and what is drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "mesh/heights.hpp"
#include "physics/physics.hpp"
#include "render/scene.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

/// A TGA file of grey pixels, the upper row first.
std::string grey_picture(int width, int height, const std::vector<int>& pixels) {
  std::string bytes(18, '\0');
  bytes[2] = 2;  // true colours, not packed
  bytes[12] = static_cast<char>(width & 255);
  bytes[13] = static_cast<char>(width >> 8);
  bytes[14] = static_cast<char>(height & 255);
  bytes[15] = static_cast<char>(height >> 8);
  bytes[16] = 24;
  bytes[17] = 0x20;  // from above
  for (const int grey : pixels) bytes.append(3, static_cast<char>(grey));
  return bytes;
}

/// A plateau in the north-west of a plain, and one half as high in the south-east.
std::string plateaus() {
  constexpr int kSize = 65;
  std::vector<int> pixels;
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column)
      pixels.push_back(row < 30 && column < 30 ? 200 : row > 34 && column > 34 ? 100 : 0);
  return grey_picture(kSize, kSize, pixels);
}

MeshReader reader_of(const std::string& bytes) {
  const auto grid = read_heights(bytes);
  const auto shared = grid ? std::make_shared<const TriangleMesh>(*grid) : nullptr;
  return [shared](const Mesh&) { return shared; };
}

Model land(const Vector3& size, const Vector3& position) {
  Heightmap map;
  map.uri = map.path = "land.tga";
  map.size = size;
  map.position = position;
  Model model;
  model.name = "land";
  model.is_static = true;
  Link link;
  link.name = "link";
  Collision ground;
  ground.name = "ground";
  ground.geometry = map;
  link.collisions.push_back(ground);
  Visual seen;
  seen.name = "seen";
  seen.geometry = map;
  link.visuals.push_back(seen);
  model.links.push_back(link);
  return model;
}

Model ball(const std::string& name, const Vector3& position) {
  Model model;
  model.name = name;
  model.pose.position = position;
  Link link;
  link.name = "link";
  link.inertial.mass = 1;
  link.inertial.ixx = link.inertial.iyy = link.inertial.izz = 0.004;
  Collision shape;
  shape.name = "shape";
  shape.geometry = Sphere{0.1};
  link.collisions.push_back(shape);
  model.links.push_back(link);
  return model;
}

TEST(SimulatorHeights, TheBrightestPixelIsAMetreHigh) {
  const auto grid = read_heights(grey_picture(3, 2, {0, 50, 200, 100, 0, 0}));
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->columns, 3);
  EXPECT_EQ(grid->rows, 2);
  EXPECT_EQ(grid->vertices, (std::vector<float>{-0.5F, 0.5F, 0, 0, 0.5F, 0.25F, 0.5F, 0.5F, 1,  //
                                                -0.5F, -0.5F, 0.5F, 0, -0.5F, 0, 0.5F, -0.5F, 0}));
  EXPECT_EQ(grid->faces.size(), 3U * 2 * 2);
}

TEST(SimulatorHeights, PicturesThatAreNoneOrTooLargeAreRefused) {
  EXPECT_FALSE(read_heights("no picture"));
  EXPECT_FALSE(read_heights(grey_picture(1, 5, std::vector<int>(5))));
  EXPECT_FALSE(
      read_heights(grey_picture(kMostHeights + 1, 2, std::vector<int>(2 * (kMostHeights + 1)))));
  const auto large = read_heights(grey_picture(1025, 1025, std::vector<int>(1025 * 1025, 7)));
  ASSERT_TRUE(large);
  EXPECT_EQ(large->vertices.size(), 3U * 1025 * 1025);
  EXPECT_EQ(large->faces.size(), 3U * 2 * 128 * 128) << "what is drawn is coarser";
}

TEST(SimulatorHeights, BallsRestWhereThePictureSays) {
  World world;
  world.models = {land({8, 8, 2}, {0, 0, 0.5}), ball("north_west", {-2.5, 2.5, 3}),
                  ball("south_east", {2.5, -2.5, 3}), ball("south_west", {-2.5, -2.5, 3})};
  const auto physics = make_physics(reader_of(plateaus()));
  physics->set_world(world);
  EXPECT_TRUE(physics->take_warnings().empty());
  for (int i = 0; i < 3000; ++i) physics->step();
  const auto height = [&](const std::string& name) {
    return physics->pose(physics->link(name, "link")).position.z;
  };
  EXPECT_NEAR(height("north_west"), 0.5 + 2 + 0.1, 0.003);
  EXPECT_NEAR(height("south_east"), 0.5 + 1 + 0.1, 0.003);
  EXPECT_NEAR(height("south_west"), 0.5 + 0 + 0.1, 0.003);
}

TEST(SimulatorHeights, RaysMeetWhatThePictureSays) {
  World world;
  world.models = {land({8, 8, 2}, {0, 0, 0.5})};
  const auto physics = make_physics(reader_of(plateaus()));
  physics->set_world(world);
  const std::vector<Ray> rays = {{{-2.5, 2.5, 5}, {0, 0, -1}},
                                 {{2.5, -2.5, 5}, {0, 0, -1}},
                                 {{2.5, 2.5, 5}, {0, 0, -1}},
                                 {{3, 2.5, 1.5}, {-1, 0, 0}}};
  for (const RaySees sees : {RaySees::kCollisions, RaySees::kVisuals}) {
    std::vector<double> distances;
    physics->cast(rays, sees, {}, distances);
    EXPECT_NEAR(distances[0], 2.5, 1e-6);
    EXPECT_NEAR(distances[1], 3.5, 1e-6);
    EXPECT_NEAR(distances[2], 4.5, 1e-6);
    // The slope between pixels 29 and 30, which are 1/8 m wide: half of it at -4 + 29.5 / 8.
    EXPECT_NEAR(distances[3], 3 - (-4 + 29.5 / 8), 1e-6);
  }
}

TEST(SimulatorHeights, AMapThatCannotBeReadIsSkippedByName) {
  World world;
  world.models = {land({8, 8, 2}, {})};
  const auto physics = make_physics(reader_of("no picture"));
  physics->set_world(world);
  const auto warnings = physics->take_warnings();
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.front(),
            "collision `ground` of link `link` is skipped: its heightmap "
            "`land.tga` cannot be read");
}

TEST(SimulatorHeights, CamerasSeeTheLand) {
  NoPlugins plugins;
  World world;
  world.models = {land({8, 8, 2}, {0, 0, 0.5})};
  const MeshReader reader = reader_of(plateaus());
  Simulation simulation(world, make_physics(reader), plugins);
  RenderScene scene(simulation, {reader, {}});
  ASSERT_EQ(scene.items().size(), 1U);
  const Item& item = scene.items().front();
  double highest = 0;
  for (const Corner& corner : *item.triangles)
    highest = std::max(highest, static_cast<double>(corner.position[2]));
  EXPECT_NEAR(highest + item.in_link.position.z, 2.5, 1e-6);
}

}  // namespace
}  // namespace ros2wasm_sim
