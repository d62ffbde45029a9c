// Meshes of files: STL, OBJ and COLLADA, and texts that mean harm.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "mesh/dae.hpp"
#include "mesh/obj.hpp"
#include "mesh/stl.hpp"
#include "mesh/submesh.hpp"

namespace ros2wasm_sim {
namespace {

TEST(MeshFiles, StlInTextAndBytes) {
  const std::string text =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid\n";
  const auto read = read_stl(text, 10);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->vertices.size(), 9U);
  EXPECT_EQ(read->faces, (std::vector<int>{0, 1, 2}));
  EXPECT_FALSE(read_stl(text, 0));
  // A normal and three corners; two of them are equal, so they become one vertex.
  const float numbers[12] = {9, 9, 9, 1, 2, 3, 4, 5, 6, 1, 2, 3};
  std::string bytes(84 + 50, '\0');
  bytes[80] = 1;
  std::memcpy(bytes.data() + 84, numbers, sizeof numbers);
  const auto binary = read_stl(bytes, 10);
  ASSERT_TRUE(binary);
  EXPECT_EQ(binary->vertices, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(binary->faces, (std::vector<int>{0, 1, 0}));
  EXPECT_FALSE(read_stl(bytes, 0));
  bytes[80] = 2;
  EXPECT_FALSE(read_stl(bytes, 10));  // shorter than it says
  EXPECT_FALSE(read_stl("", 10));
}

TEST(MeshFiles, ObjWithPolygonsAndNumbersFromTheEnd) {
  const auto read = read_obj(
      "# a square\nv 0 0 0\r\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 -2 4/1/1\n", 10);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->vertices.size(), 12U);
  EXPECT_EQ(read->faces, (std::vector<int>{0, 1, 2, 0, 2, 3}));
  for (const char* wrong :
       {"", "v 0 0\nf 1 1 1\n", "v 0 0 0\nf 1 2 3\n", "v 0 0 0\nf 0 1 1\n", "v nan 0 0\nf 1 1 1\n"})
    EXPECT_FALSE(read_obj(wrong, 10)) << wrong;
  EXPECT_FALSE(read_obj("v 0 0 0\nf 1 1 1\nf 1 1 1\n", 1));
}

std::string collada(const std::string& nodes, const std::string& faces) {
  return "<COLLADA><asset><unit "
         "meter=\"0.01\"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry "
         "id=\"g\"><mesh>"
         "<source id=\"p\"><float_array>0 0 0 100 0 0 100 100 0 0 100 0</float_array></source>"
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>" +
         faces + "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene>" +
         nodes + "</visual_scene></library_visual_scenes></COLLADA>";
}
const std::string kTriangles =
    "<triangles><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><input semantic=\"NORMAL\" "
    "source=\"#n\" "
    "offset=\"1\"/><p>0 0 1 0 2 0</p></triangles>";
const std::string kPolygons =
    "<polylist><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><vcount>4</vcount><p>0 1 2 "
    "3</p></polylist>";

TEST(MeshFiles, ColladaWhereItsSceneHasIt) {
  const auto read = read_dae(collada("<node><translate>0 0 50</translate><rotate>0 0 1 "
                                     "90</rotate><instance_geometry url=\"#g\"/></node>",
                                     kTriangles + kPolygons),
                             10);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->faces, (std::vector<int>{0, 1, 2, 0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(read->vertices.size(), 12U);  // Both lists of faces share their source.
  const std::vector<float> expected{0, 0, 0.5F, 0, 1, 0.5F, -1, 1, 0.5F};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(read->vertices[i], expected[i], 1e-6) << i;
}

TEST(MeshFiles, AnObjectOfAnObjFileIsASubmesh) {
  const auto whole = read_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\no left\nf 1 2 3\n"
      "v 5 0 0\nv 7 0 0\nv 5 4 2\no right wing\ng panel\nf 4 5 6\nf 4 6 5\n",
      10, {});
  ASSERT_TRUE(whole);
  const auto right = submesh_of(*whole, "right wing", false);
  ASSERT_TRUE(right);
  EXPECT_EQ(right->vertices, (std::vector<float>{5, 0, 0, 7, 0, 0, 5, 4, 2}));
  EXPECT_EQ(right->faces, (std::vector<int>{0, 1, 2, 0, 2, 1}));
  const auto centered = submesh_of(*whole, "panel", true);
  ASSERT_TRUE(centered);
  EXPECT_EQ(centered->vertices, (std::vector<float>{-1, -2, -1, 1, -2, -1, -1, 2, 1}));
  EXPECT_FALSE(submesh_of(*whole, "tail", false));
  EXPECT_EQ(object_names(*whole), "left, panel, right wing");
}

TEST(MeshFiles, ANodeOfColladaIsASubmesh) {
  const std::string nodes =
      "<node name=\"base\"><instance_geometry url=\"#g\"/></node>"
      "<node name=\"lid\"><translate>0 0 5</translate><node>"
      "<instance_geometry url=\"#g\"/></node></node>";
  const auto whole = read_dae(collada(nodes, kTriangles), 10);
  ASSERT_TRUE(whole);
  const auto lid = submesh_of(*whole, "lid", false);
  ASSERT_TRUE(lid);
  EXPECT_EQ(2 * lid->faces.size(), whole->faces.size());
  const auto base = submesh_of(*whole, "base", false);
  ASSERT_TRUE(base);
  ASSERT_EQ(base->vertices.size(), lid->vertices.size());
  for (std::size_t i = 2; i < base->vertices.size(); i += 3)
    EXPECT_GT(lid->vertices[i], base->vertices[i]);
}

TEST(MeshFiles, ASubmeshKeepsItsColours) {
  const ReadBeside materials = [](const std::string&) {
    return std::optional<std::string>("newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  };
  const auto whole = read_obj(
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\no one\nf 1 2 3\n"
      "o two\nf 1 2 3\nusemtl blue\nf 1 2 3\n",
      10, materials);
  ASSERT_TRUE(whole);
  const auto two = submesh_of(*whole, "two", false);
  ASSERT_TRUE(two);
  ASSERT_EQ(two->parts.size(), 2U);
  EXPECT_EQ(two->parts[0].first_face, 0U);
  EXPECT_EQ(two->parts[0].diffuse->r, 1);
  EXPECT_EQ(two->parts[1].first_face, 1U);
  EXPECT_EQ(two->parts[1].diffuse->b, 1);
}

TEST(MeshFiles, ObjHasTheColoursOfItsMaterials) {
  const std::string text =
      "mtllib the colours.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0.25\nf 1 2 3\nusemtl "
      "red\nf 1/1 2/2 3/2\nusemtl unknown\nf 1 2 3\n";
  const auto read = read_obj(text, 10, [](const std::string& name) {
    EXPECT_EQ(name, "the colours.mtl");
    return std::optional<std::string>(
        "Kd 9 9 9\nnewmtl red\nKd 1 0.5 0\nd 0.25\nmap_Kd red brick.png\n");
  });
  ASSERT_TRUE(read);
  ASSERT_EQ(read->parts.size(), 3U);
  EXPECT_FALSE(read->parts[0].diffuse);
  EXPECT_EQ(read->parts[1].first_face, 1U);
  EXPECT_EQ(read->parts[1].diffuse->g, 0.5);
  EXPECT_EQ(read->parts[1].diffuse->a, 0.25);
  EXPECT_EQ(read->parts[1].texture, "red brick.png");
  EXPECT_EQ(read->parts[2].first_face, 2U);
  EXPECT_FALSE(read->parts[2].diffuse);
  ASSERT_EQ(read->uvs.size(), 2 * read->faces.size());
  EXPECT_EQ(read->uvs[6], 0);
  EXPECT_EQ(read->uvs[7], 1);
  EXPECT_EQ(read->uvs[8], 1);
  EXPECT_EQ(read->uvs[9], 0.75);
  // Without its materials it is read too.
  EXPECT_TRUE(read_obj(text, 10, [](const std::string&) { return std::nullopt; })->parts.empty());
}

TEST(MeshFiles, ColladaHasTheColoursOfItsMaterials) {
  const std::string materials =
      "<library_images><image id=\"i\"><init_from> ./wood.jpg </init_from></image></library_images>"
      "<library_effects><effect id=\"e\"><profile_COMMON><technique><phong><diffuse><color>0 0.5 1 "
      "1</color></diffuse></phong></technique></profile_COMMON></effect><effect "
      "id=\"f\"><profile_COMMON><newparam sid=\"s\"><surface><init_from>i</init_from></surface>"
      "</newparam><newparam sid=\"t\"><sampler2D><source>s</source></sampler2D></newparam>"
      "<technique><lambert><diffuse><texture texture=\"t\"/></diffuse></lambert></technique>"
      "</profile_COMMON></effect></library_effects><library_materials><material "
      "id=\"m\"><instance_effect url=\"#e\"/></material><material id=\"n\"><instance_effect "
      "url=\"#f\"/></material></library_materials>";
  const std::string faces =
      "<source id=\"w\"><float_array>0 0 0.5 1</float_array></source><triangles material=\"blue\">"
      "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p></triangles><triangles "
      "material=\"wood\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><input "
      "semantic=\"TEXCOORD\" source=\"#w\" offset=\"1\"/><p>0 0 1 1 2 1</p></triangles>";
  std::string text = collada(
      "<node><instance_geometry url=\"#g\"><bind_material><technique_common><instance_material "
      "symbol=\"blue\" target=\"#m\"/><instance_material symbol=\"wood\" "
      "target=\"#n\"/></technique_common></bind_material></instance_geometry></node>",
      faces);
  text.insert(text.find("<library_geometries>"), materials);
  const auto read = read_dae(text, 10);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->parts.size(), 2U);
  EXPECT_EQ(read->parts[0].diffuse->b, 1);
  EXPECT_EQ(read->parts[0].diffuse->g, 0.5);
  EXPECT_EQ(read->parts[1].first_face, 1U);
  EXPECT_EQ(read->parts[1].texture, "wood.jpg");
  ASSERT_EQ(read->uvs.size(), 12U);
  EXPECT_EQ(read->uvs[8], 0.5);
  EXPECT_EQ(read->uvs[9], 0);
}

TEST(MeshFiles, ColladaThatMeansHarmEnds) {
  const std::string once = "<node><instance_geometry url=\"#g\"/></node>";
  EXPECT_FALSE(read_dae(collada(once, kTriangles), 0));
  EXPECT_FALSE(read_dae("<COLLADA/>", 10));
  EXPECT_FALSE(read_dae("no", 10));
  const std::string outside =
      "<triangles><input semantic=\"VERTEX\" source=\"#v\"/><p>0 1 9</p></triangles>";
  EXPECT_FALSE(read_dae(collada(once, outside), 10));
  const std::string short_list =
      "<polylist><input semantic=\"VERTEX\" source=\"#v\"/><vcount>9</vcount><p>0 1</p></polylist>";
  EXPECT_FALSE(read_dae(collada(once, short_list), 10));
  // A node within itself.
  const std::string circle =
      "<COLLADA><library_nodes><node id=\"n\"><instance_node url=\"#n\"/><instance_node "
      "url=\"#n\"/>"
      "</node></library_nodes><library_visual_scenes><visual_scene><node><instance_node "
      "url=\"#n\"/>"
      "</node></visual_scene></library_visual_scenes></COLLADA>";
  EXPECT_FALSE(read_dae(circle, 10));
  // One node that places a geometry many times.
  std::string many = "<node>";
  for (int i = 0; i < 50'000; ++i) many += "<instance_geometry url=\"#g\"/>";
  EXPECT_FALSE(read_dae(collada(many + "</node>", kTriangles), 200'000));
}

}  // namespace
}  // namespace ros2wasm_sim
