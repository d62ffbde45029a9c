// Cameras of the simulator: where things are in the picture, how far, and of which colour.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/simulation.hpp"
#include "render/camera.hpp"
#include "sensors/camera_settings.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

Model seen(const std::string& name, const Geometry& geometry, const Vector3& position,
           const Color& color = {1, 0, 0, 1}) {
  Model model;
  model.name = name;
  model.is_static = true;
  model.pose.position = position;
  Link link;
  link.name = "link";
  Visual visual;
  visual.geometry = geometry;
  visual.material.ambient = visual.material.diffuse = color;
  visual.material.is_given = true;
  link.visuals.push_back(visual);
  model.links.push_back(link);
  return model;
}

Light sun(const Vector3& direction = {0.5, 0.1, -0.9}) {
  Light light;
  light.name = "sun";
  light.type = "directional";
  light.diffuse = {0.8, 0.8, 0.8, 1};
  light.direction = direction;
  return light;
}

/// A world, and a camera at the origin that looks along x.
class View {
 public:
  View(std::vector<Model> models, std::vector<Light> lights, SceneFiles files = {},
       const Lens& lens = lens_of(640, 480, 1.047))
      : simulation_(world_of(std::move(models), std::move(lights)), make_physics(files.mesh),
                    maker_),
        scene_(simulation_, std::move(files)),
        camera_(lens) {
    look({});
  }

  static Lens lens_of(int width, int height, double fov) {
    Lens lens;
    lens.width = width;
    lens.height = height;
    lens.fx = lens.fy = width / (2 * std::tan(fov / 2));
    lens.cx = width / 2.0;
    lens.cy = height / 2.0;
    return lens;
  }

  void look(const Pose& pose) { camera_.draw(scene_, pose); }
  Simulation& simulation() { return simulation_; }
  const Picture& picture() const { return camera_.picture(); }
  float depth(int x, int y) const { return camera_.depth(x, y); }
  const std::uint8_t* pixel(int x, int y) const {
    return &picture().rgb[3 * (std::size_t{1} * y * picture().width + x)];
  }

 private:
  static World world_of(std::vector<Model> models, std::vector<Light> lights) {
    World world;
    world.models = std::move(models);
    world.lights = std::move(lights);
    return world;
  }

  NoPlugins maker_;
  Simulation simulation_;
  RenderScene scene_;
  Camera camera_;
};

bool is_red(const std::uint8_t* pixel) {
  return pixel[0] > 4 * pixel[1] && pixel[0] > 4 * pixel[2];
}

TEST(Camera, ABoxOnTheAxisIsInTheMiddleAsLargeAsItsDistanceSays) {
  const View view({seen("box", Box{{0.2, 0.2, 0.2}}, {2, 0, 0})}, {sun()});
  EXPECT_TRUE(is_red(view.pixel(320, 240)));
  double x = 0, y = 0;
  int count = 0, left = 640, right = -1;
  for (int row = 0; row < 480; ++row)
    for (int column = 0; column < 640; ++column)
      if (is_red(view.pixel(column, row))) {
        x += column;
        y += row;
        ++count;
        left = std::min(left, column);
        right = std::max(right, column);
      }
  EXPECT_NEAR(x / count, 319.5, 1e-9);
  EXPECT_NEAR(y / count, 239.5, 1e-9);
  EXPECT_NEAR(right - left + 1, 554.4 * 0.2 / 1.9, 1);
  EXPECT_NEAR(view.depth(320, 240), 1.9, 1e-6);
  EXPECT_TRUE(std::isinf(view.depth(0, 0)));
  // The background of SDF.
  EXPECT_EQ(view.pixel(0, 0)[0], 179);
}

TEST(Camera, WhatIsToTheLeftAndAboveIsThereInThePicture) {
  const View view({seen("left", Sphere{0.1}, {2, 0.5, 0}, {0, 1, 0, 1}),
                   seen("above", Sphere{0.1}, {2, 0, 0.5}, {0, 0, 1, 1})},
                  {sun()});
  const int offset = static_cast<int>(554.4 * 0.25);
  EXPECT_GT(view.pixel(320 - offset, 240)[1], 100);
  EXPECT_GT(view.pixel(320, 240 - offset)[2], 100);
}

TEST(Camera, APlaneThatReachesBehindTheCameraIsSeenToTheHorizon) {
  View view({seen("ground", Plane{{0, 0, 1}, 100, 100}, {}, {0, 1, 0, 1})}, {sun()});
  view.look({{0, 0, 1}, {}});
  int wrong = 0;
  for (int row = 0; row < 480; ++row)
    for (int column = 0; column < 640; ++column) {
      // The height of the camera over the tangent of the angle below the horizon.
      const double depth = 554.38 / (row + 0.5 - 240);
      const bool is_ground = depth > 0 && depth < 50;
      const bool is_drawn = view.pixel(column, row)[1] > 100 && view.pixel(column, row)[0] == 0;
      wrong += is_drawn != is_ground && std::abs(depth - 50) > 5 ? 1 : 0;
      if (is_ground && depth < 45) {
        EXPECT_NEAR(view.depth(column, row), depth, 1e-4 * depth);
      }
    }
  EXPECT_EQ(wrong, 0);
}

TEST(Camera, ASurfaceIsAsBrightAsLambertsLawSays) {
  const Vector3 direction{0.6, 0, -0.8};
  View view({seen("wall", Box{{0.1, 10, 10}}, {2, 0, 0}, {1, 0.5, 0, 1})}, {sun(direction)});
  // The ambient light of a scene is 0.4; the face looks along -x.
  EXPECT_EQ(view.pixel(320, 240)[0], std::lround(255 * (0.4 + 0.8 * 0.6)));
  EXPECT_EQ(view.pixel(320, 240)[1], std::lround(255 * 0.5 * (0.4 + 0.8 * 0.6)));
  Light lamp = sun();
  lamp.type = "point";
  lamp.pose.position = {0.95, 0, 0};
  lamp.linear = 0;
  View lit({seen("wall", Box{{0.1, 10, 10}}, {2, 0, 0})}, {lamp});
  // One metre before the wall; and at 45 degrees, where the cosine is that of the angle.
  EXPECT_NEAR(lit.pixel(320, 240)[0], 255, 1);
  const int at_45 = 320 + static_cast<int>(554.4 / 1.95);
  EXPECT_NEAR(lit.pixel(at_45, 240)[0], 255 * (0.4 + 0.8 * std::sqrt(0.5)), 2);
}

TEST(Camera, NeighbouringTrianglesLeaveNoGap) {
  // A tilted sphere of many triangles before nothing: inside of its outline each pixel is drawn.
  View view({seen("ball", Sphere{1}, {3, 0, 0})}, {sun()});
  for (int i = 0; i < 20; ++i) {
    view.look({{0.01 * i, 0.02 * i, 0}, from_roll_pitch_yaw(0.1 * i, 0.013 * i, 0.017 * i)});
    for (int row = 0; row < 480; ++row) {
      int left = 640, right = -1;
      for (int column = 0; column < 640; ++column)
        if (!std::isinf(view.depth(column, row))) {
          left = std::min(left, column);
          right = column;
        }
      for (int column = left; column <= right; ++column)
        ASSERT_LT(view.depth(column, row), 4) << column << " " << row << " " << i;
    }
  }
}

TEST(Camera, TheNearestIsSeenAndTransparentThingsLetThrough) {
  View view({seen("far", Box{{0.1, 4, 4}}, {3, 0, 0}, {0, 1, 0, 1}),
             seen("near", Box{{0.1, 0.2, 0.2}}, {2, 0, 0})},
            {sun()});
  EXPECT_TRUE(is_red(view.pixel(320, 240)));
  EXPECT_FALSE(is_red(view.pixel(400, 240)));
  View glass({seen("far", Box{{0.1, 4, 4}}, {3, 0, 0}, {0, 1, 0, 1}),
              seen("near", Box{{0.1, 0.2, 0.2}}, {2, 0, 0}, {1, 0, 0, 0.5})},
             {sun()});
  const std::uint8_t* pixel = glass.pixel(320, 240);
  EXPECT_NEAR(pixel[0], glass.pixel(400, 240)[1] / 2.0, 1);
  EXPECT_NEAR(pixel[1], glass.pixel(400, 240)[1] / 2.0, 1);
}

/// A picture of two by two pixels in the BMP format: red and green above, blue and white below.
std::string four_colors() {
  std::string bmp("BM", 2);
  const auto put = [&](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) bmp += static_cast<char>(value >> (8 * i));
  };
  put(70, 4), put(0, 4), put(54, 4), put(40, 4), put(2, 4), put(2, 4), put(1, 2), put(24, 2);
  for (int i = 0; i < 6; ++i) put(i == 1 ? 16 : 0, 4);
  const char rows[] =
      "\xff\0\0\xff\xff\xff\0\0"
      "\0\0\xff\0\xff\0\0\0";  // from below, blue first
  return bmp + std::string(rows, 16);
}

TEST(Camera, APictureOnAPlaneHasItsUpperLeftCornerAtLowXAndHighY) {
  Model board = seen("board", Plane{{0, 0, 1}, 2, 2}, {}, {1, 1, 1, 1});
  board.links.front().visuals.front().material.texture = "/four.bmp";
  Light bright = sun({0, 0, -1});
  bright.diffuse = {1, 1, 1, 1};
  View view({board}, {bright}, {{}, [](const std::string& path) {
                                  EXPECT_EQ(path, "/four.bmp");
                                  return four_colors();
                                }});
  // From above, with the top of the camera towards +y.
  view.look({{0, 0, 2},
             from_roll_pitch_yaw(0, 0, 1.5707963267948966) *
                 from_roll_pitch_yaw(0, 1.5707963267948966, 0)});
  const int step = static_cast<int>(554.4 / 2 / 2);
  const auto is = [&](int x, int y, std::array<int, 3> color) {
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(view.pixel(320 + x * step, 240 + y * step)[c], color[c], 3) << x << " " << y;
  };
  is(-1, -1, {255, 0, 0});
  is(1, -1, {0, 255, 0});
  is(-1, 1, {0, 0, 255});
  is(1, 1, {255, 255, 255});
}

TEST(Camera, AModelThatComesIsSeenAndGoesAgain) {
  View view({seen("far", Box{{0.1, 4, 4}}, {3, 0, 0}, {0, 1, 0, 1})}, {sun()});
  view.simulation().add(seen("near", Sphere{0.2}, {2, 0, 0}));
  view.look({});
  EXPECT_TRUE(is_red(view.pixel(320, 240)));
  view.simulation().remove("near");
  view.look({});
  EXPECT_FALSE(is_red(view.pixel(320, 240)));
}

TEST(Camera, NoiseHasItsMeanAndDeviationAndDependsOnTheSeedAlone) {
  CameraSettings settings;
  settings.noise_mean = 0.02;
  settings.noise_stddev = 0.05;
  Picture grey{200, 200, std::vector<std::uint8_t>(200 * 200 * 3, 128)};
  Picture same = grey;
  PictureNoise(settings, 7, "camera").apply(grey);
  PictureNoise(settings, 7, "camera").apply(same);
  EXPECT_EQ(grey.rgb, same.rgb);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < grey.rgb.size(); i += 3) {
    EXPECT_EQ(grey.rgb[i], grey.rgb[i + 2]);
    sum += grey.rgb[i] - 128.0;
    squares += (grey.rgb[i] - 128.0) * (grey.rgb[i] - 128.0);
  }
  const double count = grey.rgb.size() / 3.0, mean = sum / count;
  EXPECT_NEAR(mean, 255 * 0.02, 0.2);
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), 255 * 0.05, 0.3);
}

TEST(Camera, JpegFilesAreReadBackAlmostAsTheyWere) {
  Picture picture{64, 48, {}};
  for (int i = 0; i < 64 * 48; ++i)
    picture.rgb.insert(picture.rgb.end(), {static_cast<std::uint8_t>(4 * (i % 64)), 100, 200});
  const auto bytes = jpeg_of(picture, 95);
  const auto read = read_picture(std::string(bytes.begin(), bytes.end()));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->rgb.size(), picture.rgb.size());
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    EXPECT_NEAR(read->rgb[i], picture.rgb[i], 12);
  EXPECT_FALSE(read_picture("no picture"));
  EXPECT_FALSE(read_picture(std::string(bytes.begin(), bytes.begin() + 20)));
}

}  // namespace
}  // namespace ros2wasm_sim
