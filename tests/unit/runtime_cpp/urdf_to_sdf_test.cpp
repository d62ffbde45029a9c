// Robots of URDF as models: fixed joints are lumped, <gazebo> elements count, links without a mass
// vanish.
#include "sdf_texts.hpp"

namespace {

using namespace sdf_texts;

std::string mass(double value, const std::string& moments = "0.1 0.1 0.1") {
  const std::size_t a = moments.find(' '), b = moments.rfind(' ');
  return "<inertial><mass value='" + std::to_string(value) + "'/><inertia ixx='" +
         moments.substr(0, a) + "' iyy='" + moments.substr(a + 1, b - a - 1) + "' izz='" +
         moments.substr(b + 1) + "' ixy='0' ixz='0' iyz='0'/></inertial>";
}
std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name='" + name + "'>" + mass(1) + inside + "</link>";
}
std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& inside = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + inside + "</joint>";
}
const std::string kSphere = "<geometry><sphere radius='1'/></geometry>";

Reading<Model> reading_of(const std::string& inside) {
  return read_model("<robot name='r'>" + inside + "</robot>", "robot", files({}));
}
Model robot_of(const std::string& inside) {
  const Reading<Model> reading = reading_of(inside);
  EXPECT_EQ(said(reading.notes), "");
  return reading.value.value_or(Model());
}
std::string notes_of(const std::string& inside) {
  const Reading<Model> reading = reading_of(inside);
  const std::string result = said(reading.notes);
  EXPECT_EQ(reading.value.has_value(), result.find("error ") == std::string::npos) << result;
  return result;
}

const std::string kRover = R"(<robot name="rover">
  <link name="base_footprint"/>
  <joint name="base_joint" type="fixed"><parent link="base_footprint"/><child link="base_link"/>
    <origin xyz="0 0 0.05"/></joint>
  <link name="base_link">
    <visual><origin xyz="0 0 0.05"/><geometry><box size="0.3 0.26 0.1"/></geometry></visual>
    <collision><origin xyz="0 0 0.05"/><geometry><box size="0.3 0.26 0.1"/></geometry></collision>
    <inertial><mass value="3"/><inertia ixx="0.0125" ixy="0" ixz="0" iyy="0.025" iyz="0" izz="0.0325"/>
    </inertial></link>
  <link name="left_wheel">
    <visual><origin rpy="1.5707963267948966 0 0"/><geometry><cylinder radius="0.05" length="0.03"/>
      </geometry></visual>
    <collision><origin rpy="1.5707963267948966 0 0"/><geometry>
      <cylinder radius="0.05" length="0.03"/></geometry></collision>
    <inertial><mass value="0.2"/><inertia ixx="0.00014" ixy="0" ixz="0" iyy="0.00025" iyz="0"
      izz="0.00014"/></inertial></link>
  <joint name="left_wheel_joint" type="continuous"><parent link="base_link"/><child link="left_wheel"/>
    <origin xyz="0.06 0.15 0"/><axis xyz="0 1 0"/></joint>
  <link name="caster">
    <collision><geometry><sphere radius="0.05"/></geometry></collision>
    <inertial><mass value="0.1"/><inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0"
      izz="0.0001"/></inertial></link>
  <joint name="caster_joint" type="fixed"><parent link="base_link"/><child link="caster"/>
    <origin xyz="-0.12 0 0"/></joint>
  <gazebo reference="caster"><mu1>0.001</mu1><mu2>0.002</mu2></gazebo>
  <link name="laser"/>
  <joint name="laser_joint" type="fixed"><parent link="base_link"/><child link="laser"/>
    <origin xyz="0.1 0 0.15"/></joint>
  <gazebo reference="laser"><sensor name="laser" type="ray"><pose>0 0 0.01 0 0 0</pose>
    <update_rate>10</update_rate><plugin name="laser" filename="libgazebo_ros_ray_sensor.so">
    <frame_name>laser</frame_name></plugin></sensor></gazebo>
  <gazebo><plugin name="diff_drive" filename="libgazebo_ros_diff_drive.so"/></gazebo>
</robot>)";

TEST(UrdfToSdf, ARoverIsLumpedIntoItsFootprint) {
  const Reading<Model> reading = read_model(kRover, "rover", files({}));
  ASSERT_TRUE(reading.value.has_value()) << said(reading.notes);
  EXPECT_EQ(said(reading.notes), "");
  const Model& model = *reading.value;
  EXPECT_EQ(model.name, "rover");
  EXPECT_EQ(model.canonical_link, "base_footprint");
  ASSERT_EQ(model.links.size(), 2U);
  const Link& base = model.links[0];
  EXPECT_EQ(base.name, "base_footprint");
  ASSERT_EQ(base.collisions.size(), 2U);
  EXPECT_EQ(base.collisions[0].name, "base_footprint_fixed_joint_lump__base_link_collision");
  expect_near(base.collisions[0].pose, pose_of(0, 0, 0.1));
  EXPECT_EQ(base.collisions[0].surface.mu, 1);
  EXPECT_EQ(base.collisions[1].name, "base_footprint_fixed_joint_lump__caster_collision_1");
  expect_near(base.collisions[1].pose, pose_of(-0.12, 0, 0.05));
  EXPECT_EQ(base.collisions[1].surface.mu, 0.001);
  EXPECT_EQ(base.collisions[1].surface.mu2, 0.002);
  EXPECT_EQ(base.visuals[0].name, "base_footprint_fixed_joint_lump__base_link_visual");
  // 3 kg at 0 and 0.1 kg at -0.12 m, both 0.05 m high.
  const Inertial& inertial = base.inertial;
  EXPECT_NEAR(inertial.mass, 3.1, 1e-12);
  expect_near(inertial.pose, pose_of(-0.012 / 3.1, 0, 0.05));
  const double apart = 3 * 0.1 / 3.1 * 0.12 * 0.12;  // The reduced mass, at their distance.
  EXPECT_NEAR(inertial.ixx, 0.0126, 1e-12);
  EXPECT_NEAR(inertial.iyy, 0.0251 + apart, 1e-12);
  EXPECT_NEAR(inertial.izz, 0.0326 + apart, 1e-12);
  ASSERT_EQ(base.sensors.size(), 1U);
  expect_near(base.sensors[0].pose, pose_of(0.1, 0, 0.21));
  EXPECT_EQ(base.sensors[0].plugins[0].filename, "libgazebo_ros_ray_sensor.so");
  const Link& wheel = model.links[1];
  EXPECT_EQ(wheel.collisions[0].name, "left_wheel_collision");
  expect_near(wheel.pose, pose_of(0.06, 0.15, 0.05));
  expect_near(wheel.collisions[0].pose, pose_of(0, 0, 0, kPi / 2));
  ASSERT_EQ(model.joints.size(), 1U);
  EXPECT_EQ(model.joints[0].parent, "base_footprint");
  EXPECT_EQ(model.joints[0].child, "left_wheel");
  EXPECT_EQ(model.joints[0].type, JointType::kRevolute);
  EXPECT_EQ(model.joints[0].axes[0].xyz, (Vector3{0, 1, 0}));
  EXPECT_EQ(model.joints[0].axes[0].lower, -kInfinity);
  ASSERT_EQ(model.frames.size(), 6U);
  EXPECT_EQ(model.frames[0].name, "base_joint");
  EXPECT_EQ(model.frames[1].name, "base_link");
  expect_near(model.frames[1].pose, pose_of(0, 0, 0.05));
  EXPECT_EQ(model.frames[5].name, "laser");
  EXPECT_EQ(model.frames[5].link, "base_footprint");
  EXPECT_EQ(model.plugins[0].name, "diff_drive");
}

TEST(UrdfToSdf, MomentsTurnWithTheirLinks) {
  const Model model =
      robot_of("<link name='a'/><link name='b'>" + mass(2, "1 2 2.5") + "</link>" +
               joint("j", "fixed", "a", "b", "<origin xyz='0 0 1' rpy='0 0 1.5707963267948966'/>") +
               link("c") + joint("k", "fixed", "a", "c", "<origin xyz='0 0 -2'/>"));
  const Inertial& inertial = model.links[0].inertial;
  EXPECT_NEAR(inertial.mass, 3, 1e-12);
  expect_near(inertial.pose, pose_of(0, 0, 0));
  // x and y change places; 2 kg at 1 m and 1 kg at 2 m add 6 kg m2 to both.
  EXPECT_NEAR(inertial.ixx, 2.1 + 6, 1e-12);
  EXPECT_NEAR(inertial.iyy, 1.1 + 6, 1e-12);
  EXPECT_NEAR(inertial.izz, 2.6, 1e-12);
  EXPECT_NEAR(inertial.ixy, 0, 1e-12);
}

TEST(UrdfToSdf, ShapesAreNamedAfterWhereTheyCameFrom) {
  const std::string two = "<collision>" + kSphere + "</collision><collision>" + kSphere +
                          "</collision><collision name='n'>" + kSphere + "</collision>";
  const Model model = robot_of(link("a", two) + link("b", two) + link("a_arm", two) +
                               joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a_arm"));
  std::vector<std::string> names;
  for (const Collision& collision : model.links[0].collisions) {
    names.push_back(collision.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{
                       "a_collision", "a_collision_1", "a_fixed_joint_lump__n_collision_2",
                       "a_fixed_joint_lump__b_collision_3", "a_fixed_joint_lump__b_collision_4",
                       "a_fixed_joint_lump__n_collision_5", "a_arm_collision_6",
                       "a_arm_collision_7", "a_fixed_joint_lump__n_collision_8"}));
}

TEST(UrdfToSdf, FixedJointsStayWhenTheyAreAskedTo) {
  const std::string robot = link("a") + link("b") + joint("j", "fixed", "a", "b");
  const Model kept = robot_of(
      robot + "<gazebo reference='j'><preserveFixedJoint>true</preserveFixedJoint></gazebo>");
  EXPECT_EQ(kept.links.size(), 2U);
  EXPECT_EQ(kept.joints.at(0).type, JointType::kFixed);
  const Model locked = robot_of(robot +
                                "<gazebo reference='j'><disableFixedJointLumping>1"
                                "</disableFixedJointLumping></gazebo>");
  EXPECT_EQ(locked.joints.at(0).type, JointType::kRevolute);
  EXPECT_EQ(locked.joints.at(0).axes[0].lower, 0);
  EXPECT_EQ(locked.joints.at(0).axes[0].upper, 0);
  const Model lumped = robot_of(
      robot + "<gazebo reference='j'><preserveFixedJoint>false</preserveFixedJoint></gazebo>");
  EXPECT_EQ(lumped.links.size(), 1U);
}

TEST(UrdfToSdf, LinksWithoutAMassVanishWithAllBelow) {
  const Reading<Model> reading = reading_of(
      link("a") + "<link name='b'/>" + link("c") + link("d") + joint("ab", "continuous", "a", "b") +
      joint("bc", "continuous", "b", "c") + joint("cd", "continuous", "c", "d") +
      "<gazebo reference='b'><gravity>0</gravity></gazebo>");
  ASSERT_TRUE(reading.value.has_value());
  EXPECT_EQ(reading.value->links.size(), 1U);
  EXPECT_EQ(reading.value->joints.size(), 0U);
  EXPECT_EQ(
      said(reading.notes),
      "warning robot:1: urdf2sdf: link[b] has no <inertial> block defined. urdf2sdf: parent "
      "joint[ab] ignored. urdf2sdf: [1] child joints ignored. urdf2sdf: link[b] is not modeled "
      "in sdf. All links below it vanish too. Give it an <inertial> with a mass, or connect it "
      "with a fixed joint to a link that has one.\n");
  EXPECT_NE(
      notes_of("<link name='a'/>").find("error robot:1: the robot `r` has no link with a mass"),
      std::string::npos);
}

TEST(UrdfToSdf, TheRootWorldIsTheWorld) {
  const Model model = robot_of("<link name='world'/>" + link("base") + link("tool") +
                               joint("fix", "fixed", "world", "base", "<origin xyz='0 0 2'/>") +
                               joint("tip", "fixed", "base", "tool"));
  ASSERT_EQ(model.links.size(), 1U);
  EXPECT_EQ(model.links[0].name, "base");
  expect_near(model.links[0].pose, pose_of(0, 0, 2));
  ASSERT_EQ(model.joints.size(), 1U);
  EXPECT_EQ(model.joints[0].parent, "world");
  EXPECT_EQ(model.joints[0].type, JointType::kFixed);
}

TEST(UrdfToSdf, JointsHaveLimitsDynamicsAndMimics) {
  const Reading<Model> reading = reading_of(
      link("a") + link("b") + link("c") + link("d") + link("e") +
      joint("ab", "revolute", "a", "b",
            "<limit lower='1' upper='-1' effort='5' velocity='6'/><axis xyz='0 0 2'/>"
            "<dynamics damping='0.5' friction='0.25'/>") +
      joint("ac", "prismatic", "a", "c",
            "<limit effort='1' velocity='1'/><mimic joint='ab' multiplier='-2' offset='3'/>") +
      joint("ad", "floating", "a", "d") +
      joint("ae", "continuous", "a", "e",
            "<limit lower='0' upper='0' effort='7' velocity='8'/><mimic joint='ax'/>") +
      "<gazebo reference='ae'><springStiffness>9</springStiffness></gazebo>");
  ASSERT_TRUE(reading.value.has_value()) << said(reading.notes);
  EXPECT_EQ(said(reading.notes),
            "warning robot:1: the joint `ab` has a lower limit above its upper limit; they are "
            "swapped\n"
            "warning robot:1: the floating joint `ad` is not part of the simulation: its child `d` "
            "moves freely\n"
            "warning robot:1: the joint `ae` mimics the joint `ax`, which does not exist or is "
            "itself, so it moves freely; the nearest name is `ab`\n");
  const std::vector<Joint>& joints = reading.value->joints;
  ASSERT_EQ(joints.size(), 3U);
  EXPECT_EQ(reading.value->links.size(), 5U);
  EXPECT_EQ(joints[0].axes[0].lower, -1);
  EXPECT_EQ(joints[0].axes[0].upper, 1);
  EXPECT_EQ(joints[0].axes[0].xyz, (Vector3{0, 0, 1}));
  EXPECT_EQ(joints[0].axes[0].damping, 0.5);
  EXPECT_EQ(joints[0].axes[0].friction, 0.25);
  EXPECT_EQ(joints[0].axes[0].effort, 5);
  EXPECT_EQ(joints[1].axes[0].xyz, (Vector3{1, 0, 0}));
  EXPECT_EQ(joints[1].axes[0].mimic->multiplier, -2);
  EXPECT_EQ(joints[1].axes[0].mimic->offset, 3);
  EXPECT_EQ(joints[2].axes[0].upper, kInfinity);
  EXPECT_EQ(joints[2].axes[0].velocity, 8);
  EXPECT_EQ(joints[2].axes[0].spring_stiffness, 9);
  EXPECT_FALSE(joints[2].axes[0].mimic.has_value());
}

TEST(UrdfToSdf, ColoursComeFromTheUrdfOrFromGazebo) {
  const std::string visual = "<visual>" + kSphere + "<material name='m'/></visual>";
  const Model model = robot_of(
      "<material name='m'><color rgba='0.4 1 0 0.5'/></material>" + link("a", visual) +
      link("b", visual) + link("c", visual) + joint("ab", "continuous", "a", "b") +
      joint("ac", "continuous", "a", "c") +
      "<gazebo reference='b'><material>Gazebo/Red</material></gazebo><gazebo reference='c'><visual>"
      "<material><diffuse>0 0 1 1</diffuse></material><transparency>0.5</transparency></visual>"
      "</gazebo>");
  EXPECT_EQ(model.links[0].visuals[0].material.diffuse.r, 0.5);
  EXPECT_EQ(model.links[0].visuals[0].material.diffuse.g, 1);
  EXPECT_EQ(model.links[0].visuals[0].material.diffuse.a, 0.5);
  EXPECT_EQ(model.links[1].visuals[0].material.diffuse.r, 1);
  EXPECT_EQ(model.links[1].visuals[0].material.diffuse.g, 0);
  EXPECT_EQ(model.links[2].visuals[0].material.diffuse.b, 1);
  EXPECT_EQ(model.links[2].visuals[0].transparency, 0.5);
}

TEST(UrdfToSdf, GazeboElementsOfLinksAndModelCount) {
  const std::string shape = "<collision>" + kSphere + "</collision>";
  const Model model = robot_of(
      link("a", shape) + link("b") + joint("ab", "continuous", "a", "b") +
      "<gazebo reference='a'><mu1 value='0.5'/><mu2>0.25</mu2><fdir1>1 0 0</fdir1><kp>1e6</kp>"
      "<selfCollide>true</selfCollide><turnGravityOff>true</turnGravityOff></gazebo>"
      "<gazebo reference='b'><light name='l' type='point'><pose relative_to='a'>0 0 1 0 0 0</pose>"
      "</light></gazebo>"
      "<gazebo reference='ab'><sensor name='ft' type='force_torque'/></gazebo>"
      "<gazebo><static>true</static><joint name='x' type='fixed'><parent>a</parent><child>b</child>"
      "</joint></gazebo>");
  const Link& a = model.links[0];
  EXPECT_EQ(a.collisions[0].surface.mu, 0.5);
  EXPECT_EQ(a.collisions[0].surface.mu2, 0.25);
  EXPECT_EQ(a.collisions[0].surface.fdir1.x, 1);
  EXPECT_TRUE(a.self_collide);
  EXPECT_FALSE(a.gravity);
  EXPECT_EQ(model.links[1].lights[0].pose.position.z, 1);
  EXPECT_EQ(model.joints[0].sensors[0].name, "ft");
  EXPECT_EQ(model.joints[1].name, "x");
  EXPECT_TRUE(model.is_static);
}

TEST(UrdfToSdf, ContactSensorsFollowTheirCollisions) {
  const std::string shape = "<collision>" + kSphere + "</collision>";
  const Model model = robot_of(
      link("a", shape) + link("b", shape) + joint("j", "fixed", "a", "b") +
      "<gazebo reference='b'><sensor name='s' type='contact'><contact><collision> b_collision "
      "</collision></contact><plugin name='p&amp;' filename='f'><x y='&lt;'>1</x></plugin></sensor>"
      "</gazebo>");
  const Sensor& sensor = model.links.at(0).sensors.at(0);
  const auto& xml = *sensor.xml.document;
  const auto* contact = xml.child(*sensor.xml.element, "contact");
  ASSERT_NE(contact, nullptr);
  EXPECT_EQ(xml.child(*contact, "collision")->text, "a_fixed_joint_lump__b_collision_1");
  const XmlView& plugin = sensor.plugins.at(0).xml;
  EXPECT_EQ(*plugin.document->child(*plugin.element, "x")->attribute("y"), "<");
  EXPECT_EQ(sensor.plugins[0].name, "p&");
}

TEST(UrdfToSdf, MistakesAreReportedTogether) {
  EXPECT_EQ(
      notes_of(link("a") + link("a") + joint("j", "hinge", "a", "b") +
               joint("k", "revolute", "ab", "a") + "<link name='c'><visual/></link>"),
      "error robot:1: the robot has two links `a`\n"
      "error robot:1: <visual> needs a <geometry> with a shape\n"
      "error robot:1: the joint `j` is of type `hinge`, which does not exist: types are "
      "fixed, revolute, continuous, prismatic, floating and planar\n"
      "error robot:1: the child `b` of the joint `j` does not exist; the nearest name is `a`\n"
      "error robot:1: the parent `ab` of the joint `k` does not exist; the nearest name is "
      "`a`\n"
      "error robot:1: the revolute joint `k` needs a <limit>\n");
  EXPECT_EQ(notes_of(link("a") + link("b")),
            "error robot:1: the links `a` and `b` both have no parent joint: a robot has one root "
            "link\n");
  EXPECT_EQ(
      notes_of(link("a") + link("b") + joint("j", "fixed", "a", "b") +
               joint("k", "fixed", "b", "a")),
      "error robot:1: the robot has no root: each link is the child of a joint, so the joints "
      "form a loop\n");
  EXPECT_EQ(notes_of(link("a") + link("b") + link("c") + joint("j", "fixed", "c", "b") +
                     joint("k", "fixed", "b", "c")),
            "error robot:1: some joints form a loop, so their links are not connected to the root "
            "`a`\n");
  EXPECT_EQ(notes_of(""), "error robot:1: the robot has no link\n");
}

TEST(UrdfToSdf, ElementsWithoutEffectAreWarnings) {
  EXPECT_EQ(
      notes_of(link("base_link") + link("b") + joint("j", "fixed", "base_link", "b") +
               "<gazebo reference='base_lnk'><mu1>1</mu1></gazebo><gazebo reference='b'>"
               "<mu>1</mu><plugin name='p' filename='f'/></gazebo><gazebo reference='j'>"
               "<sensor name='s' type='force_torque'/></gazebo><gazebo>"
               "<sensor name='t' type='imu'/></gazebo>"),
      "warning robot:1: <gazebo reference=\"base_lnk\"> names no link or joint of the robot, so "
      "it is skipped; the nearest name is `base_link`\n"
      "warning robot:1: <mu> in <gazebo reference=\"b\"> has no effect: write <mu1>\n"
      "warning robot:1: the plugin `p` is in <gazebo reference=\"b\"> and is not loaded: put "
      "it into a <gazebo> without `reference`, or into a <sensor>\n"
      "warning robot:1: the sensor `s` is skipped, since its fixed joint `j` is lumped: add "
      "<gazebo reference=\"j\"><preserveFixedJoint>true</preserveFixedJoint></gazebo>\n"
      "warning robot:1: <sensor> in a <gazebo> without `reference` is skipped: write <gazebo "
      "reference=\"LINK\">\n");
}

}  // namespace
