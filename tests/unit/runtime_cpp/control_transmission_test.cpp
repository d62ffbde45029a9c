// Transmissions: there by the formula, and back to where it began. And limits of commands.
#include <gtest/gtest.h>

#include <optional>

#include "joint_limits/joint_limits_helpers.hpp"
#include "transmission_interface/differential_transmission.hpp"
#include "transmission_interface/four_bar_linkage_transmission.hpp"
#include "transmission_interface/simple_transmission.hpp"

namespace {

using namespace transmission_interface;

TEST(control_transmission, a_simple_one_reduces_and_offsets) {
  double joint[] = {0.0, 0.0, 0.0};
  double actuator[] = {10.0, 20.0, 3.0};
  SimpleTransmission gear(50.0, 0.5);
  gear.configure({{"arm", "position", &joint[0]},
                  {"arm", "velocity", &joint[1]},
                  {"arm", "effort", &joint[2]}},
                 {{"motor", "position", &actuator[0]},
                  {"motor", "velocity", &actuator[1]},
                  {"motor", "effort", &actuator[2]}});
  gear.actuator_to_joint();
  EXPECT_DOUBLE_EQ(joint[0], 10.0 / 50.0 + 0.5);
  EXPECT_DOUBLE_EQ(joint[1], 20.0 / 50.0);
  EXPECT_DOUBLE_EQ(joint[2], 3.0 * 50.0);
  actuator[0] = actuator[1] = actuator[2] = 0.0;
  gear.joint_to_actuator();
  EXPECT_DOUBLE_EQ(actuator[0], 10.0);
  EXPECT_DOUBLE_EQ(actuator[1], 20.0);
  EXPECT_DOUBLE_EQ(actuator[2], 3.0);
  EXPECT_THROW(SimpleTransmission(0.0), Exception);
  EXPECT_THROW(gear.configure({}, {{"motor", "position", &actuator[0]}}), Exception);
}

template <typename TransmissionT>
void returns(TransmissionT gear, const char* interface, double first, double second) {
  double joint[2];
  double actuator[2] = {4.0, 1.0};
  gear.configure({{"j1", interface, &joint[0]}, {"j2", interface, &joint[1]}},
                 {{"a1", interface, &actuator[0]}, {"a2", interface, &actuator[1]}});
  gear.actuator_to_joint();
  EXPECT_DOUBLE_EQ(joint[0], first);
  EXPECT_DOUBLE_EQ(joint[1], second);
  actuator[0] = actuator[1] = 0.0;
  gear.joint_to_actuator();
  EXPECT_DOUBLE_EQ(actuator[0], 4.0);
  EXPECT_DOUBLE_EQ(actuator[1], 1.0);
}

TEST(control_transmission, a_differential_one_mixes_two_joints) {
  const DifferentialTransmission gear({2.0, -4.0}, {0.5, 8.0}, {1.0, -1.0});
  returns(gear, "position", (4.0 / 2 - 1.0 / 4) / (2 * 0.5) + 1.0,
          (4.0 / 2 + 1.0 / 4) / (2 * 8.0) - 1.0);
  returns(gear, "effort", 0.5 * (4.0 * 2 - 1.0 * 4), 8.0 * (4.0 * 2 + 1.0 * 4));
  EXPECT_THROW(DifferentialTransmission({1.0}, {1.0, 1.0}), Exception);
}

TEST(control_transmission, a_four_bar_linkage_takes_the_second_with_the_first) {
  const FourBarLinkageTransmission gear({2.0, -4.0}, {0.5, 8.0});
  returns(gear, "velocity", 4.0 / (0.5 * 2), (1.0 / -4 - 4.0 / (0.5 * 2)) / 8.0);
  returns(gear, "effort", 0.5 * 4.0 * 2 + 1.0 * -4, 8.0 * 1.0 * -4);
}

TEST(control_limits, a_command_moves_as_far_as_its_velocity_lets_it) {
  joint_limits::JointLimits limits;
  limits.has_position_limits = limits.has_velocity_limits = true;
  limits.min_position = -1.0;
  limits.max_position = 1.0;
  limits.max_velocity = 2.0;
  joint_limits::JointControlInterfacesData actual;
  joint_limits::JointControlInterfacesData desired;
  joint_limits::JointControlInterfacesData previous;
  actual.position = 0.0;
  desired.position = 5.0;
  EXPECT_TRUE(joint_limits::saturate("j", limits, actual, desired, previous, 0.1));
  EXPECT_DOUBLE_EQ(*desired.position, 0.2);
  for (int i = 0; i < 9; ++i) {
    desired.position = 5.0;
    joint_limits::saturate("j", limits, actual, desired, previous, 0.1);
  }
  EXPECT_DOUBLE_EQ(*desired.position, 1.0);
  desired = {};
  desired.velocity = -3.0;
  EXPECT_TRUE(joint_limits::saturate("j", limits, actual, desired, previous, 0.1));
  EXPECT_DOUBLE_EQ(*desired.velocity, -2.0);
  EXPECT_FALSE(joint_limits::saturate("j", limits, actual, desired, previous, 0.0));
}

}  // namespace
