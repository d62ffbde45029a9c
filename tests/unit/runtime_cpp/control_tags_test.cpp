// Tags <ros2_control> of robot descriptions: what is read, and what is refused.
#include <gtest/gtest.h>

#include <stdexcept>

#include "hardware_interface/component_parser.hpp"

namespace {

using hardware_interface::HardwareInfo;
using hardware_interface::parse_control_resources_from_urdf;

std::string robot(const std::string& tags) {
  return R"(<robot name="crane">
  <link name="base"/><link name="boom"/><link name="jib"/><link name="hook"/>
  <joint name="slew" type="revolute">
    <parent link="base"/><child link="boom"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2.5" velocity="0.7" effort="40"/>
    <safety_controller soft_lower_limit="-3" soft_upper_limit="2" k_position="10" k_velocity="20"/>
  </joint>
  <joint name="luff" type="revolute">
    <parent link="boom"/><child link="jib"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" velocity="0.5" effort="30"/>
    <mimic joint="slew" multiplier="-0.5" offset="0.1"/>
  </joint>
  <joint name="bolt" type="fixed"><parent link="jib"/><child link="hook"/></joint>
  )" + tags +
         "</robot>";
}

std::string system_tag(const std::string& inside) {
  return robot(R"(<ros2_control name="Crane" type="system">)" + inside + "</ros2_control>");
}

std::string error_of(const std::string& urdf) {
  try {
    parse_control_resources_from_urdf(urdf);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(control_tags, a_system_is_read) {
  const auto all = parse_control_resources_from_urdf(system_tag(R"(
    <hardware>
      <plugin> cranes/Crane </plugin>
      <group>yard</group>
      <param name="port">/dev/ttyS1</param>
    </hardware>
    <joint name="slew">
      <command_interface name="position">
        <param name="min">-1.5</param><param name="max">3</param>
      </command_interface>
      <state_interface name="position"><param name="initial_value">0.25</param></state_interface>
      <param name="gear">7</param>
    </joint>
    <sensor name="wind"><state_interface name="speed"/></sensor>
    <gpio name="lamp"><command_interface name="on" data_type="bool" size="3"/></gpio>)"));
  ASSERT_EQ(all.size(), 1U);
  const HardwareInfo& info = all.front();
  EXPECT_EQ(info.name, "Crane");
  EXPECT_EQ(info.type, "system");
  EXPECT_EQ(info.group, "yard");
  EXPECT_EQ(info.rw_rate, 0U);
  EXPECT_FALSE(info.is_async);
  EXPECT_EQ(info.hardware_plugin_name, "cranes/Crane");
  EXPECT_EQ(info.hardware_parameters.at("port"), "/dev/ttyS1");
  ASSERT_EQ(info.joints.size(), 1U);
  EXPECT_EQ(info.joints[0].parameters.at("gear"), "7");
  EXPECT_EQ(info.joints[0].command_interfaces.at(0).min, "-1.5");
  EXPECT_EQ(info.joints[0].state_interfaces.at(0).initial_value, "0.25");
  EXPECT_EQ(info.sensors.at(0).state_interfaces.at(0).name, "speed");
  EXPECT_EQ(info.gpios.at(0).command_interfaces.at(0).data_type, "bool");
  EXPECT_EQ(info.gpios.at(0).command_interfaces.at(0).size, 3);
}

TEST(control_tags, limits_are_the_narrower_of_joint_and_interface) {
  const auto info = parse_control_resources_from_urdf(system_tag(R"(
    <hardware><plugin>p</plugin></hardware>
    <joint name="slew">
      <command_interface name="position">
        <param name="min">-1.5</param><param name="max">3</param>
      </command_interface>
      <command_interface name="velocity"><param name="min">-0.2</param><param name="max">0.6</param>
      </command_interface>
      <command_interface name="acceleration"><param name="max">4</param></command_interface>
    </joint>)"))
                        .front();
  const auto& limits = info.limits.at("slew");
  EXPECT_TRUE(limits.has_position_limits);
  EXPECT_DOUBLE_EQ(limits.min_position, -1.5);
  EXPECT_DOUBLE_EQ(limits.max_position, 2.5);
  EXPECT_DOUBLE_EQ(limits.max_velocity, 0.2);
  EXPECT_DOUBLE_EQ(limits.max_effort, 40.0);
  EXPECT_TRUE(limits.has_acceleration_limits);
  EXPECT_FALSE(limits.has_deceleration_limits);
  EXPECT_DOUBLE_EQ(limits.max_deceleration, 4.0);
  const auto& soft = info.soft_limits.at("slew");
  EXPECT_DOUBLE_EQ(soft.min_position, -1.5);
  EXPECT_DOUBLE_EQ(soft.max_position, 2.0);
}

TEST(control_tags, disabled_limits_are_none) {
  const auto info = parse_control_resources_from_urdf(system_tag(R"(
    <hardware><plugin>p</plugin></hardware>
    <joint name="slew"><limits enable="false"/><command_interface name="position"/></joint>)"))
                        .front();
  EXPECT_FALSE(info.limits.at("slew").has_position_limits);
  EXPECT_FALSE(info.joints[0].command_interfaces[0].enable_limits);
}

TEST(control_tags, a_mimic_joint_follows_by_index) {
  const std::string joints = R"(<hardware><plugin>p</plugin></hardware>
    <joint name="luff"><state_interface name="position"/></joint>
    <joint name="slew"><command_interface name="position"/></joint>)";
  const auto info = parse_control_resources_from_urdf(system_tag(joints)).front();
  ASSERT_EQ(info.mimic_joints.size(), 1U);
  EXPECT_EQ(info.mimic_joints[0].joint_index, 0U);
  EXPECT_EQ(info.mimic_joints[0].mimicked_joint_index, 1U);
  EXPECT_DOUBLE_EQ(info.mimic_joints[0].multiplier, -0.5);
  EXPECT_DOUBLE_EQ(info.mimic_joints[0].offset, 0.1);
  EXPECT_EQ(error_of(system_tag(R"(<hardware><plugin>p</plugin></hardware>
    <joint name="slew"/><joint name="luff"><command_interface name="position"/></joint>)")),
            "Joint 'luff' has mimic attribute not set to false: Activated mimic joints cannot have "
            "command interfaces.");
  EXPECT_TRUE(
      parse_control_resources_from_urdf(system_tag(R"(<hardware><plugin>p</plugin></hardware>
    <joint name="slew"/><joint name="luff" mimic="false"><command_interface name="position"/></joint>)"))
          .front()
          .mimic_joints.empty());
}

TEST(control_tags, transmissions_take_the_interfaces_of_their_joints) {
  const auto info = parse_control_resources_from_urdf(system_tag(R"(
    <hardware><plugin>p</plugin></hardware>
    <joint name="slew"><command_interface name="position"/><state_interface name="velocity"/></joint>
    <transmission name="gear">
      <plugin>transmission_interface/SimpleTransmission</plugin>
      <joint name="slew" role="joint1"><mechanical_reduction>325.9</mechanical_reduction></joint>
      <actuator name="motor" role="actuator1"><offset>0.5</offset></actuator>
    </transmission>)"))
                        .front();
  const auto& gear = info.transmissions.at(0);
  EXPECT_EQ(gear.joints.at(0).command_interfaces, std::vector<std::string>{"position"});
  EXPECT_EQ(gear.joints.at(0).state_interfaces, std::vector<std::string>{"velocity"});
  EXPECT_DOUBLE_EQ(gear.joints.at(0).mechanical_reduction, 325.9);
  EXPECT_DOUBLE_EQ(gear.actuators.at(0).offset, 0.5);
}

TEST(control_tags, mistakes_are_named) {
  EXPECT_EQ(error_of(""), "empty URDF passed to robot");
  EXPECT_EQ(error_of("<robot"),
            "invalid URDF passed in to robot parser: line 1: the tag of robot does not end");
  EXPECT_EQ(error_of(robot("")), "no 'ros2_control' tag found in the URDF");
  EXPECT_EQ(error_of(robot("<ros2_control name='x'/>")),
            "no attribute 'type' in 'ros2_control' tag with name 'x'");
  EXPECT_EQ(error_of(system_tag("<hardware/>")),
            "Missing <plugin> tag of <hardware> element for 'Crane' in your URDF.");
  EXPECT_EQ(error_of(system_tag("<motor/>")), "invalid tag name 'motor'");
  EXPECT_EQ(error_of(system_tag("<joint name='tail'/>")), "Joint 'tail' not found in URDF");
  EXPECT_EQ(error_of(system_tag("<joint name='bolt'/>")),
            "Joint 'bolt' is of type 'fixed'. Fixed joints do not make sense in ros2_control.");
  EXPECT_EQ(error_of(robot("<ros2_control name='x' type='system' rw_rate='-5'/>")),
            "Could not parse rw_rate tag in \"ros2_control\". Got \"-5\", but expected a positive "
            "integer.");
}

}  // namespace
