// Sensors of the simulator against their formulas: positions on the ellipsoid of the earth,
// heights, pressures, magnetic fields, wrenches and contacts.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "physics/physics.hpp"
#include "sdf/read_sdf.hpp"
#include "sensors/altimeter.hpp"
#include "sensors/contact_sensor.hpp"
#include "sensors/force_torque.hpp"
#include "sensors/geographic.hpp"
#include "sensors/magnetometer.hpp"
#include "sensors/navsat.hpp"
#include "simulator_worlds.hpp"

namespace ros2wasm_sim {
namespace {

constexpr double kDegree = kPi / 180;

Model ball(const std::string& name, const Vector3& position, bool is_static) {
  Model model;
  model.name = name;
  model.pose.position = position;
  model.is_static = is_static;
  Link link;
  link.name = "body";
  Collision shape;
  shape.name = "shell";
  shape.geometry = Sphere{0.1};
  link.collisions.push_back(shape);
  model.links.push_back(link);
  return model;
}

Sensor sensor_of(const std::string& type, const std::string& elements) {
  Sensor sensor;
  sensor.name = "sensor";
  sensor.type = type;
  const auto document = std::make_shared<const ros2wasm_xml::XmlDocument>(
      "<sensor type=\"" + type + "\">" + elements + "</sensor>");
  sensor.xml = {document, &document->root()};
  return sensor;
}

/// Metres from the centre of the earth, by the definition of geodetic coordinates.
Vector3 earth_point(const Geographic& at) {
  const double a = 6378137.0, e2 = 6.69437999014e-3;
  const double lat = at.latitude_deg * kDegree, lon = at.longitude_deg * kDegree;
  const double n = a / std::sqrt(1 - e2 * std::sin(lat) * std::sin(lat));
  return {(n + at.altitude) * std::cos(lat) * std::cos(lon),
          (n + at.altitude) * std::cos(lat) * std::sin(lon),
          (n * (1 - e2) + at.altitude) * std::sin(lat)};
}

/// East, north and up of a point, seen from another one.
Vector3 seen_from(const Geographic& origin, const Geographic& at) {
  const double lat = origin.latitude_deg * kDegree, lon = origin.longitude_deg * kDegree;
  const Vector3 d = earth_point(at) - earth_point(origin);
  const Vector3 east{-std::sin(lon), std::cos(lon), 0};
  const Vector3 up{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
  return {dot(east, d), dot(cross(up, east), d), dot(up, d)};
}

TEST(SimulatorSensors, MetresAreDegreesOfTheEllipsoid) {
  for (const double latitude : {47.4, -33.9, 0.0, 69.6}) {
    const Geographic origin{latitude, 8.5, 400};
    const TangentPlane plane({latitude, 8.5, 400, 0}, Heading::kSim);
    for (const Vector3 offset : {Vector3{0.009, 0.0133, 30}, Vector3{-0.009, 0, -10}, Vector3{}}) {
      const Geographic target{latitude + offset.x, 8.5 + offset.y, 400 + offset.z};
      const Geographic found = plane.position(seen_from(origin, target));
      EXPECT_NEAR(found.latitude_deg, target.latitude_deg, 1e-9);
      EXPECT_NEAR(found.longitude_deg, target.longitude_deg, 1e-9);
      EXPECT_NEAR(found.altitude, target.altitude, 1e-4);
    }
  }
  // 100 m north are 100 m by the radius of the meridian, 6378137 (1 - e^2) at the equator.
  const TangentPlane equator({0, 0, 0, 0}, Heading::kSim);
  EXPECT_NEAR(equator.position({0, 100, 0}).latitude_deg, 100 / 6335439.327 / kDegree, 1e-9);
  EXPECT_NEAR(equator.position({100, 0, 0}).longitude_deg, 100 / 6378137.0 / kDegree, 1e-9);
}

TEST(SimulatorSensors, TheHeadingTurnsTheWorld) {
  const auto east_north = [](double heading_deg, Heading heading, const Vector3& local) {
    return TangentPlane({10, 20, 0, heading_deg}, heading).east_north_up(local);
  };
  const auto near = [](const Vector3& v, double east, double north) {
    EXPECT_NEAR(v.x, east, 1e-12);
    EXPECT_NEAR(v.y, north, 1e-12);
  };
  near(east_north(0, Heading::kSim, {1, 2, 3}), 1, 2);
  near(east_north(90, Heading::kSim, {1, 0, 0}), 0, 1);
  near(east_north(90, Heading::kSim, {0, 1, 0}), -1, 0);
  near(east_north(180, Heading::kClassic, {1, 2, 3}), 1, 2);
  near(east_north(0, Heading::kClassic, {1, 0, 0}), -1, 0);
  near(east_north(90, Heading::kClassic, {1, 0, 0}), 0, 1);
}

TEST(SimulatorSensors, AReceiverHasNoiseInTheUnitsOfItsSimulator) {
  const auto physics = physics_of({ball("drone", {30, 40, 5}, false)});
  const std::string noise = "<noise type=\"gaussian\"><mean>0.25</mean></noise>";
  const Sensor exact = sensor_of("navsat", "");
  const Sensor shifted = sensor_of(
      "navsat", "<navsat><position_sensing><horizontal>" + noise + "</horizontal><vertical>" +
                    noise + "</vertical></position_sensing><velocity_sensing><vertical>" + noise +
                    "</vertical></velocity_sensing></navsat>");
  const SphericalCoordinates origin{47, 8, 100, 0}, classic_origin{47, 8, 100, 180};
  const auto at = [&](const Sensor& sensor, const SphericalCoordinates& where, Heading heading) {
    return NavSat(sensor, *physics, "drone", "body", where, heading, 1).position();
  };
  const Geographic truth = at(exact, origin, Heading::kSim);
  EXPECT_NEAR(truth.altitude, 105, 1e-3);
  const Geographic degrees = at(shifted, origin, Heading::kSim);
  EXPECT_NEAR(degrees.latitude_deg - truth.latitude_deg, 0.25, 1e-12);
  EXPECT_NEAR(degrees.longitude_deg - truth.longitude_deg, 0.25, 1e-12);
  EXPECT_NEAR(degrees.altitude - truth.altitude, 0.25, 1e-9);
  const Geographic metres = at(shifted, classic_origin, Heading::kClassic);
  const Geographic expected = TangentPlane(origin, Heading::kSim).position({30.25, 40.25, 5.25});
  EXPECT_NEAR(metres.latitude_deg, expected.latitude_deg, 1e-12);
  EXPECT_NEAR(metres.longitude_deg, expected.longitude_deg, 1e-12);
  for (int i = 0; i < 100; ++i) physics->step();
  NavSat moving(shifted, *physics, "drone", "body", origin, Heading::kSim, 1);
  EXPECT_NEAR(moving.velocity().z, -0.98 + 0.25, 1e-9);
}

TEST(SimulatorSensors, AnAltimeterMeasuresFromWhereItBegan) {
  const auto physics = physics_of({ball("stone", {0, 0, 50}, false)});
  Sensor sensor = sensor_of("altimeter", "");
  sensor.pose.position.z = 0.2;
  Altimeter altimeter(sensor, *physics, "stone", "body", 1);
  EXPECT_NEAR(altimeter.reference(), 50.2, 1e-12);
  EXPECT_NEAR(altimeter.position(), 0, 1e-12);
  for (int i = 0; i < 1000; ++i) physics->step();
  EXPECT_NEAR(altimeter.position(), -4.9, 0.006);
  EXPECT_NEAR(altimeter.velocity(), -9.8, 1e-9);
}

TEST(SimulatorSensors, ASensorBesideTheCentreMovesWithTheRotation) {
  const auto physics = physics_of({ball("disc", {0, 0, 50}, false)});
  physics->set_model_velocity("disc", {{0, 0, 0}, {0, 3, 0}});
  Sensor sensor = sensor_of("altimeter", "");
  sensor.pose.position.x = 0.5;
  Altimeter altimeter(sensor, *physics, "disc", "body", 1);
  physics->step();
  EXPECT_NEAR(altimeter.velocity(), -1.5 - 0.0098, 1e-4);  // omega x r, and a step of falling
}

TEST(SimulatorSensors, PressuresAreThoseOfTheStandardAtmosphere) {
  EXPECT_NEAR(standard_pressure(0), 101325, 1e-6);
  EXPECT_NEAR(standard_pressure(1000), 89876, 1);  // tables of 1976
  EXPECT_NEAR(standard_pressure(5000), 54048, 1);
  const auto physics = physics_of({ball("balloon", {0, 0, 600}, true)});
  AirPressure sensor(
      sensor_of("air_pressure",
                "<air_pressure><reference_altitude>400</reference_altitude></air_pressure>"),
      *physics, "balloon", "body", 1);
  EXPECT_NEAR(sensor.measure(), 89876, 1);
}

TEST(SimulatorSensors, AMagneticFieldIsTurnedIntoTheSensor) {
  Model model = ball("compass", {}, true);
  model.pose.orientation = from_roll_pitch_yaw(0, 0, kPi / 2);
  const auto physics = physics_of({model});
  const Vector3 field{1e-6, 2e-6, -4e-5};
  Magnetometer sensor(sensor_of("magnetometer", ""), *physics, "compass", "body", field, 1);
  EXPECT_NEAR(sensor.measure().x, 2e-6, 1e-18);  // its x is the y of the world
  EXPECT_NEAR(sensor.measure().y, -1e-6, 1e-18);
  EXPECT_NEAR(sensor.measure().z, -4e-5, 1e-18);
}

/// A rod of 2 kg, 1 m above the ground on a fixed joint, which is at its end; its centre of mass is
/// 0.5 m along x, which is up.
Model rod() {
  Model model = ball("rod", {0, 0, 1}, false);
  Link& link = model.links.front();
  link.pose.orientation = from_roll_pitch_yaw(0, -kPi / 2, 0);
  link.inertial.mass = 2;
  link.inertial.pose.position.x = 0.5;
  Joint joint;
  joint.name = "foot";
  joint.parent = "world";
  joint.child = "body";
  model.joints.push_back(joint);
  return model;
}

Wrench measured(Physics& physics, const Model& model, const std::string& elements,
                const Pose& pose = {}) {
  Sensor sensor = sensor_of("force_torque", "<force_torque>" + elements + "</force_torque>");
  sensor.pose = pose;
  ForceTorque one(sensor, physics, model.name, model.joints.front(), 1);
  physics.step();
  return one.measure();
}

TEST(SimulatorSensors, AForceTorqueSensorHasTheFrameAndDirectionOfItsElement) {
  const Model model = rod();
  const auto physics = physics_of({model});
  constexpr double kWeight = 2 * 9.8;
  // By default how the child acts on its parent, along the child's axes: x is up.
  EXPECT_NEAR(measured(*physics, model, "").force.x, -kWeight, 1e-9);
  EXPECT_NEAR(
      measured(*physics, model, "<measure_direction>parent_to_child</measure_direction>").force.x,
      kWeight, 1e-9);
  EXPECT_NEAR(measured(*physics, model, "<frame>parent</frame>").force.z, -kWeight, 1e-9);
  const Pose turned{{}, from_roll_pitch_yaw(0, 0, kPi / 2)};
  EXPECT_NEAR(measured(*physics, model, "<frame>sensor</frame>", turned).force.y, kWeight, 1e-9);
  EXPECT_NEAR(measured(*physics, model, "<frame>child</frame>", turned).force.x, -kWeight, 1e-9);
  // The weight acts 0.3 m beside a sensor that is 0.3 m along y of the child.
  const Wrench beside = measured(*physics, model, "", {{0, 0.3, 0}, {}});
  EXPECT_NEAR(beside.torque.z, -0.3 * kWeight, 1e-9);
  EXPECT_NEAR(length(measured(*physics, model, "").torque), 0, 1e-9);
}

TEST(SimulatorSensors, AForceTorqueSensorNamesAValueThatDoesNotExist) {
  const Model model = rod();
  const auto physics = physics_of({model});
  const ForceTorque sensor(
      sensor_of("force_torque", "<force_torque><frame>sensors</frame></force_torque>"), *physics,
      "rod", model.joints.front(), 1);
  EXPECT_EQ(sensor.warnings(),
            std::vector<std::string>{"force_torque sensor [sensor]: <frame> [sensors] does not "
                                     "exist, so child counts; values are child, parent, sensor"});
}

TEST(SimulatorSensors, AForceTorqueSensorOfAUrdfMeasuresInItsJoint) {
  const Reading<Model> reading = read_model(
      "<robot name='r'><link name='world'/><link name='tool'><inertial><mass value='4'/>"
      "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link>"
      "<joint name='wrist' type='fixed'><parent link='world'/><child link='tool'/></joint>"
      "<gazebo reference='wrist'><sensor name='s' type='force_torque'/></gazebo></robot>",
      "r.urdf", {});
  ASSERT_TRUE(reading.value);
  const Model& model = *reading.value;
  const auto physics = physics_of({model});
  ASSERT_EQ(model.joints.size(), 1U);
  ForceTorque sensor(model.joints[0].sensors.at(0), *physics, "r", model.joints[0], 1);
  physics->step();
  EXPECT_NEAR(sensor.measure().force.z, -4 * 9.8, 1e-9);
}

TEST(SimulatorSensors, AContactSensorReportsItsOwnCollisionFirst) {
  Model plate = ball("plate", {}, true);
  plate.links.front().collisions.front().geometry = Box{{1, 1, 0.1}};
  const auto physics = physics_of({plate, ball("ball", {0, 0, 0.15}, false)});
  const std::string elements = "<contact><collision>shell</collision></contact>";
  const auto make = [&](const Model& model) {
    return ContactSensor(sensor_of("contact", elements), *physics, model.name, model.links.front());
  };
  const ContactSensor below = make(plate), above = make(ball("ball", {}, false));
  for (int i = 0; i < 1000; ++i) physics->step();
  const auto from_above = above.touching(), from_below = below.touching();
  ASSERT_EQ(from_above.size(), 1U);
  ASSERT_EQ(from_below.size(), 1U);
  EXPECT_EQ(from_above[0].first, "ball::body::shell");
  EXPECT_EQ(from_above[0].second, "plate::body::shell");
  EXPECT_EQ(from_below[0].first, "plate::body::shell");
  EXPECT_NEAR(from_above[0].points.at(0).normal.z, 1, 1e-9);
  EXPECT_NEAR(from_above[0].points.at(0).wrench.force.z, 9.8, 1e-3);  // of 1 kg
  EXPECT_NEAR(from_below[0].points.at(0).normal.z, -1, 1e-9);
  EXPECT_NEAR(from_below[0].points.at(0).wrench.force.z, -9.8, 1e-3);
  EXPECT_TRUE(above.warnings().empty());
}

TEST(SimulatorSensors, AContactSensorNamesTheCollisionThatIsMeant) {
  const Model model = ball("ball", {}, false);
  const auto physics = physics_of({model});
  const auto warnings = [&](const std::string& elements) {
    return ContactSensor(sensor_of("contact", elements), *physics, "ball", model.links.front())
        .warnings();
  };
  EXPECT_EQ(warnings("<contact><collision>shel</collision></contact>"),
            std::vector<std::string>{"contact sensor [sensor]: the link [body] has no collision "
                                     "[shel]: did you mean [shell]?"});
  EXPECT_EQ(warnings("").size(), 1U);
}

TEST(SimulatorSensors, AContactSensorOfALumpedLinkFindsItsCollision) {
  const std::string mass =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/>"
      "</inertial><collision><geometry><sphere radius='0.1'/></geometry></collision>";
  const Reading<Model> reading = read_model(
      "<robot name='r'><link name='base'>" + mass + "</link><link name='bumper'>" + mass +
          "</link><joint name='j' type='fixed'><parent link='base'/><child link='bumper'/></joint>"
          "<gazebo reference='bumper'><sensor name='s' type='contact'><contact>"
          "<collision>bumper_collision</collision></contact></sensor></gazebo></robot>",
      "r.urdf", {});
  ASSERT_TRUE(reading.value);
  const Model& model = *reading.value;
  const auto physics = physics_of({model});
  ASSERT_EQ(model.links.size(), 1U);
  const ContactSensor sensor(model.links[0].sensors.at(0), *physics, "r", model.links[0]);
  EXPECT_TRUE(sensor.warnings().empty());
}

}  // namespace
}  // namespace ros2wasm_sim
