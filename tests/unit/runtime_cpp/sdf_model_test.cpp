// Models of SDF: frames, nested models, links, joints, masses and materials.
#include "sdf_texts.hpp"

namespace {

using namespace sdf_texts;

TEST(SdfModel, PosesOfLinksAndShapesFollowRelativeTo) {
  const Model model = model_of(R"(
    <pose>1 0 0 0 0 0</pose>
    <link name="a"><pose>0 0 1 0 0 1.5707963267948966</pose></link>
    <link name="b"><pose relative_to="a">1 0 0 0 0 0</pose>
      <collision name="c"><pose relative_to="__model__">0 0 0 0 0 0</pose>
        <geometry><sphere><radius>2</radius></sphere></geometry></collision>
      <visual name="v"><pose>0 0 1 0 0 0</pose>
        <geometry><cylinder><radius>1</radius><length>2</length></cylinder></geometry></visual>
      <sensor name="s" type="imu"><pose relative_to="f">0 0 0 0 0 0</pose>
        <gz_frame_id> imu_link </gz_frame_id><update_rate>50</update_rate><topic>imu</topic>
        <always_on>1</always_on><plugin name="p" filename="q"/></sensor>
      <light name="l" type="spot"><spot><inner_angle>0.1</inner_angle></spot></light></link>
    <frame name="f" attached_to="b"><pose>0 0 5 0 0 0</pose></frame>
    <frame name="g"><pose relative_to="f">0 0 1 0 0 0</pose></frame>)");
  expect_near(model.pose, pose_of(1, 0, 0));
  const Link& b = model.links[1];
  expect_near(b.pose, pose_of(0, 1, 1, 0, 0, kPi / 2));
  expect_near(b.collisions[0].pose, inverse(b.pose));
  expect_near(b.visuals[0].pose, pose_of(0, 0, 1));
  expect_near(b.sensors[0].pose, pose_of(0, 0, 5));
  EXPECT_EQ(b.sensors[0].frame_id, "imu_link");
  EXPECT_EQ(b.sensors[0].update_rate, 50);
  EXPECT_EQ(b.sensors[0].topic, "imu");
  EXPECT_TRUE(b.sensors[0].always_on);
  EXPECT_EQ(b.sensors[0].plugins[0].filename, "q");
  EXPECT_EQ(b.lights[0].inner_angle, 0.1);
  ASSERT_EQ(model.frames.size(), 2U);
  EXPECT_EQ(model.frames[0].link, "b");
  expect_near(model.frames[0].pose, pose_of(0, 0, 5));
  EXPECT_EQ(model.frames[1].link, "a");  // The canonical link.
  expect_near(model.frames[1].pose, inverse(model.links[0].pose) * pose_of(0, 1, 7, 0, 0, kPi / 2));
}

TEST(SdfModel, PosesAreInDegreesOrQuaternionsToo) {
  const Model model = model_of(R"(
    <link name="a"><pose degrees="true">0 0 0 0 0 90</pose></link>
    <link name="b"><pose rotation_format="quat_xyzw">1 2 3 0 0 2 2</pose></link>
    <link name="c"><pose/></link><link name="d"><pose>
      1 2 3
      0.1 -0.2 +3e-1 </pose></link>)");
  expect_near(model.links[0].pose, pose_of(0, 0, 0, 0, 0, kPi / 2));
  expect_near(model.links[1].pose, pose_of(1, 2, 3, 0, 0, kPi / 2));
  expect_near(model.links[2].pose, pose_of(0, 0, 0));
  expect_near(model.links[3].pose, pose_of(1, 2, 3, 0.1, -0.2, 0.3));
}

TEST(SdfModel, JointsHaveAxesInTheirOwnFrame) {
  const std::string links =
      "<link name='a'/><link name='b'><pose>0 0 1 0 0 1.5707963267948966</pose></link>";
  const Model model = model_of(links + R"(
    <joint name="j" type="revolute"><pose>0 0 0 0 0 1.5707963267948966</pose><parent>a</parent>
      <child>b</child><axis><xyz expressed_in="__model__">0 2 0</xyz>
        <limit><lower>-1e16</lower><upper>1.5</upper><effort>-1</effort><velocity>3</velocity>
        </limit><dynamics><damping>0.1</damping><friction>0.2</friction>
        <spring_stiffness>4</spring_stiffness><spring_reference>5</spring_reference></dynamics>
      </axis></joint>
    <joint name="k" type="continuous"><pose relative_to="a">0 0 0 0 0 0</pose><parent>world</parent>
      <child>a</child><axis><xyz>1 0 0</xyz><limit><lower>0</lower><upper>0</upper></limit>
      <mimic joint="j" axis="axis"><multiplier>2</multiplier><offset>1</offset>
        <reference>3</reference></mimic></axis></joint>)");
  ASSERT_EQ(model.joints.size(), 2U);
  const Joint& j = model.joints[0];
  EXPECT_EQ(j.type, JointType::kRevolute);
  expect_near(j.pose, pose_of(0, 0, 0, 0, 0, kPi / 2));
  expect_near(j.axes[0].xyz, {0, -1, 0});
  EXPECT_EQ(j.axes[0].lower, -kInfinity);
  EXPECT_EQ(j.axes[0].upper, 1.5);
  EXPECT_EQ(j.axes[0].effort, kInfinity);
  EXPECT_EQ(j.axes[0].velocity, 3);
  EXPECT_EQ(j.axes[0].damping, 0.1);
  EXPECT_EQ(j.axes[0].friction, 0.2);
  EXPECT_EQ(j.axes[0].spring_stiffness, 4);
  EXPECT_EQ(j.axes[0].spring_reference, 5);
  const JointAxis& k = model.joints[1].axes[0];
  EXPECT_EQ(model.joints[1].parent, "world");
  EXPECT_EQ(k.lower, -kInfinity);
  EXPECT_EQ(k.upper, kInfinity);
  expect_near(model.joints[1].pose, pose_of(0, 0, 0));
  EXPECT_EQ(k.mimic->offset, 1);
  EXPECT_EQ(k.mimic->joint, "j");
  EXPECT_EQ(k.mimic->multiplier, 2);
  EXPECT_EQ(k.mimic->reference, 3);
}

TEST(SdfModel, OldAxesAreInTheFrameOfTheModel) {
  const auto axis = [](const std::string& more, const std::string& version) {
    const Model model = model_of(
        "<link name='a'/><link name='b'><pose>0 0 0 0 0 1.5707963267948966"
        "</pose></link><joint name='j' type='prismatic'><parent>a</parent>"
        "<child>b</child><axis><xyz>1 0 0</xyz>" +
            more + "</axis></joint>",
        version);
    return model.joints.at(0).axes.at(0).xyz;
  };
  expect_near(axis("", "1.4"), {0, -1, 0});
  expect_near(axis("", "1.6"), {1, 0, 0});
  expect_near(axis("<use_parent_model_frame>1</use_parent_model_frame>", "1.6"), {0, -1, 0});
  expect_near(axis("<use_parent_model_frame>0</use_parent_model_frame>", "1.4"), {1, 0, 0});
  expect_near(axis("", "1.10"), {1, 0, 0});
}

TEST(SdfModel, OtherJointsHaveTheirOwnNumberOfAxes) {
  const Model model = model_of(R"(
    <link name="a"/><link name="b"/><frame name="f" attached_to="b"/>
    <joint name="u" type="universal"><parent>a</parent><child>f</child>
      <axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>
    <joint name="s" type="screw"><parent>a</parent><child>b</child>
      <screw_thread_pitch>0.5</screw_thread_pitch><axis><xyz>1 0 0</xyz></axis></joint>
    <joint name="o" type="ball"><parent>a</parent><child>b</child></joint>
    <joint name="x" type="fixed"><parent>a</parent><child>b</child>
      <sensor name="ft" type="force_torque"/></joint>)");
  EXPECT_EQ(model.joints[0].child, "b");
  EXPECT_EQ(model.joints[0].axes.size(), 2U);
  EXPECT_EQ(model.joints[1].thread_pitch, 0.5);
  EXPECT_EQ(model.joints[2].axes.size(), 0U);
  EXPECT_EQ(model.joints[3].sensors[0].type, "force_torque");
}

TEST(SdfModel, NestedModelsAreFlattened) {
  const Model model = model_of(R"(
    <link name="base"/>
    <model name="arm"><pose relative_to="mount">0 0 1 0 0 0</pose>
      <link name="lower"><pose>0 0 1 0 0 0</pose></link>
      <model name="hand"><pose>0 0 2 0 0 0</pose><link name="palm"/>
        <plugin name="grip" filename="g"/></model>
      <joint name="wrist" type="revolute"><parent>lower</parent><child>hand::palm</child>
        <axis><xyz>0 0 1</xyz><mimic joint="elbow"/></axis></joint>
      <joint name="elbow" type="revolute"><parent>world</parent><child>lower</child></joint>
      <frame name="tip" attached_to="hand::palm"><pose>0 0 0.5 0 0 0</pose></frame>
    </model>
    <frame name="mount" attached_to="base"><pose>1 0 0 0 0 0</pose></frame>
    <joint name="shoulder" type="fixed"><parent>base</parent><child>arm</child></joint>
    <joint name="far" type="fixed"><parent>base</parent><child>arm::hand::palm</child></joint>)");
  ASSERT_EQ(model.links.size(), 3U);
  EXPECT_EQ(model.links[1].name, "arm::lower");
  expect_near(model.links[1].pose, pose_of(1, 0, 2));
  EXPECT_EQ(model.links[2].name, "arm::hand::palm");
  expect_near(model.links[2].pose, pose_of(1, 0, 3));
  ASSERT_EQ(model.joints.size(), 4U);
  EXPECT_EQ(model.joints[0].name, "arm::wrist");
  EXPECT_EQ(model.joints[0].child, "arm::hand::palm");
  EXPECT_EQ(model.joints[0].axes[0].mimic->joint, "arm::elbow");
  EXPECT_EQ(model.joints[1].parent, "world");
  EXPECT_EQ(model.joints[2].child, "arm::lower");
  EXPECT_EQ(model.joints[3].child, "arm::hand::palm");
  EXPECT_EQ(model.plugins[0].model_scope, "arm::hand::");
  EXPECT_EQ(model.frames[0].name, "arm::tip");
  EXPECT_EQ(model.frames[0].link, "arm::hand::palm");
}

TEST(SdfModel, AMergedModelHasNoNameOfItsOwn) {
  const std::map<std::string, std::string> texts = {
      {"/models/gripper/model.sdf",
       model_text("<link name='palm'><pose>0 0 1 0 0 0</pose></link><link name='finger'/>"
                  "<joint name='j' type='revolute'><parent>palm</parent><child>finger</child>"
                  "</joint><frame name='f'/>")}};
  const std::string text = model_text(
      "<link name='base'/><include merge='true'><uri>model://gripper</uri>"
      "<pose>1 0 0 0 0 0</pose></include><frame name='tip' attached_to='f'/>"
      "<joint name='k' type='fixed'><parent>base</parent><child>palm</child></joint>");
  const Reading<Model> reading = read_model(text, "m", files(texts));
  ASSERT_TRUE(reading.value.has_value()) << said(reading.notes);
  const Model& model = *reading.value;
  EXPECT_EQ(model.links[1].name, "palm");
  expect_near(model.links[1].pose, pose_of(1, 0, 1));
  EXPECT_EQ(model.joints[0].name, "j");
  EXPECT_EQ(model.joints[1].child, "palm");
  EXPECT_EQ(model.frames.back().link, "palm");
}

TEST(SdfModel, AStaticModelInOneThatMovesIsFixedToTheWorld) {
  const Model model =
      model_of("<link name='a'/><model name='n'><static>true</static><link name='l'/></model>");
  ASSERT_EQ(model.joints.size(), 1U);
  EXPECT_EQ(model.joints[0].parent, "world");
  EXPECT_EQ(model.joints[0].child, "n::l");
}

TEST(SdfModel, PlacementAndCanonicalLinkCount) {
  const Reading<Model> reading = read_model(
      "<sdf version='1.9'><model name='m' placement_frame='b' canonical_link='b'>"
      "<pose>5 0 0 0 0 0</pose><link name='a'/><link name='b'><pose>1 0 0 0 0 0</pose></link>"
      "</model></sdf>",
      "m", files({}));
  ASSERT_TRUE(reading.value.has_value()) << said(reading.notes);
  EXPECT_EQ(reading.value->canonical_link, "b");
  expect_near(reading.value->pose, pose_of(4, 0, 0));
}

TEST(SdfModel, MassesComeFromTheFileOrFromTheShapes) {
  const Model model = model_of(R"(
    <link name="none"/>
    <link name="given"><inertial><mass>2</mass><pose>0 0 1 0 0 0</pose><inertia><ixx>0.1</ixx>
      <iyy>0.2</iyy><izz>0.25</izz><ixy>0.01</ixy></inertia></inertial></link>
    <link name="computed"><inertial auto="true"><density>10</density></inertial>
      <collision name="a"><pose>1 0 0 0 0 0</pose>
        <geometry><box><size>1 1 1</size></box></geometry></collision>
      <collision name="b"><density>30</density><pose>-1 0 0 0 0 0</pose>
        <geometry><box><size>1 1 1</size></box></geometry></collision></link>)",
                               "1.11");
  EXPECT_EQ(model.links[0].inertial.mass, 1);
  EXPECT_EQ(model.links[0].inertial.izz, 1);
  EXPECT_EQ(model.links[1].inertial.ixy, 0.01);
  EXPECT_EQ(model.links[1].inertial.pose.position.z, 1);
  const Inertial& computed = model.links[2].inertial;
  EXPECT_NEAR(computed.mass, 40, 1e-12);
  EXPECT_NEAR(computed.pose.position.x, -0.5, 1e-12);
  EXPECT_NEAR(computed.ixx, 40.0 / 6, 1e-12);
  // 10 kg at a distance of 1.5 m, and 30 kg at one of 0.5 m.
  EXPECT_NEAR(computed.izz, 40.0 / 6 + 10 * 2.25 + 30 * 0.25, 1e-12);
}

TEST(SdfModel, SurfacesAndMaterialsAreRead) {
  const Model model = model_of(R"(<link name="l">
    <collision name="c"><geometry><capsule><radius>1</radius><length>2</length></capsule></geometry>
      <surface><friction><ode><mu>0.5</mu><mu2>0.25</mu2><fdir1>1 0 0</fdir1></ode>
        <torsional><coefficient>0.1</coefficient></torsional></friction>
        <bounce><restitution_coefficient>0.9</restitution_coefficient></bounce>
        <contact><collide_bitmask>0x0f</collide_bitmask><category_bitmask>3</category_bitmask>
          <collide_without_contact>true</collide_without_contact></contact></surface></collision>
    <visual name="a"><geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry>
      <transparency>0.5</transparency><cast_shadows>0</cast_shadows>
      <material><diffuse>1 0 0</diffuse><emissive>0 0 1 1</emissive></material></visual>
    <visual name="b"><geometry><plane><size>3 4</size></plane></geometry>
      <material><script><name>Gazebo/GreenGlow</name></script></material></visual>
    <visual name="p"><geometry><empty/></geometry><material><pbr><metal><metalness>0.2</metalness>
      </metal></pbr></material></visual></link>)");
  const Surface& surface = model.links[0].collisions[0].surface;
  EXPECT_EQ(surface.mu, 0.5);
  EXPECT_EQ(surface.mu2, 0.25);
  EXPECT_EQ(surface.fdir1.x, 1);
  EXPECT_EQ(surface.torsional, 0.1);
  EXPECT_EQ(surface.restitution, 0.9);
  EXPECT_EQ(surface.collide_bitmask, 15U);
  EXPECT_EQ(surface.category_bitmask, 3U);
  EXPECT_TRUE(surface.collide_without_contact);
  const std::vector<Visual>& visuals = model.links[0].visuals;
  EXPECT_EQ(visuals[0].material.ambient.r, 1);
  EXPECT_EQ(visuals[0].material.ambient.g, 0);
  EXPECT_EQ(visuals[0].material.emissive.b, 1);
  EXPECT_EQ(visuals[0].transparency, 0.5);
  EXPECT_FALSE(visuals[0].cast_shadows);
  EXPECT_EQ(visuals[1].material.diffuse.r, 0);
  EXPECT_EQ(visuals[1].material.emissive.g, 1);
  EXPECT_EQ(std::get<Plane>(visuals[1].geometry).height, 4);
  EXPECT_EQ(std::get<Ellipsoid>(visuals[0].geometry).radii, (Vector3{1, 2, 3}));
  EXPECT_EQ(visuals[2].material.metalness, 0.2);
  EXPECT_EQ(visuals[2].material.roughness, 0.5);
}

TEST(SdfModel, WrongNamesAreReportedWithTheNearest) {
  const std::string notes = notes_of_model(R"(
    <link name="base_link"/><link name="wheel"><pose relative_to="bse_link">0 0 0 0 0 0</pose></link>
    <joint name="j" type="revolute"><parent>base_lnk</parent><child>wheel</child></joint>
    <joint name="k" type="revolute"><parent>base_link</parent><child>weel</child></joint>
    <joint name="o" type="hinge"><parent>base_link</parent><child>wheel</child></joint>
    <joint name="p" type="revolute"><parent>base_link</parent><child>wheel</child>
      <axis><mimic joint="pp"/></axis></joint>)");
  EXPECT_EQ(
      notes,
      "error model:2: frame `bse_link` is not defined in this scope; the nearest name is "
      "`base_link`\n"
      "error model:3: the parent `base_lnk` of the joint `j` does not exist; the nearest name "
      "is `base_link`\n"
      "error model:4: the child `weel` of the joint `k` does not exist; the nearest name is "
      "`wheel`\n"
      "error model:5: the joint `o` is of type `hinge`, which does not exist: types are fixed, "
      "revolute, continuous, prismatic, ball, universal, revolute2 and screw\n"
      "error model:7: the joint `p` mimics the joint `pp`, which does not exist or is itself; "
      "the nearest name is `p`\n");
}

TEST(SdfModel, AMimicInANestedModelIsReportedOnce) {
  EXPECT_EQ(
      notes_of_model("<link name='l'/><model name='n'><link name='a'/><link name='b'/>"
                     "<joint name='j' type='revolute'><parent>a</parent><child>b</child>"
                     "<axis><mimic joint='far'/></axis></joint></model>"),
      "error model:1: the joint `j` mimics the joint `far`, which does not exist or is itself\n");
}

TEST(SdfModel, BeforeVersion17AJointMayHaveTheNameOfALink) {
  const std::string text =
      "<link name='a'/><link name='laser'><pose>0 0 1 0 0 0</pose></link>"
      "<joint name='laser' type='fixed'><pose>0 2 0 0 0 0</pose><parent>a</parent>"
      "<child>laser</child></joint>";
  const Model model = model_of(text, "1.6");
  ASSERT_EQ(model.joints.size(), 1U);
  EXPECT_EQ(model.joints[0].name, "laser");
  EXPECT_EQ(model.joints[0].child, "laser");
  expect_near(model.joints[0].pose, pose_of(0, 2, 0));
  const std::string twice =
      "error model:1: the name `laser` is used twice in the same model or world\n";
  EXPECT_EQ(notes_of_model(text), twice);
}

TEST(SdfModel, FramesThatDependOnEachOtherAreErrors) {
  const std::string notes = notes_of_model(
      "<link name='l'/><frame name='a' attached_to='b'/><frame name='b'><pose relative_to='c'/>"
      "</frame><frame name='c'><pose relative_to='a'/></frame>");
  EXPECT_EQ(notes, "error model:1: the place of `c` depends on itself, by way of `a`\n");
}

TEST(SdfModel, NumbersThatAreNoneAreErrors) {
  EXPECT_NE(notes_of_model("<link name='l'><pose>inf 0 0 0 0 0</pose></link>"), "");
  EXPECT_NE(notes_of_model("<link name='l'><pose>1e400 0 0 0 0 0</pose></link>"), "");
  EXPECT_NE(notes_of_model("<link name='l'><pose>0x10 0 0 0 0 0</pose></link>"), "");
  EXPECT_NE(notes_of_model("<link name='l'><inertial><mass>0</mass></inertial></link>"), "");
  EXPECT_NE(notes_of_model("<link name='l'/><link name='l'/>"), "");
  EXPECT_NE(notes_of_model("<link/>"), "");
  EXPECT_EQ(notes_of_model("<link name='l'><pose>1 2 3</pose></link>"),
            "warning model:1: <pose> has 3 numbers instead of 6, so its rotation counts as zero\n");
  EXPECT_EQ(notes_of_model("<link name='l'><inertial><mass>1</mass><inertia><izz>5</izz></inertia>"
                           "</inertial></link>")
                .compare(0, 8, "warning "),
            0);
}

TEST(SdfModel, TheFirstModelOrLightOfATextIsRead) {
  const auto model = [](const std::string& inside) {
    const Reading<Model> reading =
        read_model("<sdf version='1.6'>" + inside + "</sdf>", "", files({}));
    return reading.value ? reading.value->name : said(reading.notes);
  };
  EXPECT_EQ(model("<world name='w'><model name='a'><link name='l'/></model></world>"), "a");
  EXPECT_EQ(model("<light name='b' type='point'><pose>0 0 1 0 0 0</pose></light>"), "b");
  EXPECT_EQ(model("<include><uri>model://ground_plane</uri></include>"), "ground_plane");
  EXPECT_EQ(model("<include><uri>model://sun</uri></include>"), "sun");
  EXPECT_EQ(model(""), "error :1: the text has no <model> and no <light>\n");
}

}  // namespace
