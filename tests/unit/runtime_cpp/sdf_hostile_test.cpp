// Texts that are broken or meant to break the readers of worlds and models.
#include <chrono>
#include <random>

#include "sdf_texts.hpp"

namespace {

using namespace sdf_texts;

const std::string kWorld = R"(<?xml version="1.0"?>
<sdf version="1.9"><world name="w"><gravity>0 0 -9.8</gravity>
  <include><uri>model://sun</uri></include><include><uri>model://a</uri><name>n</name></include>
  <frame name="f" attached_to="m"/>
  <model name="m" placement_frame="l"><pose relative_to="f2" degrees="true">1 2 3 4 5 6</pose>
    <link name="l"><inertial auto="true"/><collision name="c"><geometry><box><size>1 1 1</size></box>
      </geometry></collision><sensor name="s" type="ray"><plugin name="p" filename="f"/></sensor></link>
    <model name="i"><pose rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose><link name="k"/></model>
    <joint name="j" type="revolute"><parent>l</parent><child>i::k</child><axis>
      <xyz expressed_in="i">0 0 1</xyz><limit><lower>-1e16</lower><upper>inf</upper></limit></axis>
    </joint></model>
  <frame name="f2"/><state><model name="m"><pose>0 0 0 0 0 0</pose></model></state></world></sdf>)";

const std::string kRobot = R"(<robot name="r"><link name="base"/>
  <link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
    </inertial><collision><geometry><box size="1 2 3"/></geometry></collision>
    <visual name="v"><origin xyz="0 0 1" rpy="0 0 1"/><geometry><mesh filename="package://a/b.stl"/>
    </geometry><material name="red"><color rgba="1 0 0 1"/></material></visual></link>
  <link name="b"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
    </inertial></link><joint name="j" type="fixed"><parent link="base"/><child link="a"/></joint>
  <joint name="k" type="revolute"><parent link="a"/><child link="b"/><limit lower="0" upper="1"
    effort="1" velocity="1"/><mimic joint="k2"/></joint>
  <gazebo reference="a"><mu1>0.5</mu1><material>Gazebo/Red</material><sensor name="c" type="contact">
    <contact><collision>a_collision</collision></contact></sensor></gazebo>
  <gazebo reference="j"><preserveFixedJoint>no</preserveFixedJoint></gazebo>
  <gazebo><plugin name="p" filename="f"/></gazebo></robot>)";

std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> kWords = {
      "nan",       "inf",   "-1e999", "<",     ">",     "</",   "/>",   "\"",   "world",
      "__model__", "::",    "m",      "l",     "i",     "f",    "f2",   "base", "a",
      "b",         "model", "link",   "joint", "frame", "true", "&lt;", "&#0;", "0"};
  const auto below = [&random](std::size_t limit) {
    return random() % std::max<std::size_t>(1, limit);
  };
  for (std::size_t count = 1 + below(4); count > 0 && !text.empty(); --count) {
    const std::size_t at = below(text.size());
    const std::size_t size = below(20);
    switch (below(5)) {
      case 0:
        text.resize(at);
        break;
      case 1:
        text[at] = static_cast<char>(random());
        break;
      case 2:
        text.erase(at, size);
        break;
      case 3:
        text.replace(at, std::min(size, text.size() - at), kWords[below(kWords.size())]);
        break;
      default:
        text.insert(at, text.substr(below(text.size()), 10 * size));
    }
  }
  return text;
}

/// The value is missing exactly when there is an error, whatever the text is.
template <typename T>
void expect_sound(const Reading<T>& reading, const std::string& text) {
  bool has_error = false;
  for (const Note& note : reading.notes) {
    has_error = has_error || note.severity == Severity::kError;
    EXPECT_FALSE(note.text.empty());
  }
  EXPECT_EQ(reading.value.has_value(), !has_error) << text;
}

bool is_finite(const Pose& pose) {
  return std::isfinite(length(pose.position)) &&
         std::fabs(pose.orientation.w * pose.orientation.w +
                   pose.orientation.x * pose.orientation.x +
                   pose.orientation.y * pose.orientation.y +
                   pose.orientation.z * pose.orientation.z - 1) < 1e-6;
}

void expect_finite(const Model& model, const std::string& text) {
  EXPECT_TRUE(is_finite(model.pose)) << text;
  for (const Link& link : model.links) {
    EXPECT_TRUE(is_finite(link.pose)) << text;
    EXPECT_TRUE(std::isfinite(link.inertial.mass) && is_finite(link.inertial.pose)) << text;
    for (const Collision& collision : link.collisions) {
      EXPECT_TRUE(is_finite(collision.pose)) << text;
    }
  }
  for (const Joint& joint : model.joints) {
    EXPECT_TRUE(is_finite(joint.pose)) << text;
    for (const JointAxis& axis : joint.axes) {
      EXPECT_NEAR(length(axis.xyz), 1, 1e-9) << text;
      EXPECT_LE(axis.lower, axis.upper) << text;
    }
  }
}

TEST(SdfHostile, NoTextBringsTheReadersDown) {
  std::mt19937 random(7);
  const Resources resources = files({{"/models/a/model.sdf", model_text("<link name='l'/>")}});
  for (int i = 0; i < 6'000; ++i) {
    const std::string world = mutated(kWorld, random);
    const Reading<World> read = read_world(world, "w", resources);
    expect_sound(read, world);
    for (const Model& model : read.value.value_or(World()).models) {
      expect_finite(model, world);
    }
    const std::string robot = mutated(random() % 4 == 0 ? kWorld : kRobot, random);
    const Reading<Model> model = read_model(robot, "m", resources);
    expect_sound(model, robot);
    if (model.value) {
      expect_finite(*model.value, robot);
    }
  }
}

TEST(SdfHostile, EachTruncationIsReportedOrRead) {
  for (std::size_t size = 0; size <= kWorld.size(); size += 3) {
    expect_sound(read_world(kWorld.substr(0, size), "w", files({})), "");
  }
  for (std::size_t size = 0; size <= kRobot.size(); size += 3) {
    expect_sound(read_model(kRobot.substr(0, size), "m", files({})), "");
  }
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
}

TEST(SdfHostile, DeepTextsEndInAnError) {
  const std::string deep =
      repeated("<model name='m'><link name='l'/>", 20'000) + repeated("</model>", 20'000);
  const Reading<World> world = read_world(world_text(deep), "w", files({}));
  EXPECT_NE(said(world.notes).find("nested more than 32 deep"), std::string::npos);
  const std::string sensor =
      "<link name='l'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
      "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link><gazebo "
      "reference='l'><sensor name='s' type='contact'>" +
      repeated("<a>", 50'000) + repeated("</a>", 50'000) + "</sensor></gazebo>";
  expect_sound(read_model("<robot name='r'>" + sensor + "</robot>", "r", files({})), "deep");
}

TEST(SdfHostile, LongChainsAreQuick) {
  const auto begin = std::chrono::steady_clock::now();
  std::string frames = "<link name='l'/>";
  std::string loop = frames;
  std::string robot;
  std::string unknown = frames;
  for (int i = 0; i < 10'000; ++i) {
    const std::string name = std::to_string(i);
    const std::string next = std::to_string(i + 1);
    frames += "<frame name='f" + name + "'><pose relative_to='" + (i == 9'999 ? "l" : "f" + next) +
              "'>1 0 0 0 0 0</pose></frame>";
    loop += "<frame name='f" + name + "' attached_to='f" + std::to_string((i + 1) % 10'000) + "'/>";
    unknown += "<frame name='g" + name + "' attached_to='h" + name + "'/>";
    robot +=
        "<link name='l" + name +
        "'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' "
        "ixy='0' ixz='0' iyz='0'/></inertial><collision><geometry><sphere radius='1'/></geometry>"
        "</collision></link><joint name='j" +
        name + "' type='fixed'><parent link='l" + name + "'/><child link='l" + next +
        "'/><origin xyz='1 0 0'/></joint>";
  }
  const Reading<Model> chain = read_model(model_text(frames), "m", files({}));
  ASSERT_TRUE(chain.value.has_value()) << said(chain.notes);
  expect_near(chain.value->frames[0].pose, pose_of(10'000, 0, 0));
  EXPECT_FALSE(read_model(model_text(loop), "m", files({})).value.has_value());
  const Reading<Model> many = read_model(model_text(unknown), "m", files({}));
  EXPECT_LT(many.notes.size(), 300U);
  robot += "<link name='l10000'/>";
  const Reading<Model> lumped = read_model("<robot name='r'>" + robot + "</robot>", "r", files({}));
  ASSERT_TRUE(lumped.value.has_value()) << said(lumped.notes);
  EXPECT_EQ(lumped.value->links.size(), 1U);
  EXPECT_EQ(lumped.value->links[0].collisions.size(), 10'000U);
  EXPECT_NEAR(lumped.value->links[0].inertial.mass, 10'000, 1e-6);
  const auto end = std::chrono::steady_clock::now();
  EXPECT_LT(std::chrono::duration<double>(end - begin).count(), 10);
}

TEST(SdfHostile, LongNamesAreErrors) {
  const std::string name(100'000, 'n');
  const std::string error = "has more than 500 bytes";
  EXPECT_NE(notes_of_model("<link name='" + name + "'/>").find(error), std::string::npos);
  EXPECT_NE(notes_of_world("<include><uri>model://sun</uri><name>" + name + "</name></include>")
                .find(error),
            std::string::npos);
  // A mistake in the XML quotes its element.
  EXPECT_LT(said(read_world("<" + name, "w", files({})).notes).size(), 2'100U);
}

TEST(SdfHostile, ManyAttributesOfOneElementAreAnError) {
  std::string attributes;
  for (int i = 0; i < 100'000; ++i) {
    attributes += " a" + std::to_string(i) + "=''";
  }
  EXPECT_EQ(said(read_world("<sdf" + attributes + "/>", "w", files({})).notes),
            "error w:1: the text is not XML: sdf has more than 1000 attributes\n");
}

TEST(SdfHostile, LongNamesOfManyPartsAreQuick) {
  const std::string name = repeated("a::", 100'000);
  EXPECT_NE(notes_of_model("<link name='a'/><model name='b'><link name='a'/></model>"
                           "<frame name='f' attached_to='" +
                           name + "'/>"),
            "");
}

}  // namespace
