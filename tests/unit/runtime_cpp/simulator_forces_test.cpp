// Forces in contacts and joints, against statics: a weight on the floor, an arm on its joint, and
// which shapes are near a point.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "physics/physics.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

Link link_of(const std::string& name, double mass, const Geometry& geometry) {
  Link link;
  link.name = name;
  link.inertial.mass = mass;
  link.inertial.ixx = link.inertial.iyy = link.inertial.izz = 0.01;
  Collision shape;
  shape.name = "shape";
  shape.geometry = geometry;
  link.collisions.push_back(shape);
  return link;
}

Model model_of(const std::string& name, Link link, const Vector3& position) {
  Model model;
  model.name = name;
  model.pose.position = position;
  model.links.push_back(std::move(link));
  return model;
}

TEST(SimulatorForces, AFloorCarriesTheWeightOfABox) {
  const auto physics = physics_of(
      {ground(), model_of("box", link_of("body", 2, Box{{0.4, 0.4, 0.2}}), {0, 0, 0.1})});
  physics->watch_contacts();
  EXPECT_TRUE(physics->contacts().empty());  // no step was made
  run(*physics, 2000);
  const std::vector<Contact> contacts = physics->contacts();
  ASSERT_EQ(contacts.size(), 1U);
  const bool box_is_first = contacts[0].first == "box::body::shape";
  EXPECT_EQ(box_is_first ? contacts[0].second : contacts[0].first, "ground::link::shape");
  EXPECT_EQ(box_is_first ? contacts[0].first : contacts[0].second, "box::body::shape");
  EXPECT_EQ(contacts[0].points.size(), 4U);  // its corners
  const double sign = box_is_first ? 1 : -1;
  double carried = 0;
  for (const ContactPoint& point : contacts[0].points) {
    EXPECT_NEAR(sign * point.normal.z, 1, 1e-9);  // out of the floor, for the box
    EXPECT_NEAR(std::abs(point.position.x), 0.2, 1e-3);
    EXPECT_NEAR(point.position.z, 0, 1e-3);
    EXPECT_GE(point.depth, 0);
    EXPECT_LT(point.depth, 1e-3);
    carried += sign * point.wrench.force.z;
  }
  EXPECT_NEAR(carried, 2 * 9.8, 1e-3);
  physics->set_model_pose("box", {{0, 0, 3}, {}}, true);
  physics->step();
  EXPECT_TRUE(physics->contacts().empty());
}

TEST(SimulatorForces, ContactsWithAWheelAreOnePair) {
  Model model = model_of("cart", link_of("base", 1, Sphere{0.05}), {0, 0, 0.05});
  Link wheel = link_of("wheel", 0.5, Cylinder{0.05, 0.02});
  wheel.pose.position.y = 0.2;
  wheel.collisions.front().pose.orientation = from_roll_pitch_yaw(kPi / 2, 0, 0);
  Joint joint;
  joint.name = "axle";
  joint.type = JointType::kRevolute;
  joint.parent = "base";
  joint.child = "wheel";
  joint.axes.push_back({});
  joint.axes.front().xyz = {0, 1, 0};
  model.links.push_back(wheel);
  model.joints.push_back(joint);
  const auto physics = physics_of({ground(), model});
  physics->watch_contacts();
  run(*physics, 1000);
  double carried = 0;
  std::size_t with_wheel = 0;
  for (const Contact& contact : physics->contacts()) {
    const bool is_ground_first = contact.first == "ground::link::shape";
    const std::string_view other = is_ground_first ? contact.second : contact.first;
    with_wheel += other == "cart::wheel::shape" ? 1 : 0;
    for (const ContactPoint& point : contact.points)
      carried += (is_ground_first ? -1 : 1) * point.wrench.force.z;
  }
  EXPECT_EQ(with_wheel, 1U);
  EXPECT_NEAR(carried, 1.5 * 9.8, 0.01);
}

/// An arm of 2 kg whose centre of mass is 0.5 m along x, on a joint of the world at its origin.
Model arm(JointType type, const Quaternion& turned) {
  Model model = model_of("arm", link_of("boom", 2, Sphere{0.01}), {0, 0, 1});
  Link& boom = model.links.front();
  boom.inertial.pose.position.x = 0.5;
  boom.pose.orientation = turned;
  Joint joint;
  joint.name = "shoulder";
  joint.type = type;
  joint.parent = "world";
  joint.child = "boom";
  if (type != JointType::kFixed) {
    joint.axes.push_back({});
    joint.axes.front().xyz = {0, 1, 0};
  }
  model.joints.push_back(joint);
  return model;
}

TEST(SimulatorForces, AFixedJointCarriesItsArm) {
  const auto physics = physics_of({arm(JointType::kFixed, {})});
  const LinkHandle boom = physics->link("arm", "boom");
  physics->watch_wrench(boom);
  run(*physics, 10);
  const Wrench wrench = physics->wrench(boom);
  EXPECT_NEAR(wrench.force.z, 2 * 9.8, 1e-9);
  EXPECT_NEAR(wrench.force.x, 0, 1e-9);
  EXPECT_NEAR(wrench.torque.y, -0.5 * 2 * 9.8, 1e-9);  // it lifts the end: r x F has -y
  EXPECT_NEAR(wrench.torque.x, 0, 1e-9);
}

TEST(SimulatorForces, TheWrenchIsAlongTheAxesOfTheLink) {
  // Turned by 90 degrees about y: its x looks down.
  const auto physics = physics_of({arm(JointType::kFixed, from_roll_pitch_yaw(0, kPi / 2, 0))});
  const LinkHandle boom = physics->link("arm", "boom");
  physics->watch_wrench(boom);
  run(*physics, 10);
  EXPECT_NEAR(physics->wrench(boom).force.x, -2 * 9.8, 1e-9);
  EXPECT_NEAR(physics->wrench(boom).force.z, 0, 1e-9);
  EXPECT_NEAR(length(physics->wrench(boom).torque), 0, 1e-9);
}

TEST(SimulatorForces, AMotorHoldsAnArm) {
  const auto physics = physics_of({arm(JointType::kRevolute, {})});
  const LinkHandle boom = physics->link("arm", "boom");
  physics->watch_wrench(boom);
  physics->set_motor(physics->joint("arm", "shoulder"), 0, 100);
  run(*physics, 500);
  EXPECT_NEAR(physics->wrench(boom).force.z, 2 * 9.8, 0.01);
  EXPECT_NEAR(physics->wrench(boom).torque.y, -9.8, 0.01);
  EXPECT_NEAR(physics->effort(physics->joint("arm", "shoulder")), -9.8, 0.01);
}

TEST(SimulatorForces, AFreeBodyIsCarriedByNothing) {
  const auto physics = physics_of({model_of("stone", link_of("body", 2, Sphere{0.1}), {0, 0, 9})});
  const LinkHandle body = physics->link("stone", "body");
  physics->watch_wrench(body);
  run(*physics, 100);
  EXPECT_NEAR(length(physics->wrench(body).force), 0, 1e-9);
}

TEST(SimulatorForces, ShapesNearAPointAreFound) {
  const auto physics = physics_of({model_of("box", link_of("body", 2, Box{{2, 2, 2}}), {3, 0, 5}),
                                   model_of("ball", link_of("body", 2, Sphere{0.5}), {-3, 0, 5})});
  const auto is_near = [&](double x, double distance, const char* without) {
    return physics->is_near({x, 0, 5}, distance, RaySees::kCollisions,
                            physics->link(without, "body"));
  };
  EXPECT_TRUE(is_near(1.5, 0.51, "ball"));
  EXPECT_FALSE(is_near(1.5, 0.49, "ball"));
  EXPECT_FALSE(is_near(1.5, 0.51, "box"));
  EXPECT_TRUE(is_near(-2, 0.51, "box"));
  EXPECT_FALSE(is_near(-2, 0.49, "box"));
  EXPECT_TRUE(is_near(3, 0, "ball"));  // inside
  EXPECT_FALSE(physics->is_near({3, 0, 5}, 1, RaySees::kVisuals, {}));
}

}  // namespace
}  // namespace ros2wasm_sim
