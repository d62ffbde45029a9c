// Forces, drives and controllers of the simulator against the formulas that they follow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "physics/physics.hpp"
#include "plugins/ackermann.hpp"
#include "plugins/mecanum.hpp"
#include "plugins/pid.hpp"
#include "plugins/trajectory_player.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

Link part(const std::string& name, double mass, const Vector3& position) {
  Link link;
  link.name = name;
  link.pose.position = position;
  link.inertial.mass = mass;
  link.inertial.ixx = link.inertial.iyy = link.inertial.izz = 0.1;
  return link;
}

Collision shaped(const Geometry& geometry) {
  Collision shape;
  shape.name = "shape";
  shape.geometry = geometry;
  return shape;
}

Model model_of(const std::string& name, std::vector<Link> links, std::vector<Joint> joints = {}) {
  Model model;
  model.name = name;
  model.links = std::move(links);
  model.joints = std::move(joints);
  return model;
}

Joint hinge(const std::string& name, const std::string& parent, const std::string& child,
            const Vector3& axis) {
  Joint joint;
  joint.name = name;
  joint.type = JointType::kRevolute;
  joint.parent = parent;
  joint.child = child;
  joint.axes.push_back({});
  joint.axes.front().xyz = axis;
  return joint;
}

TEST(SimulatorForces, AForceAtTheCentreOfMassGivesAnAccelerationOfForceByMass) {
  const auto physics = physics_of({model_of("puck", {part("link", 2, {})})}, {});
  const LinkHandle link = physics->link("puck", "link");
  for (int i = 0; i < 500; ++i) {
    physics->add_wrench(link, {3, 0, 0}, {}, physics->centre_of_mass(link));
    physics->step();
  }
  EXPECT_NEAR(physics->velocity(link).linear.x, 3 / 2.0 * 0.5, 1e-9);
  EXPECT_NEAR(physics->velocity(link).angular.z, 0, 1e-12);
  run(*physics, 500);  // a force is of one step only
  EXPECT_NEAR(physics->velocity(link).linear.x, 0.75, 1e-9);
}

TEST(SimulatorForces, AForceBesideTheCentreTurnsByItsLever) {
  const auto physics = physics_of({model_of("puck", {part("link", 2, {})})}, {});
  const LinkHandle link = physics->link("puck", "link");
  physics->add_wrench(link, {0, 3, 0}, {0, 0, 1}, {0.5, 0, 0});
  physics->step();
  EXPECT_NEAR(physics->velocity(link).angular.z, (0.5 * 3 + 1) / 0.1 * 0.001, 1e-6);
}

/// A weightless flywheel of 0.1 kg m^2 about z on a base that is fixed.
Model flywheel(double limit) {
  Model model =
      model_of("wheel", {part("rotor", 1, {})}, {hinge("axle", "world", "rotor", {0, 0, 1})});
  model.joints.front().axes.front().effort = limit;
  return model;
}

TEST(SimulatorForces, AnEffortAcceleratesAJointByItsInertiaAndIsLimited) {
  const double inertia = 0.1 + 1e-4;  // and that of the joint itself
  for (const auto& [limit, felt] : {std::pair{kInfinity, 0.5}, {0.2, 0.2}, {-1.0, 0.5}}) {
    const auto physics = physics_of({flywheel(limit)}, {});
    const JointHandle axle = physics->joint("wheel", "axle");
    for (int i = 0; i < 100; ++i) {
      physics->add_effort(axle, 0.5);
      physics->step();
    }
    EXPECT_NEAR(physics->velocity(axle), felt / inertia * 0.1, 1e-6);
    EXPECT_NEAR(physics->effort(axle), felt, 1e-12);
    run(*physics, 1);
    EXPECT_EQ(physics->effort(axle), 0);
  }
}

TEST(SimulatorForces, AVelocityIsExactAndAMotorLetsGo) {
  const auto physics = physics_of({flywheel(kInfinity)}, {});
  const JointHandle axle = physics->joint("wheel", "axle");
  physics->set_velocity(axle, 3);
  run(*physics, 1000);
  EXPECT_NEAR(physics->velocity(axle), 3, 1e-9);
  EXPECT_NEAR(physics->position(axle), 3, 0.01);
  physics->set_motor(axle, -1, 1000);
  run(*physics, 100);
  EXPECT_NEAR(physics->velocity(axle), -1, 1e-3);
  physics->release_motor(axle);
  physics->set_velocity(axle, 2);
  run(*physics, 100);
  EXPECT_NEAR(physics->velocity(axle), 2, 1e-9);
}

TEST(SimulatorForces, CommandsThatAreNotFiniteAreIgnored) {
  const auto physics = physics_of({flywheel(kInfinity)}, {});
  const JointHandle axle = physics->joint("wheel", "axle");
  const LinkHandle rotor = physics->link("wheel", "rotor");
  for (const double wrong : {std::nan(""), kInfinity, -kInfinity}) {
    physics->add_effort(axle, wrong);
    physics->set_velocity(axle, wrong);
    physics->set_position(axle, wrong);
    physics->set_motor(axle, wrong, 1);
    physics->add_wrench(rotor, {wrong, 0, 0}, {}, {});
    physics->add_wrench(rotor, {}, {0, 0, wrong}, {});
    physics->step();
  }
  EXPECT_EQ(physics->position(axle), 0);
  EXPECT_EQ(physics->velocity(axle), 0);
}

TEST(SimulatorForces, AttachedLinksFallTogetherAndDetachedOnesApart) {
  Model post = model_of("post", {part("link", 1, {0, 0, 5})});
  post.is_static = true;
  const auto physics =
      physics_of({post, model_of("load", {part("link", 1, {0.5, 0, 5})})}, {0, 0, -9.8});
  const LinkHandle holder = physics->link("post", "link"), load = physics->link("load", "link");
  ASSERT_TRUE(physics->attach(holder, load));
  run(*physics, 1000);
  EXPECT_NEAR(physics->pose(load).position.z, 5, 0.005);
  EXPECT_NEAR(physics->pose(load).position.x, 0.5, 0.005);
  physics->detach(holder, load);
  run(*physics, 1000);
  EXPECT_NEAR(physics->pose(load).position.z, 5 - 4.9, 0.02);
}

/// A plate on four wheels of 10 cm whose centres are half of `size` away from the middle.
Model cart(const MecanumSize& size, bool has_rollers) {
  Model model = model_of("cart", {part("plate", 5, {0, 0, 0.1})});
  struct Corner {
    const char* name;
    double front, left;
  };
  for (const Corner& corner : {Corner{"front_left", 1, 1}, Corner{"front_right", 1, -1},
                               Corner{"back_left", -1, 1}, Corner{"back_right", -1, -1}}) {
    Link wheel = part(corner.name, 0.3,
                      {corner.front * size.wheel_base / 2, corner.left * size.wheel_separation / 2,
                       size.wheel_radius});
    wheel.inertial.ixx = wheel.inertial.iyy = wheel.inertial.izz = 0.001;
    Collision tyre = shaped(Cylinder{size.wheel_radius, 0.04});
    tyre.pose.orientation = from_roll_pitch_yaw(kPi / 2, 0, 0);
    if (has_rollers) {
      tyre.surface.mu2 = 0;
      tyre.surface.fdir1 = {1, -corner.front * corner.left, 0};
      tyre.surface.fdir1_frame = "plate";
    }
    wheel.collisions.push_back(tyre);
    model.links.push_back(wheel);
    model.joints.push_back(
        hinge(std::string(corner.name) + "_joint", "plate", corner.name, {0, 1, 0}));
  }
  return model;
}

TEST(SimulatorForces, MecanumWheelsMoveACartSidewaysAndPlainWheelsDoNot) {
  const MecanumSize size{0.4, 0.5, 0.1};
  for (const bool has_rollers : {true, false}) {
    const auto physics = physics_of({ground(), cart(size, has_rollers)}, {0, 0, -9.8});
    run(*physics, 500);
    const LinkHandle plate = physics->link("cart", "plate");
    const Pose start = physics->pose(plate);
    for (int i = 0; i < 2500; ++i) {  // 0.5 s of acceleration: the distance is that of 2.25 s
      const double part = std::min(1.0, i / 500.0);
      const MecanumWheels speeds = mecanum_wheels(size, {0.1 * part, 0.2 * part, 0});
      const auto drive = [&](const char* joint, double speed) {
        physics->set_motor(physics->joint("cart", joint), speed, 100);
      };
      drive("front_left_joint", speeds.front_left);
      drive("front_right_joint", speeds.front_right);
      drive("back_left_joint", speeds.back_left);
      drive("back_right_joint", speeds.back_right);
      physics->step();
    }
    const Vector3 way = physics->pose(plate).position - start.position;
    if (has_rollers) {
      EXPECT_NEAR(way.x, 0.225, 0.0045);
      EXPECT_NEAR(way.y, 0.45, 0.009);
      EXPECT_NEAR(yaw_of(physics->pose(plate).orientation), 0, 0.01);
    } else {
      EXPECT_LT(way.y, 0.1);  // they scrub instead
    }
  }
}

TEST(SimulatorDrives, APidFollowsItsFormulaAndItsLimits) {
  PidSettings settings;
  settings.p = 2;
  settings.i = 10;
  settings.d = 0.1;
  settings.offset = 0.5;
  Pid pid(settings);
  EXPECT_DOUBLE_EQ(pid.update(1, 0.1), 0.5 - 2 * 1 - 10 * 0.1 * 1 - 0.1 * 1 / 0.1);
  EXPECT_DOUBLE_EQ(pid.update(3, 0.1), 0.5 - 2 * 3 - 10 * 0.1 * (1 + 3) - 0.1 * (3 - 1) / 0.1);
  EXPECT_EQ(pid.update(std::nan(""), 0.1), 0);
  EXPECT_EQ(pid.update(1, 0), 0);
  pid.reset();
  EXPECT_DOUBLE_EQ(pid.update(1, 0.1), 0.5 - 2 - 1 - 1);
  settings.i_max = 0.3;
  settings.i_min = -0.3;
  Pid gentle(settings);
  EXPECT_DOUBLE_EQ(gentle.update(1, 0.1), 0.5 - 2 - 0.3 - 1);
  settings.command_max = 1;
  settings.command_min = -1;
  Pid weak(settings);
  EXPECT_EQ(weak.update(100, 0.1), -1);
}

TEST(SimulatorDrives, ACarTurnsAboutOnePoint) {
  const CarSize car{1.2, 1.0, 2.0, 0.3, 0.6};
  const CarCommand command = car_command(car, 1.5, 0.25);
  // Both front wheels are at right angles to the line to the point 6 m left of the rear axle.
  EXPECT_NEAR(std::tan(command.steering.left), 2.0 / (6 - 0.5), 1e-12);
  EXPECT_NEAR(std::tan(command.steering.right), 2.0 / (6 + 0.5), 1e-12);
  EXPECT_NEAR(command.left_speed, 0.25 * (6 - 0.6) / 0.3, 1e-12);
  EXPECT_NEAR(command.right_speed, 0.25 * (6 + 0.6) / 0.3, 1e-12);
  EXPECT_NEAR(car_command(car, 1.5, 0).steering.left, 0, 1e-8);
  const double tightest = 2.0 / std::sin(0.6);
  EXPECT_NEAR(std::tan(car_command(car, 0.1, -5).steering.left), 2.0 / (-tightest - 0.5), 1e-12);
  // The wheel in the middle is on a circle of 2 / tan(0.3) about the same point.
  const SteeringAngles classic = steering_of_middle(0.3, 1.0, 2.0);
  EXPECT_NEAR(std::tan(classic.left), 2.0 / (2 / std::tan(0.3) - 0.5), 1e-12);
  EXPECT_NEAR(std::tan(classic.right), 2.0 / (2 / std::tan(0.3) + 0.5), 1e-12);
}

TEST(SimulatorDrives, TheOdometryOfACarIsACircle) {
  const CarSize car{1.2, 1.0, 2.0, 0.3, 0.6};
  CarOdometry odometry(car);
  const double angle = std::atan(2.0 / 6);
  const int steps = 20000;  // half a circle of 6 m
  for (int i = 0; i <= steps; ++i) {
    const double rolled = 6 * kPi / 0.3 * i / steps;
    odometry.update(rolled, rolled, {angle, angle}, 0.001);
  }
  EXPECT_NEAR(odometry.pose().position.x, 0, 0.01);
  EXPECT_NEAR(odometry.pose().position.y, 12, 0.01);
  EXPECT_NEAR(odometry.forward_speed, 6 * kPi / 20, 1e-6);
  EXPECT_NEAR(odometry.turn_speed, kPi / 20, 1e-6);
}

TEST(SimulatorDrives, MecanumWheelsAndTheirMotionBelongTogether) {
  const MecanumSize size{0.4, 0.6, 0.1};
  const MecanumWheels wheels = mecanum_wheels(size, {1, 2, 3});
  EXPECT_DOUBLE_EQ(wheels.front_left, (1 - 2 - 0.5 * 3) / 0.1);
  EXPECT_DOUBLE_EQ(wheels.back_right, (1 - 2 + 0.5 * 3) / 0.1);
  const PlanarMotion motion = mecanum_motion(size, wheels);
  EXPECT_NEAR(motion.forward, 1, 1e-12);
  EXPECT_NEAR(motion.left, 2, 1e-12);
  EXPECT_NEAR(motion.turn, 3, 1e-12);
  MecanumOdometry odometry(size);
  for (int i = 0; i <= 1000; ++i) {  // a quarter of a circle, sideways
    const MecanumWheels speed = mecanum_wheels(size, {0, kPi / 2, kPi / 2});
    const double t = i * 0.001;
    odometry.update(
        {speed.front_left * t, speed.front_right * t, speed.back_left * t, speed.back_right * t},
        0.001);
  }
  EXPECT_NEAR(odometry.pose().position.x, -1, 1e-6);
  EXPECT_NEAR(odometry.pose().position.y, 1, 1e-6);
  EXPECT_NEAR(odometry.speed.left, kPi / 2, 1e-9);
}

TEST(SimulatorDrives, APointOfATrajectoryHoldsUntilItsTimeHasPassed) {
  TrajectoryPlayer player;
  EXPECT_TRUE(player.is_over());
  player.begin({100, 300}, 1000);
  EXPECT_FALSE(player.advance(900));
  EXPECT_TRUE(player.advance(1000));
  EXPECT_EQ(player.point(), 0U);
  EXPECT_FALSE(player.advance(1100));
  EXPECT_TRUE(player.advance(1101));
  EXPECT_EQ(player.point(), 1U);
  EXPECT_EQ(player.progress(), 0.5);
  EXPECT_TRUE(player.advance(1301));
  EXPECT_TRUE(player.is_over());
  EXPECT_EQ(player.progress(), 1);
  EXPECT_FALSE(player.advance(5000));
}

}  // namespace
}  // namespace ros2wasm_sim
