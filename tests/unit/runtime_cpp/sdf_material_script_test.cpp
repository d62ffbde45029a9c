// Material scripts of Gazebo Classic: what is read of them, and how a world finds them.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "sdf/material_script.hpp"
#include "sdf/read_sdf.hpp"

namespace ros2wasm_sim {
namespace {

const std::string kScript = R"(
// material Mat/Line in a comment
/* material Mat/Line
{ } */
material Mat/Plain : Base { technique { pass { ambient 0.1 0.2 0.3 } } }
material "Mat/Line"
{
  receive_shadows off
  technique
  {
    pass first
    {
      diffuse 0.5 0.25 1 0.5   // shade
      texture_unit {
        texture line.png
        scale 2 2
      }
    }
    pass { diffuse 0 0 0 }
  }
}
)";

TEST(MaterialScript, FindsAMaterialByItsName) {
  const auto line = find_material(kScript, "Mat/Line");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->texture, "line.png");
  EXPECT_EQ(line->diffuse.b, 1);
  EXPECT_EQ(line->diffuse.a, 0.5);
  EXPECT_EQ(line->ambient.r, 1);  // what a script does not say is white
  const auto plain = find_material(kScript, "Mat/Plain");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->ambient.g, 0.2);
  EXPECT_TRUE(plain->texture.empty());
  EXPECT_FALSE(find_material(kScript, "Mat/Lin"));
}

TEST(MaterialScript, TakesAnyText) {
  for (const std::string text :
       {"", "material", "material M", "material M {", "}}} material M", "material M { diffuse 1",
        "/* material M", "material M { texture"}) {
    const auto found = find_material(text, "M");
    if (found) {
      EXPECT_TRUE(found->texture.empty()) << text;
    }
  }
}

TEST(MaterialScript, AWorldFindsItsScriptsAndPictures) {
  const std::map<std::string, std::string> files = {
      {"/m/track/materials/scripts/track.material", kScript},
      {"/m/track/materials/scripts/read.me", "material Mat/Line { }"},
      {"/m/track/materials/textures/line.png", ""},
      {"/m/track/materials/scripts", ""},
      {"/m/track/materials/textures", ""}};
  const auto find = [&](const std::string& uri,
                        std::vector<std::string>&) -> std::optional<std::string> {
    const std::string path = uri.rfind("model://", 0) == 0 ? "/m/" + uri.substr(8) : uri;
    return files.count(path) != 0 ? std::optional(path) : std::nullopt;
  };
  const auto read = [&](const std::string& path) -> std::optional<std::string> {
    return files.at(path);
  };
  const auto list = [&](const std::string& folder) {
    std::vector<std::string> inside;
    for (const auto& [path, text] : files)
      if (path.rfind(folder + "/", 0) == 0) inside.push_back(path);
    return inside;
  };
  const std::string world =
      R"(<sdf version="1.6"><world name="w"><model name="track"><link name="l">
    <visual name="v"><geometry><box><size>1 1 1</size></box></geometry><material><script>
      <uri>model://track/materials/scripts</uri><uri>model://track/materials/textures</uri>
      <name>Mat/Line</name></script></material></visual></link></model></world></sdf>)";
  const auto reading = read_world(world, "w.world", {find, read, list});
  ASSERT_TRUE(reading.value);
  EXPECT_TRUE(reading.notes.empty());
  const Material& material = reading.value->models.front().links.front().visuals.front().material;
  EXPECT_EQ(material.texture, "/m/track/materials/textures/line.png");
  EXPECT_EQ(material.diffuse.r, 0.5);
}

}  // namespace
}  // namespace ros2wasm_sim
