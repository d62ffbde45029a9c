// The parts of controllers below ROS: odometry, limits, rules of parameters, names of joints.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "diff_drive_controller/odometry.hpp"
#include "diff_drive_controller/speed_limiter.hpp"
#include "joint_state_broadcaster/joint_data.hpp"
#include "ros2wasm_parameters/rules.hpp"
#include "steering_controllers_library/steering_kinematics.hpp"

namespace {

using diff_drive_controller::Odometry;
using diff_drive_controller::SpeedLimiter;
using diff_drive_controller::wheel_speeds;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int64_t kCycleNs = 10'000'000;  // 100 Hz
constexpr double kCycle = 0.01;           // [s]

// The robot of the scene: 0.5 m/s and 0.5 rad/s for two seconds is an arc of radius 1 m.
constexpr double kX = 0.8414709848;  // sin(1)
constexpr double kY = 0.4596976941;  // 1 - cos(1)

TEST(DiffDrive, CommandsBothSides) {
  const auto speeds = wheel_speeds(0.5, 0.5, {0.4, 0.05, 0.05});
  EXPECT_NEAR(speeds.left, 8.0, 1e-12);
  EXPECT_NEAR(speeds.right, 12.0, 1e-12);
}

TEST(DiffDrive, OpenLoopDrivesTheArc) {
  Odometry odometry;
  odometry.setWheelParams(0.4, 0.05, 0.05);
  odometry.init(5 * kCycleNs);
  for (int i = 1; i <= 200; ++i) odometry.updateOpenLoop(0.5, 0.5, (5 + i) * kCycleNs);
  EXPECT_NEAR(odometry.getX(), kX, 1e-9);
  EXPECT_NEAR(odometry.getY(), kY, 1e-9);
  EXPECT_NEAR(odometry.getHeading(), 1.0, 1e-9);
  EXPECT_EQ(odometry.getLinear(), 0.5);
  EXPECT_EQ(odometry.getAngular(), 0.5);
}

TEST(DiffDrive, PositionsOfWheelsGiveTheSameArcAndTheMeanSpeed) {
  Odometry odometry(10);
  odometry.setWheelParams(0.4, 0.05, 0.05);
  odometry.init(0);
  for (int i = 1; i <= 200; ++i) {
    EXPECT_TRUE(odometry.update(8.0 * kCycle * i, 12.0 * kCycle * i, i * kCycleNs));
  }
  EXPECT_NEAR(odometry.getX(), kX, 1e-9);
  EXPECT_NEAR(odometry.getY(), kY, 1e-9);
  EXPECT_NEAR(odometry.getLinear(), 0.5, 1e-9);
  EXPECT_NEAR(odometry.getAngular(), 0.5, 1e-9);
  EXPECT_FALSE(odometry.update(20.0, 20.0, 200 * kCycleNs + 99'000)) << "less than 0.1 ms later";
  // The mean of ten: nine at 0.5 m/s, and one standing.
  EXPECT_TRUE(odometry.update(16.0, 24.0, 201 * kCycleNs));
  EXPECT_NEAR(odometry.getLinear(), 0.45, 1e-9);
}

TEST(DiffDrive, SpeedsOfWheelsDriveStraight) {
  Odometry odometry;
  odometry.setWheelParams(0.4, 0.05, 0.05);
  odometry.init(0);
  for (int i = 1; i <= 100; ++i) {
    odometry.updateFromVelocity(10.0 * 0.05 * kCycle, 10.0 * 0.05 * kCycle, i * kCycleNs);
  }
  EXPECT_NEAR(odometry.getX(), 0.5, 1e-9);
  EXPECT_EQ(odometry.getY(), 0.0);
  odometry.resetOdometry();
  EXPECT_EQ(odometry.getX(), 0.0);
}

TEST(DiffDrive, TimeThatIsSetBackIsNoWay) {
  Odometry odometry;
  odometry.setWheelParams(0.4, 0.05, 0.05);
  odometry.init(0);
  for (int i = 1; i <= 100; ++i)
    odometry.update(10.0 * kCycle * i, 10.0 * kCycle * i, i * kCycleNs);
  EXPECT_NEAR(odometry.getX(), 0.5, 1e-9);
  EXPECT_FALSE(odometry.update(0.0, 0.0, kCycleNs)) << "the world was reset";
  EXPECT_TRUE(odometry.update(10.0 * kCycle, 10.0 * kCycle, 2 * kCycleNs));
  EXPECT_NEAR(odometry.getX(), 0.5 + 0.5 * kCycle, 1e-9);
  odometry.updateOpenLoop(0.5, 0.0, kCycleNs);
  odometry.updateOpenLoop(0.5, 0.0, 2 * kCycleNs);
  EXPECT_NEAR(odometry.getX(), 0.5 + kCycle, 1e-9);
}

TEST(SpeedLimiter, LimitsVelocityAndAcceleration) {
  SpeedLimiter limiter(kNan, 1.0, kNan, 2.0, -4.0, kNan, kNan, kNan);
  double v = 3.0;
  EXPECT_DOUBLE_EQ(limiter.limit_velocity(v), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(v, 1.0);
  v = -3.0;
  limiter.limit_velocity(v);
  EXPECT_DOUBLE_EQ(v, -1.0) << "the minimum is minus the maximum";
  v = 1.0;
  limiter.limit(v, 0.0, 0.0, 0.1);
  EXPECT_DOUBLE_EQ(v, 0.2);
  v = 0.0;
  limiter.limit(v, 0.8, 0.8, 0.1);
  EXPECT_DOUBLE_EQ(v, 0.4) << "braking forwards";
  v = 0.0;
  limiter.limit(v, -0.8, -0.8, 0.1);
  EXPECT_DOUBLE_EQ(v, -0.6) << "braking backwards: the acceleration forwards";
}

TEST(SpeedLimiter, LimitsJerkOnlyWhileItGetsFaster) {
  SpeedLimiter limiter(kNan, kNan, kNan, kNan, kNan, kNan, kNan, 10.0);
  double v = 1.0;
  limiter.limit(v, 0.0, 0.0, 0.1);
  EXPECT_NEAR(v, 0.1, 1e-12) << "10 m/s^3 for 0.1 s, for 0.1 s";
  v = 0.0;
  limiter.limit(v, 0.3, 0.1, 0.1);
  EXPECT_NEAR(v, 0.3 + 0.2 - 0.1, 1e-12) << "the change of speed falls by 0.1 at most";
  v = 0.45;
  limiter.limit(v, 0.3, 0.1, 0.1);
  EXPECT_DOUBLE_EQ(v, 0.45) << "slower gain of speed is not limited";
}

TEST(SpeedLimiter, RefusesLimitsThatAreTheWrongWayRound) {
  EXPECT_THROW(SpeedLimiter(2.0, 1.0, kNan, kNan, kNan, kNan, kNan, kNan), std::invalid_argument);
  EXPECT_THROW(SpeedLimiter(kNan, kNan, 3.0, 2.0, kNan, kNan, kNan, kNan), std::invalid_argument);
  EXPECT_THROW(SpeedLimiter(kNan, kNan, kNan, 2.0, 3.0, 1.0, kNan, kNan), std::invalid_argument);
}

using steering_kinematics::SteeringKinematics;

/// A base of 2 m with wheels of 0.5 m that are 1 m apart.
SteeringKinematics steered(unsigned int type) {
  SteeringKinematics base;
  base.set_odometry_type(type);
  base.set_wheel_params(0.5, 2.0, 1.0);
  return base;
}

TEST(Steering, BicycleTurnsItsWheelByTheCurve) {
  const auto base = steered(steering_kinematics::BICYCLE_CONFIG);
  const auto [traction, steering] = base.get_commands(1.0, 0.25);
  EXPECT_NEAR(traction.at(0), 2.0, 1e-12);
  EXPECT_NEAR(steering.at(0), std::atan(0.5), 1e-12);
  EXPECT_EQ(std::get<1>(base.get_commands(0.0, 0.0)).at(0), 0.0) << "standing";
}

TEST(Steering, TricycleDrivesTheOuterWheelFaster) {
  const auto [traction, steering] =
      steered(steering_kinematics::TRICYCLE_CONFIG).get_commands(1.0, 0.25);
  // To the left with a radius of 4 m: the right wheel is on 4.5 m.
  EXPECT_NEAR(traction.at(0), 2.0 * 4.5 / 4.0, 1e-12);
  EXPECT_NEAR(traction.at(1), 2.0 * 3.5 / 4.0, 1e-12);
  EXPECT_EQ(steering.size(), 1u);
}

TEST(Steering, AckermannSteersBothWheelsToOneCentre) {
  auto base = steered(steering_kinematics::ACKERMANN_CONFIG);
  const auto [traction, steering] = base.get_commands(1.0, 0.25);
  EXPECT_NEAR(steering.at(0), std::atan(2.0 / 4.5), 1e-12);
  EXPECT_NEAR(steering.at(1), std::atan(2.0 / 3.5), 1e-12);
  // The states of the wheels give the reference back.
  for (int i = 0; i < 100; ++i) {
    base.update_from_velocity(traction[0], traction[1], steering[0], steering[1], kCycle);
  }
  EXPECT_NEAR(base.get_linear(), 1.0, 1e-9);
  EXPECT_NEAR(base.get_angular(), 0.25, 1e-9);
  EXPECT_NEAR(base.get_heading(), 0.25, 1e-9);
  EXPECT_NEAR(base.get_x(), 4.0 * std::sin(0.25), 1e-9);
  EXPECT_NEAR(base.get_y(), 4.0 * (1.0 - std::cos(0.25)), 1e-9);
}

TEST(Steering, SlowsDownUntilTheWheelIsTurned) {
  auto base = steered(steering_kinematics::BICYCLE_CONFIG);
  base.update_from_position(0.0, 0.0, kCycle);
  const auto [traction, steering] = base.get_commands(1.0, 1.0, false, true);
  const double off = std::atan(2.0);
  EXPECT_NEAR(traction.at(0), 2.0 * std::cos(off) / std::cos(M_PI / 6), 1e-12);
  base.update_from_position(0.0, off, kCycle);
  EXPECT_NEAR(std::get<0>(base.get_commands(1.0, 1.0, false, true)).at(0), 2.0, 1e-12);
}

using Names = std::vector<std::string>;

TEST(ParameterRules, SayWhatIsWrong) {
  using namespace ros2wasm_parameters;
  EXPECT_EQ(gt(0.0).check("wheel_radius", 0.05), "");
  EXPECT_EQ(gt(0.0).check("wheel_radius", 0.0),
            "Parameter 'wheel_radius' with the value '0' must be greater than '0'");
  EXPECT_EQ(gt_eq(0.1).check("rate", 0.05),
            "Parameter 'rate' with the value '0.05' must be greater than or equal to '0.1'");
  EXPECT_EQ(lt_eq_or_nan(0.0).check("min", kNan), "");
  EXPECT_EQ(lt_eq_or_nan(0.0).check("min", 1.5),
            "Parameter 'min' with the value '1.5' must be less than or equal to '0'");
  EXPECT_EQ(bounds(0.0, 1.0).check("share", 2.0),
            "Parameter 'share' with the value '2' must be within bounds '[0, 1]'");
  EXPECT_EQ(not_empty<Names>().check("joints", {}), "Parameter 'joints' cannot be empty");
  EXPECT_EQ(size_gt<Names>(0).check("joints", {}),
            "Length of parameter 'joints' is '0' but must be greater than '0'");
  EXPECT_EQ(fixed_size<Names>(2).check("pair", {"a"}),
            "Length of parameter 'pair' is '1' but must be equal to '2'");
  EXPECT_EQ(unique<Names>().check("joints", {"a", "b", "a"}),
            "Parameter 'joints' must only contain unique values");
  EXPECT_EQ(subset_of({"position", "velocity"}).check("interfaces", {"position", "effort"}),
            "Entry 'effort' in parameter 'interfaces' is not in the set '{position, velocity}'");
  EXPECT_EQ(one_of({"splines", "none"}).check("method", "cubic"),
            "Parameter 'method' with the value 'cubic' is not in the set '{splines, none}'");
}

using joint_state_broadcaster::JointData;
using joint_state_broadcaster::JointDataOptions;

TEST(JointData, HasMovableJointsOfTheModelInItsOrder) {
  JointDataOptions options;
  options.standard_names = {{"position", "position"}, {"velocity", "velocity"}};
  options.filters_by_model = true;
  options.model_joints = {"a", "b", "c"};
  options.extra_joints = {"finger", "b"};
  JointData data({{"b", "position"}, {"a", "position"}, {"a", "temperature"}, {"imu", "position"}},
                 options);
  EXPECT_EQ(data.names(), (Names{"a", "b", "finger"}));
  data.set(0, 2.5);
  data.set(2, 40.0);
  EXPECT_EQ(data.value("b", "position"), 2.5);
  EXPECT_EQ(data.value("a", "temperature"), 40.0);
  EXPECT_TRUE(std::isnan(data.value("a", "position"))) << "not set yet";
  EXPECT_TRUE(std::isnan(data.value("b", "effort"))) << "no such interface";
  EXPECT_EQ(data.value("finger", "effort"), 0.0);
  EXPECT_EQ(data.all().size(), 4u);
}

TEST(JointData, WithoutModelHasTheOrderOfInterfacesAndMappedNames) {
  JointDataOptions options;
  options.standard_names = {{"measured", "position"}};
  JointData data({{"z", "measured"}, {"force", "force.x"}, {"a", "effort"}, {"z", "velocity"}},
                 options);
  EXPECT_EQ(data.names(), (Names{"a", "z"})) << "by the last interface of each";
  data.set(0, 1.0);
  EXPECT_EQ(data.value("z", "position"), 1.0);
}

}  // namespace
