// The remarks of the simulator on models that are probably wrong, and that it says nothing about
// others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "checks/model_checks.hpp"
#include "checks/plugin_checks.hpp"
#include "checks/real_time.hpp"
#include "checks/shape_extent.hpp"
#include "sdf_texts.hpp"

namespace ros2wasm_sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Model robot(const std::string& inside, const std::string& pose = "0 0 0.05 0 0 0") {
  const auto read =
      read_model(sdf_texts::model_text("<pose>" + pose + "</pose>" + inside), "robot", {});
  EXPECT_TRUE(read.value.has_value()) << sdf_texts::said(read.notes);
  return read.value.value_or(Model());
}

std::string inertial(double mass, double moment) {
  const std::string m = std::to_string(moment);
  return "<inertial><mass>" + std::to_string(mass) + "</mass><inertia><ixx>" + m + "</ixx><iyy>" +
         m + "</iyy><izz>" + m + "</izz></inertia></inertial>";
}

std::string box_link(const std::string& inside) {
  return "<link name='base'>" + inside +
         "<collision name='c'><geometry><box><size>0.3 0.2 0.1</size></box></geometry></collision>"
         "</link>";
}

/// Wheels of 5 cm, at y = 0.15 and -0.15.
std::string wheel(const std::string& side, double y, const std::string& axis,
                  const std::string& shape =
                      "<cylinder><radius>0.05</radius><length>0.03</length>"
                      "</cylinder>") {
  const std::string collision =
      shape.empty() ? "" : "<collision name='c'><geometry>" + shape + "</geometry></collision>";
  return "<link name='" + side + "_wheel'><pose>0 " + std::to_string(y) +
         " 0 -1.5707963 0 0</pose>" + inertial(0.2, 0.0002) + collision + "</link><joint name='" +
         side + "_joint' type='revolute'><parent>base</parent><child>" + side +
         "_wheel</child><axis><xyz expressed_in='__model__'>" + axis + "</xyz></axis></joint>";
}

const std::string kBase = box_link(inertial(2.5, 0.02));
const DrivenWheels kWheels{{"left_joint"}, {"right_joint"}, 0.3, 0.05};

TEST(SimulatorChecks, ExtentsOfShapes) {
  const Quaternion turned = from_roll_pitch_yaw(0, std::acos(-1) / 4, 0);
  const Vector3 down{0, 0, -1};
  const double diagonal = std::sqrt(0.5);
  EXPECT_NEAR(*extent(Box{{2, 4, 6}}, {}, down), 3, 1e-12);
  EXPECT_NEAR(*extent(Box{{2, 4, 6}}, turned, down), (1 + 3) * diagonal, 1e-12);
  EXPECT_NEAR(*extent(Cylinder{1, 6}, turned, down), (1 + 3) * diagonal, 1e-12);
  EXPECT_NEAR(*extent(Capsule{1, 6}, turned, down), 1 + 3 * diagonal, 1e-12);
  EXPECT_NEAR(*extent(Sphere{2}, turned, down), 2, 1e-12);
  EXPECT_NEAR(*extent(Ellipsoid{{3, 1, 4}}, turned, down), 5 * diagonal, 1e-12);
  EXPECT_FALSE(extent(Plane{}, {}, down));
}

TEST(SimulatorChecks, MomentsThatABodyOfThisSizeCannotHave) {
  EXPECT_FALSE(inertia_remark(robot(box_link(inertial(2.5, 0.02)))));
  // 2.5/12 (0.3^2 + 0.2^2) = 0.0271.
  EXPECT_FALSE(inertia_remark(robot(box_link(inertial(2.5, 0.0271 * 900)))));
  EXPECT_THAT(*inertia_remark(robot(box_link(inertial(2.5, 30)))),
              HasSubstr("[base] of [m] has a moment of inertia of 30 kg m^2, but a body of 2.5 kg "
                        "and 0.3 x 0.2 x 0.1 m has about 0.0271 kg m^2"));
  EXPECT_TRUE(inertia_remark(robot(box_link(inertial(2.5, 0.00002)))));
  // The default for a small link: 0.1/12 * 0.13 = 0.00108.
  EXPECT_THAT(*inertia_remark(robot(box_link(inertial(0.1, 1)))), HasSubstr("is the default"));
  EXPECT_FALSE(inertia_remark(robot("<static>true</static>" + box_link(inertial(0.1, 1)))));
  EXPECT_FALSE(inertia_remark(robot("<link name='sensor'/>")));
}

TEST(SimulatorChecks, RobotsThatBeginInTheGround) {
  World world;
  EXPECT_FALSE(ground_height(world));
  world = sdf_texts::world_of(
      "<model name='g'><static>true</static><pose>0 0 0.2 0 0 0</pose><link name='l'><collision "
      "name='c'><geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link>"
      "</model>");
  ASSERT_TRUE(ground_height(world));
  EXPECT_NEAR(*ground_height(world), 0.2, 1e-12);
  const std::string parts = kBase + wheel("left", 0.15, "0 1 0") + wheel("right", -0.15, "0 1 0");
  EXPECT_FALSE(height_remark(robot(parts), 0));
  EXPECT_FALSE(height_remark(robot(parts, "0 0 0.035 0 0 0"), 0));
  EXPECT_THAT(*height_remark(robot(parts, "0 0 0 0 0 0"), 0.2),
              HasSubstr("is 0.25 m below it. Spawn it at z = 0.25 or higher"));
  EXPECT_FALSE(height_remark(robot(kBase, "0 0 0 0 0 0"), 0.2)) << "a box is not a robot";
}

TEST(SimulatorChecks, WheelsAsTheyShouldBe) {
  const Model right = robot(kBase + wheel("left", 0.15, "0 1 0") + wheel("right", -0.15, "0 1 0"));
  EXPECT_THAT(wheel_remarks(right, kWheels), IsEmpty());
  // A robot that looks along -x.
  const Model back = robot(kBase + wheel("left", -0.15, "0 -1 0") + wheel("right", 0.15, "0 -1 0"));
  EXPECT_THAT(wheel_remarks(back, kWheels), IsEmpty());
}

TEST(SimulatorChecks, WheelsThatTurnTheWrongWay) {
  const Model opposite =
      robot(kBase + wheel("left", 0.15, "0 1 0") + wheel("right", -0.15, "0 -1 0"));
  EXPECT_THAT(wheel_remarks(opposite, kWheels), ElementsAre(HasSubstr("opposite directions")));
  const Model backwards =
      robot(kBase + wheel("left", 0.15, "0 -1 0") + wheel("right", -0.15, "0 -1 0"));
  EXPECT_THAT(wheel_remarks(backwards, kWheels), ElementsAre(HasSubstr("it drives backwards")));
  const Model exchanged =
      robot(kBase + wheel("left", -0.15, "0 1 0") + wheel("right", 0.15, "0 1 0"));
  EXPECT_THAT(wheel_remarks(exchanged, kWheels), ElementsAre(HasSubstr("is on the right side")));
}

TEST(SimulatorChecks, WheelsOfAnotherSize) {
  const Model model = robot(kBase + wheel("left", 0.15, "0 1 0") + wheel("right", -0.15, "0 1 0"));
  DrivenWheels given = kWheels;
  given.separation = 0.32;
  EXPECT_THAT(wheel_remarks(model, given), IsEmpty());
  given.separation = 0.2;
  given.radius = 0.1;
  EXPECT_THAT(wheel_remarks(model, given),
              ElementsAre(HasSubstr("<wheel_separation> of [m] is 0.2 m, but its wheels are 0.3 m"),
                          HasSubstr("<wheel_radius> of [m] is 0.1 m, but the collision of its "
                                    "wheel has 0.05 m")));
  given.separation = 0.3;
  given.writes_diameter = true;
  EXPECT_THAT(wheel_remarks(model, given),
              ElementsAre(HasSubstr("<wheel_diameter> of [m] is 0.2 m, but the collision of its "
                                    "wheel has 0.1 m")));
  const Model bare =
      robot(kBase + wheel("left", 0.15, "0 1 0", "") + wheel("right", -0.15, "0 1 0"));
  EXPECT_THAT(wheel_remarks(bare, kWheels),
              ElementsAre(HasSubstr("[left_wheel] of [m] has no <collision>")));
}

TEST(SimulatorChecks, NearestJoint) {
  const Model model = robot(kBase + wheel("left", 0.15, "0 1 0"));
  EXPECT_EQ(nearest_joint(model, "left_wheel_joint"), "; the nearest joint is [left_joint]");
  EXPECT_EQ(nearest_joint(model, "zzz"), "");
}

TEST(SimulatorChecks, PluginsOfOtherSimulators) {
  EXPECT_THAT(successor_of("gazebo_ros_laser", true), HasSubstr("libgazebo_ros_ray_sensor.so"));
  EXPECT_THAT(successor_of("gazebo_ros_control", true), HasSubstr("libgazebo_ros2_control.so"));
  EXPECT_THAT(
      successor_of("gazebo_ros_diff_drive", false),
      HasSubstr("filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\""));
  EXPECT_THAT(successor_of("gazebo_ros_imu_sensor", false), HasSubstr("<sensor type=\"imu\">"));
  EXPECT_THAT(successor_of("DiffDrive", true), HasSubstr("libgazebo_ros_diff_drive.so"));
  EXPECT_EQ(successor_of("smoke_machine", true), "");
  EXPECT_EQ(successor_of("smoke_machine", false), "");
}

TEST(SimulatorChecks, ElementsThatNobodyReads) {
  const auto remarks_on = [](const std::string& name, const std::string& elements) {
    const Model model = robot(box_link(inertial(1, 0.01)) + "<plugin name='p' filename='f'>" +
                              elements + "</plugin>");
    return unread_elements(name, Parameters(model.plugins.front().xml));
  };
  EXPECT_THAT(remarks_on("gazebo_ros_diff_drive",
                         "<command_topic>robot/cmd_vel</command_topic><left_joint>l</left_joint>"
                         "<odometry_topic>/odom</odometry_topic>"),
              ElementsAre(HasSubstr("<command_topic> is not read by this plugin: write "
                                    "<ros><remapping>cmd_vel:=NAME</remapping></ros>")));
  EXPECT_THAT(remarks_on("gazebo_ros_diff_drive", "<command_topic>cmd_vel</command_topic>"),
              IsEmpty());
  EXPECT_THAT(remarks_on("DiffDrive", "<odom_publisher_frequency>30</odom_publisher_frequency>"),
              ElementsAre(HasSubstr("write <odom_publish_frequency> in its place")));
}

TEST(SimulatorChecks, WhetherTheSimulationKeepsUp) {
  constexpr std::int64_t kTick = 4'000'000;
  const auto first_slow = [](RealTimeWatch& watch, double factor, double wanted, int ticks) {
    for (int i = 1; i <= ticks; ++i)
      if (watch.add(kTick, static_cast<std::int64_t>(factor * kTick), wanted)) return i;
    return 0;
  };
  RealTimeWatch fast, slow, halved, held;
  EXPECT_EQ(first_slow(fast, 0.95, 1, 10'000), 0);
  EXPECT_EQ(first_slow(slow, 0.5, 1, 10'000), 1250) << "5 s of ticks";
  EXPECT_EQ(first_slow(slow, 0.5, 1, 10'000), 0) << "once";
  EXPECT_EQ(first_slow(halved, 0.5, 0.5, 10'000), 0) << "the world asks for half of real time";
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(held.add(1'000'000'000, 100'000'000, 1));
  EXPECT_EQ(first_slow(held, 1, 1, 10'000), 0) << "a page that was hidden";
}

TEST(SimulatorChecks, WhatAWorldCosts) {
  const World world = sdf_texts::world_of(
      "<model name='m'><link name='l'>"
      "<sensor name='a' type='camera'><update_rate>10</update_rate><camera><image><width>640"
      "</width><height>480</height></image></camera></sensor>"
      "<sensor name='b' type='gpu_lidar'><update_rate>10</update_rate><lidar><scan><horizontal>"
      "<samples>360</samples></horizontal></scan></lidar></sensor></link></model>");
  EXPECT_EQ(costs_of(world),
            "1 camera (3072000 pixels a second), 1 lidar (3600 rays a second), 1 moving link, "
            "0 mesh collisions");
}

}  // namespace
}  // namespace ros2wasm_sim
