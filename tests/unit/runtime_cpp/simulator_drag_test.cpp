// A visitor's hand in the world: what it holds comes to where it is drawn, and what it pushes gets
// that velocity.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/drag.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

Link part(const std::string& name, double mass) {
  Link link;
  link.name = name;
  link.inertial.mass = mass;
  link.inertial.ixx = link.inertial.iyy = link.inertial.izz = mass * 0.2 * 0.2 / 6;
  Collision shape;
  shape.name = "shape";
  shape.geometry = Box{{0.2, 0.2, 0.2}};
  link.collisions.push_back(shape);
  return link;
}

Model cube(const std::string& name, double mass, const Vector3& position) {
  Model model;
  model.name = name;
  model.pose.position = position;
  model.links.push_back(part("link", mass));
  return model;
}

World world_of(Model model, double step) {
  World world;
  world.physics.max_step_size = step;
  Model ground;
  ground.name = "ground";
  ground.is_static = true;
  ground.links.push_back(part("link", 1));
  ground.links.front().collisions.front().geometry = Plane{};
  world.models = {std::move(ground), std::move(model)};
  return world;
}

/// The hand of a visitor, whose time is the test's.
struct Hand {
  explicit Hand(Simulation& world) : simulation(world), drag(world, [this] { return now_ns; }) {}

  /// The world runs `pace` times as fast as the visitor's time.
  void wait(double seconds, double pace = 1) {
    const double step = simulation.physics().step_size();
    const auto steps = static_cast<int>(seconds / step + 0.5);
    for (int i = 0; i < steps; ++i) {
      drag.act();
      simulation.step();
      now_ns += static_cast<std::int64_t>(step / pace * 1e9);
    }
  }
  void hold(const Vector3& point, const Vector3& target, double seconds) {
    for (double passed = 0; passed < seconds; passed += 0.2) {
      ASSERT_TRUE(drag.hold("box", "link", point, target));
      wait(0.2);
    }
  }
  Pose box() { return simulation.physics().pose(simulation.physics().link("box", "link")); }

  Simulation& simulation;
  std::int64_t now_ns = 0;
  Drag drag;
};

TEST(SimulatorDrag, HoldsABoxInTheAirAtItsCentre) {
  for (const double step : {0.001, 0.01})
    for (const double mass : {0.05, 1.0, 500.0}) {
      NoPlugins plugins;
      Simulation simulation(world_of(cube("box", mass, {0, 0, 0.1}), step), make_physics({}),
                            plugins);
      Hand hand(simulation);
      const Vector3 target{0.5, -0.3, 1};
      hand.hold({}, target, 3);
      EXPECT_LT(length(hand.box().position - target), 0.001)
          << "mass " << mass << ", step " << step;
    }
}

TEST(SimulatorDrag, HeldByItsCornerABoxHangsBelowTheHand) {
  NoPlugins plugins;
  Simulation simulation(world_of(cube("box", 1, {0, 0, 0.1}), 0.001), make_physics({}), plugins);
  Hand hand(simulation);
  const Vector3 target{0, 0, 2};
  const Vector3 corner{0.1, 0.1, 0.1};
  hand.hold(corner, target, 4);
  const Pose pose = hand.box();
  // The hand carries the weight, so the point that it holds is where the hand is.
  EXPECT_LT(length(pose.position + rotate(pose.orientation, corner) - target), 0.05);
  EXPECT_LT(pose.position.z, target.z);
}

TEST(SimulatorDrag, LetsGoByItselfAfterASecond) {
  NoPlugins plugins;
  Simulation simulation(world_of(cube("box", 1, {0, 0, 0.1}), 0.001), make_physics({}), plugins);
  Hand hand(simulation);
  ASSERT_TRUE(hand.drag.hold("box", "link", {}, {0, 0, 2}));
  hand.wait(4);
  EXPECT_NEAR(hand.box().position.z, 0.1, 0.001);
  // A late word of the same hand takes it up again.
  hand.hold({}, {0, 0, 2}, 3);
  EXPECT_NEAR(hand.box().position.z, 2, 0.001);
}

TEST(SimulatorDrag, HoldsForASecondOfTheVisitorAlsoInAFastWorld) {
  NoPlugins plugins;
  Simulation simulation(world_of(cube("box", 1, {0, 0, 0.1}), 0.001), make_physics({}), plugins);
  Hand hand(simulation);
  ASSERT_TRUE(hand.drag.hold("box", "link", {}, {0, 0, 2}));
  hand.wait(10, 20);
  EXPECT_NEAR(hand.box().position.z, 2, 0.001);
  ASSERT_TRUE(hand.drag.hold("box", "link", {}, {0, 0, 2}));
  hand.drag.release();
  hand.wait(2, 20);
  EXPECT_NEAR(hand.box().position.z, 0.1, 0.001);
}

TEST(SimulatorDrag, APushChangesTheVelocityByWhatItSays) {
  NoPlugins plugins;
  Simulation simulation(world_of(cube("box", 3, {0, 0, 5}), 0.001), make_physics({}), plugins);
  Drag drag(simulation, [] { return 0; });
  ASSERT_TRUE(drag.push("box", "link", {}, {0.7, 0, 0}));
  simulation.step();
  const LinkHandle box = simulation.physics().link("box", "link");
  EXPECT_NEAR(simulation.physics().velocity(box).linear.x, 0.7, 1e-9);
  simulation.step();
  EXPECT_NEAR(simulation.physics().velocity(box).linear.x, 0.7, 1e-9);
}

TEST(SimulatorDrag, HoldsNothingThatDoesNotMove) {
  NoPlugins plugins;
  Simulation simulation(world_of(cube("box", 1, {0, 0, 0.1}), 0.001), make_physics({}), plugins);
  Drag drag(simulation, [] { return 0; });
  EXPECT_FALSE(drag.hold("ground", "link", {}, {0, 0, 1}));
  EXPECT_FALSE(drag.hold("box", "arm", {}, {0, 0, 1}));
  EXPECT_FALSE(drag.push("nobody", "link", {}, {1, 0, 0}));
}

TEST(SimulatorDrag, FixedJointsMakeOneMass) {
  Model model = cube("robot", 2, {});
  model.links.push_back(part("mast", 0.5));
  model.links.push_back(part("wheel", 0.25));
  Joint mast;
  mast.name = "mast_joint";
  mast.parent = "link";
  mast.child = "mast";
  Joint axle = mast;
  axle.name = "axle";
  axle.type = JointType::kRevolute;
  axle.child = "wheel";
  axle.axes.push_back({});
  model.joints = {mast, axle};
  EXPECT_DOUBLE_EQ(rigid_mass(model, "link"), 2.5);
  EXPECT_DOUBLE_EQ(rigid_mass(model, "mast"), 2.5);
  EXPECT_DOUBLE_EQ(rigid_mass(model, "wheel"), 0.25);
}

}  // namespace
}  // namespace ros2wasm_sim
