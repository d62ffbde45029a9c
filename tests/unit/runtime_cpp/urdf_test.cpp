// Descriptions of robots: what is read of them, and that no text brings the reader down.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>

#include "ros2wasm_xml/xml_document.hpp"
#include "urdf/model.h"

namespace {

using ros2wasm_xml::XmlDocument;
using ros2wasm_xml::XmlError;

const std::string kRobot = R"(<?xml version="1.0"?>
<!DOCTYPE robot>
<robot name="r&amp;d" xmlns:xacro="http://wiki.ros.org/xacro">
  <!-- <link name="not"/> -->
  <link name="a"><visual><geometry><mesh filename="package://m/&#x41;.stl" scale="1 2 3"/></geometry>
    <material name="red"><color rgba="1 0 0 1"/></material></visual>
    <collision><geometry><sphere radius="0.5"/></geometry></collision></link>
  <link name="b"><visual><origin xyz="1 2 3" rpy="0 0 1.5"/><geometry><cylinder radius="1" length="2"/>
    </geometry><material name="red"/></visual></link>
  <joint name="j" type="prismatic"><parent link="a"/><child link="b"/>
    <limit lower="-1" upper="1" effort="2" velocity="3"/><dynamics damping="4"/>
    <safety_controller k_velocity="5" soft_upper_limit="0.5"/></joint>
  <gazebo reference="a"><![CDATA[<not> &read]]></gazebo>
</robot>
)";

/// The first line that a description which is refused says.
std::string refusal(const std::string& text) {
  ::testing::internal::CaptureStderr();
  urdf::Model model;
  const bool was_read = model.initString(text);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(was_read, said.empty());
  EXPECT_EQ(was_read, !model.links_.empty());
  return said.empty() ? said : said.substr(9, said.find('\n') - 9);
}

std::string robot(const std::string& inside) {
  return "<robot name='r'>" + inside + "</robot>";
}

TEST(Urdf, ElementsKnowTheirLineAndColumn) {
  const XmlDocument document("<?xml version='1.0'?>\n<a>\n  <b/><c>\n</c>\n<!--\n--> <d\n/></a>");
  const auto place = [](const ros2wasm_xml::XmlElement& element) {
    return std::pair(element.line, element.column);
  };
  EXPECT_EQ(place(document.root()), std::pair(std::size_t{2}, std::size_t{1}));
  EXPECT_EQ(place(*document.child(document.root(), "b")),
            std::pair(std::size_t{3}, std::size_t{3}));
  EXPECT_EQ(place(*document.child(document.root(), "c")),
            std::pair(std::size_t{3}, std::size_t{7}));
  EXPECT_EQ(place(*document.child(document.root(), "d")),
            std::pair(std::size_t{6}, std::size_t{5}));
}

TEST(Urdf, ADescriptionBecomesAModel) {
  urdf::Model model;
  ASSERT_TRUE(model.initString(kRobot));
  EXPECT_EQ(model.getName(), "r&d");
  EXPECT_EQ(model.links_.size(), 2U);
  const auto a = model.getLink("a");
  const auto mesh = urdf::dynamic_pointer_cast<urdf::Mesh>(a->visual->geometry);
  EXPECT_EQ(mesh->filename, "package://m/A.stl");
  EXPECT_EQ(mesh->scale.z, 3);
  EXPECT_EQ(a->collision_array.size(), 1U);
  const auto b = model.getLink("b");
  EXPECT_EQ(b->visual->material, a->visual->material);
  EXPECT_EQ(b->visual->origin.position.z, 3);
  const auto joint = model.getJoint("j");
  EXPECT_EQ(joint->axis.x, 1);
  EXPECT_EQ(joint->dynamics->damping, 4);
  EXPECT_EQ(joint->safety->soft_upper_limit, 0.5);
  EXPECT_EQ(model.getRoot(), a);
}

TEST(Urdf, WhatIsNoTreeOfLinksIsRefused) {
  const std::string fixed = "' type='fixed'><parent link='";
  const auto joint = [&](const std::string& name, const std::string& parent,
                         const std::string& child) {
    return "<joint name='" + name + fixed + parent + "'/><child link='" + child + "'/></joint>";
  };
  const std::string links = "<link name='a'/><link name='b'/><link name='c'/>";
  EXPECT_EQ(refusal(robot("<link name='a'/>")), "");
  EXPECT_EQ(refusal("<machine/>"), "Could not find the 'robot' element in the xml file");
  EXPECT_EQ(refusal("<robot/>"), "No name given for the robot.");
  EXPECT_EQ(refusal(robot("")), "No link elements found in urdf file");
  EXPECT_EQ(refusal(robot(links)), "Two root links found: [a] and [b]");
  EXPECT_EQ(
      refusal(robot(links + joint("x", "a", "b") + joint("y", "b", "c") + joint("z", "c", "a"))),
      "No root link found. The robot xml is not a valid tree.");
  EXPECT_EQ(refusal(robot(links + joint("x", "b", "c") + joint("y", "c", "b"))),
            "link 'b' is its own ancestor");
  EXPECT_EQ(
      refusal(robot(links + joint("x", "a", "b") + joint("y", "a", "c") + joint("z", "b", "c"))),
      "link 'c' has two parents");
  EXPECT_EQ(refusal(robot("<link name='a'/><link name='a'/>")), "link 'a' is not unique.");
  EXPECT_EQ(refusal(robot("<link name='a'/>" + joint("x", "a", "d"))),
            "child link [d] of joint [x] not found");
}

TEST(Urdf, WhatIsMissingIsNamed) {
  const auto link = [](const std::string& inside) {
    return robot("<link name='a'>" + inside + "</link>");
  };
  EXPECT_EQ(refusal(link("<inertial/>")), "Inertial element must have a mass element");
  EXPECT_EQ(refusal(link("<visual/>")), "Geometry tag contains no child element.");
  EXPECT_EQ(refusal(link("<visual><geometry><box size='1 2'/></geometry></visual>")),
            "Parser found 2 elements but 3 expected while parsing vector [1 2]");
  EXPECT_EQ(refusal(link("<visual><geometry><cone/></geometry></visual>")),
            "Unknown geometry type 'cone'");
  EXPECT_EQ(refusal(link("<visual><geometry><sphere radius='r'/></geometry></visual>")),
            "Sphere shape radius value (r) is not a valid float");
  EXPECT_EQ(refusal(robot("<joint name='j' type='revolute'/>")).substr(0, 4), "No l");
  EXPECT_EQ(refusal(robot("<link name='a'/><joint name='j' type='revolute'/>")),
            "Joint j is of type REVOLUTE but it does not specify limits");
  EXPECT_EQ(refusal(robot("<link name='a'/><joint name='j' type='odd'/>")),
            "Joint j has no known type odd");
}

TEST(Xml, OnlyXmlIsRead) {
  EXPECT_EQ(XmlDocument("<a> x <b/>y</a>").root().text, " x y");
  EXPECT_EQ(*XmlDocument("<a b='&#228;&lt;'/>").root().attribute("b"), "\xC3\xA4<");
  for (const char* text : {"",
                           "x",
                           "<a>",
                           "<a></b>",
                           "<a/><b/>",
                           "<a/>x",
                           "<a b/>",
                           "<a b=c/>",
                           "<a b='<'/>",
                           "<a b='' b=''/>",
                           "<a>&none;</a>",
                           "<a>&#xD800;</a>",
                           "<a>& </a>",
                           "<a",
                           "<a b='",
                           "<!--",
                           "<a><![CDATA[</a>",
                           "<!DOCTYPE a [<!ENTITY b 'c'>]><a/>",
                           "</a>",
                           "<a>&#99999999999;</a>"})
    EXPECT_THROW(XmlDocument{text}, XmlError) << text;
}

TEST(Xml, NoTextBringsTheReaderDown) {
  for (std::size_t end = 0; end < kRobot.size() - 1; ++end) {
    if (kRobot.find("</robot>") + 8 > end) {
      EXPECT_THROW(XmlDocument(kRobot.substr(0, end)), XmlError) << end;
    }
  }
  const int deep = 200'000;
  std::string nested;
  for (int i = 0; i < deep; ++i) nested += "<a>";
  EXPECT_THROW(XmlDocument{nested}, XmlError);
  for (int i = 0; i < deep; ++i) nested += "</a>";
  EXPECT_EQ(XmlDocument(nested).root().children.size(), 1U);

  std::mt19937 random(20);
  const std::string special = "<>/='\"&;![]-? \n";
  for (int i = 0; i < 500; ++i) {
    std::string text = kRobot;
    for (unsigned changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) {
        text[at] = special[random() % special.size()];
      } else {
        text.erase(at, 1 + random() % 9);
      }
    }
    refusal(text);
  }
}

/// A mast on a base, which turns, with a camera in its own frame.
const std::string kSdf = R"(<sdf version="1.9"><model name="mast">
  <link name="base"><inertial><mass>4</mass></inertial></link>
  <link name="pole"><pose relative_to="turn">0 0 0.5 0 0 0</pose>
    <visual name="look"><geometry><cylinder><radius>.1</radius><length>1</length></cylinder></geometry></visual></link>
  <link name="eye"><pose>0 1 2 0 0 0</pose></link>
  <joint name="turn" type="revolute"><pose relative_to="base">0 1 0 0 0 1.5707963267948966</pose>
    <parent>base</parent><child>pole</child><axis><xyz expressed_in="__model__">1 0 0</xyz></axis></joint>
  <joint name="hold" type="fixed"><parent>pole</parent><child>eye</child></joint>
</model></sdf>)";

TEST(Urdf, ReadsAModelOfSdf) {
  urdf::Model model;
  ASSERT_TRUE(model.initString(kSdf));
  EXPECT_EQ(model.getName(), "mast");
  EXPECT_EQ(model.getRoot()->name, "base");
  EXPECT_EQ(model.getRoot()->inertial->mass, 4);
  const auto turn = model.getJoint("turn");
  EXPECT_EQ(turn->type, urdf::Joint::CONTINUOUS);  // without limits
  EXPECT_NEAR(turn->parent_to_joint_origin_transform.position.y, 1, 1e-9);
  // The axis along x of the model is seen from a joint that is turned by a quarter.
  EXPECT_NEAR(turn->axis.y, -1, 1e-9);
  // The frame of the pole is that of its joint, half a metre below its own middle.
  EXPECT_NEAR(model.getLink("pole")->visual->origin.position.z, 0.5, 1e-9);
  // The eye is at (0, 1, 2), above the joint at (0, 1, 0).
  const auto& hold = model.getJoint("hold")->parent_to_joint_origin_transform;
  EXPECT_NEAR(hold.position.x, 0, 1e-9);
  EXPECT_NEAR(hold.position.y, 0, 1e-9);
  EXPECT_NEAR(hold.position.z, 2, 1e-9);
}

TEST(Urdf, RefusesSdfThatIsNoRobot) {
  EXPECT_EQ(refusal("<sdf version='1.9'><world name='w'/></sdf>"),
            "SDF needs one <model> for a robot, not 0");
  EXPECT_EQ(refusal("<sdf version='1.9'><model name='m'><link name='a'><pose "
                    "relative_to='b'/></link></model></sdf>"),
            "the frame 'b' does not exist in the model");
  EXPECT_EQ(refusal("<sdf version='1.9'><model name='m'><link name='a'><pose relative_to='b'/>"
                    "</link><link name='b'><pose relative_to='a'/></link></model></sdf>"),
            "the pose of 'a' is relative to itself");
}

}  // namespace
