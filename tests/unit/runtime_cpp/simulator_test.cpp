// The physics of the simulator against numbers that follow from the formulas of mechanics. The same
// engine is natively linked from Debian.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "physics/physics.hpp"
#include "sensors/lidar.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

/// A base of 3 kg on two wheels of 5 cm, 30 cm apart, and a caster that slides.
Model rover() {
  Model model = solid("rover", Box{{0.3, 0.26, 0.1}}, {0, 0, 0.01});
  Link& base = model.links.front();
  base.name = "base";
  base.inertial.mass = 3;
  base.inertial.pose.position = {0, 0, 0.05};
  base.collisions.front().pose.position = {0, 0, 0.1};
  Collision caster;
  caster.name = "caster";
  caster.geometry = Sphere{0.05};
  caster.pose.position = {-0.12, 0, 0.05};
  caster.surface.mu = 0.001;
  base.collisions.push_back(caster);
  for (const double side : {0.15, -0.15}) {
    Link wheel;
    wheel.name = side > 0 ? "left" : "right";
    wheel.pose.position = {0.06, side, 0.05};
    wheel.inertial.mass = 0.2;
    wheel.inertial.ixx = wheel.inertial.izz = 0.00014;
    wheel.inertial.iyy = 0.00025;
    Collision tyre;
    tyre.name = "tyre";
    tyre.geometry = Cylinder{0.05, 0.03};
    tyre.pose.orientation = from_roll_pitch_yaw(kPi / 2, 0, 0);
    wheel.collisions.push_back(tyre);
    Joint joint;
    joint.name = wheel.name + "_joint";
    joint.type = JointType::kRevolute;
    joint.parent = "base";
    joint.child = wheel.name;
    joint.axes.push_back({});
    joint.axes.front().xyz = {0, 1, 0};
    model.joints.push_back(joint);
    model.links.push_back(wheel);
  }
  return model;
}

TEST(Simulator, ABoxFallsAndComesToRest) {
  const auto physics = physics_of({ground(), solid("box", Box{{1, 1, 1}}, {0, 0, 10})});
  const LinkHandle box = physics->link("box", "link");
  run(*physics, 1000);
  EXPECT_NEAR(physics->pose(box).position.z, 10 - 4.9, 0.006);
  EXPECT_NEAR(physics->velocity(box).linear.z, -9.8, 1e-9);
  EXPECT_NEAR(physics->proper_acceleration(box).linear.z, 0, 1e-9);
  run(*physics, 1392);
  EXPECT_NEAR(physics->pose(box).position.z, 0.5, 0.0005);
  EXPECT_LT(length(physics->velocity(box).linear), 1e-3);
  EXPECT_NEAR(physics->proper_acceleration(box).linear.z, 9.8, 0.01);
}

TEST(Simulator, APendulumSwingsAsLongAsItsFormulaSays) {
  Model pendulum;
  pendulum.name = "pendulum";
  pendulum.pose.position.z = 3;
  Link arm;
  arm.name = "arm";
  arm.inertial.ixx = arm.inertial.iyy = arm.inertial.izz = 1e-6;
  arm.inertial.pose.position = {0, 0, -1};
  pendulum.links.push_back(arm);
  Joint joint;
  joint.name = "pivot";
  joint.type = JointType::kRevolute;
  joint.parent = "world";
  joint.child = "arm";
  joint.axes.push_back({});
  joint.axes.front().xyz = {0, 1, 0};
  pendulum.joints.push_back(joint);
  const auto physics = physics_of({pendulum});
  const JointHandle pivot = physics->joint("pendulum", "pivot");
  physics->set_position(pivot, 0.1);
  double last = 0.1, first = 0, latest = 0, widest = 0;
  int crossings = 0;
  for (int step = 1; step <= 20000; ++step) {
    physics->step();
    const double angle = physics->position(pivot);
    if (last > 0 && angle <= 0) (crossings++ == 0 ? first : latest) = step * 0.001;
    if (step > 18000) widest = std::max(widest, angle);
    last = angle;
  }
  EXPECT_NEAR((latest - first) / (crossings - 1), 2 * kPi * std::sqrt(1 / 9.8) * (1 + 0.01 / 16),
              0.004);
  EXPECT_GE(widest, 0.099);
}

TEST(Simulator, AStackOfBoxesStands) {
  std::vector<Model> models{ground()};
  for (int i = 0; i < 5; ++i)
    models.push_back(solid("box" + std::to_string(i), Box{{0.2, 0.2, 0.2}}, {0, 0, 0.1 + 0.2 * i}));
  const auto physics = physics_of(std::move(models));
  run(*physics, 10000);
  for (int i = 0; i < 5; ++i) {
    const Pose pose = physics->pose(physics->link("box" + std::to_string(i), "link"));
    EXPECT_NEAR(pose.position.z, 0.1 + 0.2 * i, 0.0005);
    EXPECT_NEAR(pose.position.x, 0, 0.0001);
  }
}

TEST(Simulator, WheelsDriveAndTurnByTheirRadius) {
  const auto physics = physics_of({ground(), rover()});
  const LinkHandle base = physics->link("rover", "base");
  const JointHandle left = physics->joint("rover", "left_joint"),
                    right = physics->joint("rover", "right_joint");
  run(*physics, 1000);
  const double start = physics->pose(base).position.x;
  for (int i = 0; i < 5000; ++i) {
    const double speed = std::min(0.2, i * 0.001);  // 1 m/s^2: the ramp costs 0.02 m
    physics->set_motor(left, speed / 0.05, 20);
    physics->set_motor(right, speed / 0.05, 20);
    physics->step();
  }
  EXPECT_NEAR(physics->pose(base).position.x - start, 0.98, 0.0098);
  EXPECT_NEAR(physics->pose(base).position.y, 0, 0.005);
  EXPECT_NEAR(physics->velocity(left), 4, 0.001);
  double turned = 0, last = yaw_of(physics->pose(base).orientation);
  for (int i = 0; i < 12566; ++i) {  // 0.5 rad/s for 4 pi seconds
    physics->set_motor(left, -1.5, 20);
    physics->set_motor(right, 1.5, 20);
    physics->step();
    const double yaw = yaw_of(physics->pose(base).orientation);
    turned += std::remainder(yaw - last, 2 * kPi);
    last = yaw;
  }
  EXPECT_NEAR(turned, 2 * kPi, 0.02 * kPi);
}

TEST(Simulator, AMotorIsNoStrongerThanItsLimit) {
  const auto physics = physics_of({ground(), rover()});
  const JointHandle left = physics->joint("rover", "left_joint");
  physics->set_motor(left, 100, 0.01);
  run(*physics, 100);
  EXPECT_LE(std::abs(physics->effort(left)), 0.01 + 1e-9);
  EXPECT_LT(physics->velocity(left), 100);
}

TEST(Simulator, TheSmallerFrictionOfAPairCounts) {
  Model block = solid("block", Box{{0.2, 0.2, 0.2}}, {0, 0, 0.1});
  block.links.front().collisions.front().surface.mu = 0;
  const auto physics = physics_of({ground(), block});
  run(*physics, 200);
  physics->set_model_velocity("block", {{1, 0, 0}, {}});
  run(*physics, 1000);
  EXPECT_NEAR(physics->velocity(physics->link("block", "link")).linear.x, 1, 0.01);
}

TEST(Simulator, WhatComesAndGoesLeavesTheRestWhereItWas) {
  World world;
  world.models = {ground(), solid("box", Box{{1, 1, 1}}, {0, 0, 10})};
  const auto physics = make_physics({});
  physics->set_world(world);
  const LinkHandle box = physics->link("box", "link");
  run(*physics, 500);
  const double height = physics->pose(box).position.z, speed = physics->velocity(box).linear.z;
  world.models.insert(world.models.begin(), solid("another", Sphere{0.5}, {5, 0, 3}));
  physics->set_world(world);
  EXPECT_EQ(physics->pose(box).position.z, height);
  EXPECT_EQ(physics->velocity(box).linear.z, speed);
  world.models.pop_back();
  physics->set_world(world);
  EXPECT_EQ(physics->pose(box).position, Vector3{});  // it is gone
  EXPECT_FALSE(physics->link("box", "link").valid());
}

TEST(Simulator, ALidarMeasuresAWallFromEachAngle) {
  const auto physics = physics_of({fixed(solid("wall", Box{{0.1, 100, 4}}, {2.05, 0, 0})),
                                   fixed(solid("carrier", Sphere{0.05}, {0, 0, 0})),
                                   fixed(solid("near", Box{{0.02, 0.02, 0.02}}, {-0.08, 0, 0}))});
  Sensor sensor;
  sensor.name = "lidar";
  sensor.type = "ray";
  const auto document = std::make_shared<const ros2wasm_xml::XmlDocument>(
      "<sensor><ray><scan><horizontal><samples>5</samples><min_angle>-0.8</"
      "min_angle><max_angle>0.8</max_angle>"
      "</horizontal></scan><range><min>0.12</min><max>10</max></range></ray></sensor>");
  sensor.xml = {document, &document->root()};
  Lidar lidar(sensor, *physics, "carrier", "link", 1);
  const std::vector<double>& ranges = lidar.measure();
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(ranges[i], 2 / std::cos(-0.8 + 0.4 * i), 1e-9);
  sensor.pose.orientation = from_roll_pitch_yaw(0, 0, kPi);
  Lidar behind(sensor, *physics, "carrier", "link", 1);
  EXPECT_EQ(behind.measure()[2], -kInfinity);  // nearer than its minimum
  EXPECT_EQ(behind.measure()[0], kInfinity);
}

TEST(Simulator, TheNoiseOfALidarIsAsItsElementSays) {
  const auto physics = physics_of({fixed(solid("wall", Box{{0.1, 10, 4}}, {2.05, 0, 0})),
                                   fixed(solid("carrier", Sphere{0.05}, {0, 0, 0}))});
  Sensor sensor;
  sensor.name = "lidar";
  sensor.type = "ray";
  const auto document = std::make_shared<const ros2wasm_xml::XmlDocument>(
      "<sensor><ray><scan><horizontal><samples>1</samples></horizontal></scan><range><min>0.12</"
      "min><max>10</max>"
      "</range><noise "
      "type=\"gaussian\"><mean>0</mean><stddev>0.01</stddev></noise></ray></sensor>");
  sensor.xml = {document, &document->root()};
  Lidar lidar(sensor, *physics, "carrier", "link", 1), twin(sensor, *physics, "carrier", "link", 1);
  double sum = 0, squares = 0;
  for (int i = 0; i < 200; ++i) {
    const double range = lidar.measure()[0];
    EXPECT_EQ(range, twin.measure()[0]);  // the same seed, the same noise
    sum += range;
    squares += range * range;
  }
  const double mean = sum / 200;
  EXPECT_NEAR(mean, 2, 0.003);
  EXPECT_NEAR(std::sqrt(squares / 200 - mean * mean), 0.01, 0.002);
}

TEST(Simulator, AModelThatExplodesIsNamed) {
  const auto physics = physics_of({ground(), solid("box", Box{{1, 1, 1}}, {0, 0, 10})});
  physics->set_model_velocity("box", {{1e300, 0, 0}, {}});
  try {
    run(*physics, 10);
    FAIL();
  } catch (const PhysicsError& error) {
    EXPECT_NE(std::string(error.what()).find("model `box`, link `link`,"), std::string::npos)
        << error.what();
  }
  physics->reset();
  EXPECT_EQ(physics->pose(physics->link("box", "link")).position.z, 10);
  run(*physics, 10);
}

TEST(Simulator, AModelThatComesBackHasNoOldCommands) {
  World world;
  world.models = {ground(), rover()};
  const auto physics = make_physics({});
  physics->set_world(world);
  physics->set_motor(physics->joint("rover", "left_joint"), 4, 20);
  physics->set_motor(physics->joint("rover", "right_joint"), 4, 20);
  run(*physics, 500);
  world.models.pop_back();
  physics->set_world(world);
  world.models.push_back(rover());
  physics->set_world(world);
  run(*physics, 500);
  EXPECT_NEAR(physics->pose(physics->link("rover", "base")).position.x, 0, 0.001);
}

TEST(Simulator, AWorldThatCannotBeIsRefusedAndTheOldOneGoesOn) {
  World world;
  world.models = {ground(), solid("box", Box{{1, 1, 1}}, {0, 0, 10})};
  const auto physics = make_physics({});
  physics->set_world(world);
  run(*physics, 100);
  const std::uint64_t before = physics->state_hash();
  World wrong = world;
  wrong.models.push_back(solid("heavy", Sphere{1}, {}));
  wrong.models.back().links.front().inertial.mass = std::nan("");
  EXPECT_THROW(physics->set_world(wrong), PhysicsError);
  EXPECT_EQ(physics->state_hash(), before);
  physics->step();
}

TEST(Simulator, ALargeWorldIsLoadedAndOneThatIsTooLargeIsRefusedAtOnce) {
  std::vector<Model> models;
  for (int i = 0; i < 5000; ++i)
    models.push_back(fixed(
        solid("box" + std::to_string(i), Box{{0.2, 0.2, 0.2}}, {i % 100 * 0.5, i / 100 * 0.5, 0})));
  const auto physics = physics_of(models);
  physics->step();
  World world;
  world.models = std::move(models);
  world.models.push_back(ground());
  try {
    physics->set_world(world);
    FAIL();
  } catch (const PhysicsError& error) {
    EXPECT_STREQ(error.what(), "the world has 5001 links; at most 5000 are simulated");
  }
}

TEST(Simulator, TwoRunsAreTheSame) {
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    const auto physics =
        physics_of({ground(), rover(), solid("box", Box{{0.2, 0.2, 0.2}}, {0.4, 0.05, 0.3})});
    physics->set_motor(physics->joint("rover", "left_joint"), 4, 20);
    physics->set_motor(physics->joint("rover", "right_joint"), 3, 20);
    run(*physics, 3000);
    hash = physics->state_hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

/// A housing that is both seen and touched, of 5 cm around the origin, and a wall 2 m ahead.
TEST(Simulator, WhatIsSeenIsNotSeenFromInside) {
  for (const Geometry& form :
       {Geometry(Cylinder{0.05, 0.1}), Geometry(Box{{0.1, 0.1, 0.1}}), Geometry(Sphere{0.05}),
        Geometry(Capsule{0.05, 0.1}), Geometry(Ellipsoid{{0.05, 0.05, 0.1}})}) {
    Model housing = fixed(solid("housing", form, {}));
    Model wall = fixed(solid("wall", Box{{0.2, 4, 4}}, {2.1, 0, 0}));
    for (Model* model : {&housing, &wall}) {
      Visual visual;
      visual.name = "look";
      visual.geometry = model->links.front().collisions.front().geometry;
      model->links.front().visuals.push_back(visual);
    }
    const auto physics = physics_of({housing, wall});
    const std::vector<Ray> rays{{{0, 0, 0}, {1, 0, 0}},     // from inside
                                {{0.05, 0, 0}, {1, 0, 0}},  // from its surface
                                {{-1, 0, 0}, {1, 0, 0}}};   // from outside
    std::vector<double> distances;
    physics->cast(rays, RaySees::kVisuals, {}, distances);
    EXPECT_NEAR(distances[0], 2, 1e-9);
    EXPECT_NEAR(distances[1], 1.95, 1e-9);
    EXPECT_NEAR(distances[2], 0.95, 1e-9);
    physics->cast(rays, RaySees::kCollisions, {}, distances);
    EXPECT_NEAR(distances[0], 0.05, 1e-9);
  }
}

Mesh mesh_of(const std::string& path) {
  Mesh mesh;
  mesh.uri = mesh.path = path;
  return mesh;
}

/// A tetrahedron of a side of 1 m, or a triangle that is flat.
std::shared_ptr<const TriangleMesh> tetrahedron(const Mesh& mesh) {
  TriangleMesh read;
  read.vertices = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  read.faces = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  if (mesh.path == "flat") read.vertices[11] = 0;
  return std::make_shared<const TriangleMesh>(read);
}

TEST(Simulator, AMeshIsSolidAndOneThatIsFlatIsThin) {
  World world;
  world.models = {ground(), solid("good", mesh_of("good"), {0, 0, 2}),
                  solid("flat", mesh_of("flat"), {5, 0, 2})};
  const auto physics = make_physics(tetrahedron);
  physics->set_world(world);
  EXPECT_TRUE(physics->take_warnings().empty());
  run(*physics, 2000);
  EXPECT_NEAR(physics->pose(physics->link("good", "link")).position.z, 0, 0.01);
  EXPECT_NEAR(physics->pose(physics->link("flat", "link")).position.z, 0, 0.01);
}

}  // namespace
}  // namespace ros2wasm_sim
