// Worlds of SDF: settings, models, includes and what is wrong with them.
#include <chrono>

#include "sdf/fuel.hpp"
#include "sdf_texts.hpp"

namespace {

using namespace sdf_texts;

const std::string kBoxLink =
    "<link name='link'><collision name='c'><geometry><box><size>1 2 3</size></box></geometry>"
    "</collision></link>";

std::string box(const std::string& name, const std::string& pose) {
  return "<model name='" + name + "'><pose>" + pose + "</pose>" + kBoxLink + "</model>";
}

TEST(SdfWorld, AClassicWorldHasSunGroundAndWall) {
  const World world = world_of(R"(
    <include><uri>model://sun</uri></include>
    <include><uri>model://ground_plane</uri></include>
    <model name="wall"><static>true</static><pose>3.05 0 0.5 0 0 0</pose>
      <link name="link">
        <collision name="c"><geometry><box><size>0.1 4 1</size></box></geometry></collision>
        <visual name="v"><geometry><box><size>0.1 4 1</size></box></geometry>
          <material><script><uri>file://media/materials/scripts/gazebo.material</uri>
            <name>Gazebo/Red</name></script></material></visual>
      </link>
    </model>)",
                               {}, "1.6");
  EXPECT_EQ(world.name, "w");
  EXPECT_EQ(world.gravity.z, -9.8);
  ASSERT_EQ(world.lights.size(), 1U);
  EXPECT_EQ(world.lights[0].type, "directional");
  expect_near(world.lights[0].direction, {-0.5, 0.1, -0.9});
  EXPECT_EQ(world.lights[0].pose.position.z, 10);
  EXPECT_TRUE(world.lights[0].cast_shadows);
  EXPECT_EQ(world.lights[0].diffuse.r, 0.8);
  ASSERT_EQ(world.models.size(), 2U);
  const Model& ground = world.models[0];
  EXPECT_EQ(ground.name, "ground_plane");
  EXPECT_TRUE(ground.is_static);
  EXPECT_EQ(ground.links[0].collisions[0].surface.mu, 100);
  EXPECT_EQ(ground.links[0].collisions[0].surface.mu2, 50);
  EXPECT_EQ(std::get<Plane>(ground.links[0].collisions[0].geometry).width, 100);
  EXPECT_EQ(ground.links[0].visuals[0].material.ambient.r, 0.3);
  const Model& wall = world.models[1];
  expect_near(wall.pose, pose_of(3.05, 0, 0.5));
  EXPECT_EQ(std::get<Box>(wall.links[0].collisions[0].geometry).size, (Vector3{0.1, 4, 1}));
  EXPECT_EQ(wall.links[0].visuals[0].material.diffuse.g, 0);
  EXPECT_EQ(wall.canonical_link, "link");
}

TEST(SdfWorld, FuelAddressesOfSunAndGroundAreBuiltIn) {
  const World world = world_of(R"(
    <include><uri>https://fuel.gazebosim.org/1.0/OpenRobotics/models/Sun</uri></include>
    <include><uri>https://fuel.ignitionrobotics.org/1.0/OpenRobotics/models/Ground%20Plane/2</uri>
      <name>floor</name><pose>0 0 -1 0 0 0</pose></include>)");
  EXPECT_EQ(world.lights.size(), 1U);
  ASSERT_EQ(world.models.size(), 1U);
  EXPECT_EQ(world.models[0].name, "floor");
  EXPECT_EQ(world.models[0].pose.position.z, -1);
}

TEST(SdfWorld, SettingsAreReadWithTheirDefaults) {
  const World world = world_of(R"(
    <gravity>0 0 -1.6</gravity><magnetic_field>1 2 3</magnetic_field>
    <physics name="a" type="ode"><max_step_size>0.01</max_step_size></physics>
    <physics name="b" type="ode" default="true"><max_step_size>0.002</max_step_size>
      <real_time_factor>0</real_time_factor><real_time_update_rate>500</real_time_update_rate>
    </physics>
    <scene><ambient>1 0.5 0</ambient><shadows>0</shadows><grid>false</grid></scene>
    <spherical_coordinates><latitude_deg>47.5</latitude_deg><longitude_deg>8</longitude_deg>
      <elevation>400</elevation><heading_deg>90</heading_deg></spherical_coordinates>
    <plugin name="p" filename="libp.so"><x>1</x></plugin><gui/><audio/>)");
  EXPECT_EQ(world.gravity.z, -1.6);
  EXPECT_EQ(world.magnetic_field.y, 2);
  EXPECT_EQ(world.physics.max_step_size, 0.002);
  EXPECT_EQ(world.physics.real_time_factor, 0);
  EXPECT_EQ(world.physics.real_time_update_rate, 500);
  EXPECT_EQ(world.scene.ambient.g, 0.5);
  EXPECT_EQ(world.scene.background.g, 0.7);
  EXPECT_FALSE(world.scene.shadows);
  EXPECT_FALSE(world.scene.grid);
  ASSERT_TRUE(world.spherical.has_value());
  EXPECT_EQ(world.spherical->heading_deg, 90);
  ASSERT_EQ(world.plugins.size(), 1U);
  EXPECT_EQ(world.plugins[0].filename, "libp.so");
  const XmlView& xml = world.plugins[0].xml;
  EXPECT_EQ(xml.document->child(*xml.element, "x")->text, "1");
  // Up to version 1.5 gravity was in <physics>.
  EXPECT_EQ(
      world_of("<physics type='ode'><gravity>0 0 -5</gravity></physics>", {}, "1.4").gravity.z, -5);
  EXPECT_FALSE(world_of("").physics.real_time_update_rate.has_value());
}

TEST(SdfWorld, ASavedStateMovesModelsAndLights) {
  const World world = world_of(box("a", "1 0 0 0 0 0") + box("b", "2 0 0 0 0 0") +
                               "<light name='l' type='point'><pose>0 0 1 0 0 0</pose></light>"
                               "<state world_name='w'><model name='b'><pose frame=''>5 6 7 0 0 0"
                               "</pose><link name='link'><pose>5 6 7 0 0 0</pose></link></model>"
                               "<light name='l'><pose>0 0 9 0 0 0</pose></light></state>");
  EXPECT_EQ(world.models[0].pose.position.x, 1);
  expect_near(world.models[1].pose, pose_of(5, 6, 7));
  expect_near(world.models[1].links[0].pose, pose_of(0, 0, 0));
  EXPECT_EQ(world.lights[0].pose.position.z, 9);
}

TEST(SdfWorld, ModelsMayBeRelativeToFramesAndModels) {
  const World world = world_of(
      "<frame name='f'><pose>1 0 0 0 0 1.5707963267948966</pose></frame>"
      "<frame name='g' attached_to='f'><pose>1 0 0 0 0 0</pose></frame>"
      "<model name='a'><pose relative_to='b::link'>0 0 1 0 0 0</pose>" +
      kBoxLink + "</model><model name='b'><pose relative_to='g'>0 1 0 0 0 0</pose>" + kBoxLink +
      "</model><light name='l' type='point'><pose relative_to='a'>0 0 1 0 0 0</pose></light>");
  expect_near(world.models[1].pose, pose_of(0, 1, 0, 0, 0, kPi / 2));
  expect_near(world.models[0].pose, pose_of(0, 1, 1, 0, 0, kPi / 2));
  EXPECT_NEAR(world.lights[0].pose.position.z, 2, 1e-12);
}

TEST(SdfWorld, IncludesReplaceNamePoseAndStatic) {
  const std::map<std::string, std::string> texts = {
      {"/models/crate/model.config",
       "<model><name>Crate</name><sdf version='1.4'>old.sdf</sdf><sdf version='1.9'>new.sdf</sdf>"
       "<sdf version='2.0'>future.sdf</sdf><sdf version='1.99'>later.sdf</sdf></model>"},
      {"/models/crate/new.sdf",
       model_text("<pose>9 9 9 0 0 0</pose><link name='base'><pose>0 0 1 0 0 0</pose><visual "
                  "name='v'><geometry><mesh><uri>meshes/crate.dae</uri></mesh></geometry></visual>"
                  "</link><link name='top'><pose>0 0 3 0 0 0</pose></link>")},
      {"/models/crate/meshes/crate.dae", "mesh"}};
  const World world = world_of(
      "<include><uri>model://crate</uri></include>"
      "<include><uri>model://crate</uri><name>second</name><pose>1 2 3 0 0 0</pose>"
      "<static>true</static><plugin name='p' filename='f'/></include>"
      "<include><uri>model://crate</uri><name>third</name><pose>1 0 0 0 0 0</pose>"
      "<placement_frame>top</placement_frame></include>",
      texts);
  ASSERT_EQ(world.models.size(), 3U);
  EXPECT_EQ(world.models[0].name, "m");
  EXPECT_EQ(world.models[0].pose.position.x, 9);
  EXPECT_FALSE(world.models[0].is_static);
  EXPECT_EQ(std::get<Mesh>(world.models[0].links[0].visuals[0].geometry).path,
            "/models/crate/meshes/crate.dae");
  EXPECT_EQ(world.models[1].name, "second");
  expect_near(world.models[1].pose, pose_of(1, 2, 3));
  EXPECT_TRUE(world.models[1].is_static);
  EXPECT_EQ(world.models[1].plugins[0].name, "p");
  expect_near(world.models[2].pose, pose_of(1, 0, -3));
}

TEST(SdfWorld, AllMistakesAreReportedWithTheirLines) {
  const std::string text =
      "<?xml version='1.0'?>\n<sdf version='1.9'>\n<world name='w'>\n"
      "<model name='a'>\n<pose>1 2 nan 0 0 0</pose>\n<link name='l'>\n"
      "<collision name='c'><geometry><box>\n<size>1 2</size></box></geometry></collision>\n"
      "</link></model>\n<model name='b'/>\n<include/>\n<light name='s' type='sun'/>\n"
      "<gravity>down</gravity></world></sdf>";
  const Reading<World> reading = read_world(text, "w.sdf", files({}));
  EXPECT_FALSE(reading.value.has_value());
  EXPECT_EQ(said(reading.notes),
            "error w.sdf:13: <gravity> must have 3 numbers, not 1\n"
            "error w.sdf:8: <size> must have 3 numbers, not 2\n"
            "error w.sdf:5: <pose> must be a finite number of at most 1e15: `nan`\n"
            "error w.sdf:10: the model `b` has no link. A model must have at least one link.\n"
            "error w.sdf:11: <include> needs a <uri>\n"
            "error w.sdf:12: the light `s` is of the unknown type `sun`: types are point, "
            "directional and spot\n");
  EXPECT_EQ(reading.notes[1].column, 1U);
}

TEST(SdfWorld, TextsWithoutAWorldSayWhatTheyAre) {
  const auto notes = [](const std::string& text) {
    return said(read_world(text, "f", files({})).notes);
  };
  EXPECT_EQ(notes(model_text("")),
            "error f:1: the file has a <model> and no <world>: a model is spawned into a world, or "
            "included by one\n");
  EXPECT_EQ(notes("<sdf version='1.6'/>"), "error f:1: the file has no <world>\n");
  EXPECT_EQ(notes("<robot name='r'/>"),
            "error f:1: the text is a URDF, which is a robot and not a world: spawn it (its first "
            "element is <robot>, a world has <sdf>)\n");
  EXPECT_EQ(notes("<sdf>\n<world"),
            "error f:2: the text is not XML: the tag of world does not end\n");
  EXPECT_EQ(notes(""), "error f:1: the text is not XML: it has no element\n");
  EXPECT_EQ(notes("<sdf><world/></sdf>"),
            "warning f:1: <sdf> has no attribute `version`, so it is read as SDF 1.6\n");
}

/// The advice about a model that is not found.
std::string way_to(const std::string& name) {
  return ". The package `" + name + "` does not exist; the package with the folder `" + name +
         "` names it with <gazebo_ros gazebo_model_path=\"${prefix}/FOLDER\"/> in the <export> of "
         "its "
         "package.xml, or a launch file adds it to GAZEBO_MODEL_PATH or GZ_SIM_RESOURCE_PATH\n";
}

TEST(SdfWorld, MissingModelsAndMeshesAreWarnings) {
  EXPECT_EQ(notes_of_world("<include><uri>model://nothing</uri></include>"),
            "warning world:1: the model model://nothing is not found (searched: /models)" +
                way_to("nothing"));
  // So is a model of which nothing remains without it.
  EXPECT_EQ(
      notes_of_world("<model name='shelf'><include><uri>model://no</uri></include></model>"),
      "warning world:1: the model model://no is not found (searched: /models)" + way_to("no"));
  const std::string mesh =
      "<visual name='v%'><geometry><mesh><uri>model://x/y.dae</uri></mesh></geometry></visual>";
  const Reading<World> reading =
      read_world(world_text("<model name='m'><link name='l'>" + mesh + mesh + "</link></model>"),
                 "world", files({}));
  EXPECT_EQ(said(reading.notes),
            "warning world:1: the mesh model://x/y.dae is not found (searched: /models)" +
                way_to("x") + "warning world:1: the link has two <visual> elements `v%`\n");
  const Geometry& geometry = reading.value->models[0].links[0].visuals[1].geometry;
  EXPECT_EQ(std::get<Mesh>(geometry).uri, "model://x/y.dae");
  EXPECT_EQ(std::get<Mesh>(geometry).path, "");
}

TEST(SdfWorld, AFileThatItsPackageDoesNotInstallIsNamedWithItsFolder) {
  Resources resources = files({});
  resources.find = [](const std::string&, std::vector<std::string>& searched) {
    searched.push_back("/ws/share/arm");
    return std::optional<std::string>();
  };
  const std::string shape =
      "<geometry><mesh><uri>package://arm/meshes/base.stl</uri></mesh></geometry>";
  const Reading<World> reading =
      read_world(world_text("<model name='m'><link name='l'><visual name='v'>" + shape +
                            "</visual></link></model>"),
                 "world", resources);
  EXPECT_EQ(said(reading.notes),
            "warning world:1: the mesh package://arm/meshes/base.stl is not found (searched: "
            "/ws/share/arm). The package `arm` is there without it: mind upper and lower case, and "
            "see whether its CMakeLists.txt or setup.py installs `meshes`\n");
}

TEST(SdfWorld, AFolderWithoutAModelIsAnError) {
  EXPECT_EQ(
      notes_of_world("<include><uri>model://a</uri></include>", {{"/models/a/b.dae", ""}}),
      "error world:1: the model model://a cannot be read: /models/a is not a file, and has no "
      "model.config and no model.sdf\n");
}

TEST(SdfWorld, AModelOfFuelThatIsMissingIsNamedWithItsArchive) {
  EXPECT_EQ(notes_of_world("<include><uri>https://fuel.gazebosim.org/1.0/Some%20Body/models/Coke "
                           "Can/2</uri></include>"),
            "warning world:1: the model https://fuel.gazebosim.org/1.0/Some%20Body/models/Coke "
            "Can/2 is not found (searched: /models). A site downloads nothing from "
            "Gazebo Fuel when it runs. With `simulation: {fuel: true}` in workspace.yaml it is "
            "fetched when the site is packed; or unpack "
            "https://fuel.gazebosim.org/1.0/Some%20Body/models/Coke%20Can/2/Coke%20Can.zip "
            "into a folder `Coke Can` beside the other models of your package, which its "
            "CMakeLists.txt installs\n");
}

TEST(SdfWorld, AnArchiveOfFuelCanBePastedIntoAShell) {
  const auto model = fuel_model("https://fuel.gazebosim.org/1.0/O&P/models/$(rm%20a);`b`'%2B");
  ASSERT_TRUE(model);
  EXPECT_EQ(fuel_archive(*model),
            "https://fuel.gazebosim.org/1.0/O%26P/models/%24%28rm%20a%29%3B%60b%60%27%2B/tip/"
            "%24%28rm%20a%29%3B%60b%60%27%2B.zip");
}

TEST(SdfWorld, AddressesOfFuelAreReadWithCare) {
  const auto file =
      fuel_model("https://fuel.ignitionrobotics.org/1.0/O/models/A%20B/tip/files/m/x.dae");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->name, "A B");
  EXPECT_EQ(file->file, "m/x.dae");
  EXPECT_EQ(file->version, "");
  EXPECT_EQ(fuel_title(*file), "O/A B");
  EXPECT_EQ(fetched_folder(*file), "o/a_b/tip");
  const auto second = fuel_model("https://app.gazebosim.org/O%20P/fuel/models/M/12");
  ASSERT_TRUE(second);
  EXPECT_EQ(fuel_title(*second), "O P/M/12");
  EXPECT_EQ(fetched_folder(*second), "o_p/m/12");
  EXPECT_EQ(fuel_model("https://fuel.gazebosim.org/1.0/O/models/M/files/x")->file, "x");
  EXPECT_EQ(fuel_folders(*file), (std::vector<std::string>{"A B", "A_B", "a b", "a_b"}));
  for (const char* wrong :
       {"https://fuel.gazebosim.org/1.0/O/models/", "https://fuel.gazebosim.org/1.0/O/models/..",
        "https://fuel.gazebosim.org/1.0/O/models/M/1/files/../secret",
        "https://fuel.gazebosim.org/1.0/O/worlds/W", "https://example.org/1.0/O/models/M",
        "model://fuel.gazebosim.org/1.0/O/models/M"})
    EXPECT_FALSE(fuel_model(wrong)) << wrong;
}

TEST(SdfWorld, AFetchedModelFindsItsOwnFilesUnderAnyName) {
  const std::string place = "/share/ros2wasm_sim/fuel/o/red_ball/3";
  const std::map<std::string, std::string> texts{
      {place + "/model.sdf",
       "<sdf version='1.9'><model name='ball'><link name='l'><visual name='v'><geometry><mesh>"
       "<uri>model://ball_of_another_name/meshes/ball.obj</uri></mesh></geometry></visual></link>"
       "</model></sdf>"},
      {place + "/meshes/ball.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"/models/ball_of_another_name/meshes/ball.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n"}};
  const World world = world_of("<include><uri>" + place + "</uri></include>", texts);
  ASSERT_EQ(world.models.size(), 1U);
  EXPECT_EQ(std::get<Mesh>(world.models[0].links[0].visuals[0].geometry).path,
            place + "/meshes/ball.obj");
  EXPECT_EQ(fetched_model_of(place + "/meshes"), place);
  EXPECT_EQ(fetched_model_of(place), place);
  EXPECT_EQ(fetched_model_of("/share/ros2wasm_sim/fuel/o"), "");
  EXPECT_EQ(fetched_model_of("/share/lab/models/o"), "");
}

TEST(SdfWorld, UnknownMaterialsAreWarnings) {
  EXPECT_EQ(notes_of_world("<model name='m'><link name='l'><visual name='v'><geometry><mesh>"
                           "<uri>model://a.dae</uri><submesh><name>s</name></submesh></mesh>"
                           "</geometry><material><script><name>Gazebo/Redd</name></script>"
                           "</material></visual></link></model>",
                           {{"/models/a.dae", ""}}),
            "warning world:1: material `Gazebo/Redd` is not known, so its visuals are grey\n");
}

TEST(SdfWorld, AModelOfTheSameNameGetsANumber) {
  const Reading<World> reading =
      read_world(world_text(box("a", "") + box("a", "") + box("a_1", "")), "world", files({}));
  ASSERT_TRUE(reading.value.has_value());
  EXPECT_EQ(reading.notes.size(), 2U);
  EXPECT_EQ(reading.value->models[1].name, "a_1");
  EXPECT_EQ(reading.value->models[2].name, "a_1_1");
}

TEST(SdfWorld, IncludesThatFormALoopEnd) {
  const std::map<std::string, std::string> texts = {
      {"/models/a/model.sdf", model_text("<include><uri>model://b</uri></include>"
                                         "<include><uri>model://b</uri><name>n</name></include>")},
      {"/models/b/model.sdf", model_text("<include><uri>model://a</uri></include>")}};
  const std::string notes = notes_of_world("<include><uri>model://a</uri></include>", texts);
  EXPECT_NE(notes.find("error /models/b/model.sdf:1: /models/a/model.sdf includes itself"),
            std::string::npos)
      << notes;
}

TEST(SdfWorld, IncludesThatMultiplyAreStopped) {
  std::map<std::string, std::string> texts;
  for (int i = 0; i < 30; ++i) {
    const std::string next = "<include><uri>model://n" + std::to_string(i + 1) + "</uri>";
    texts["/models/n" + std::to_string(i) + "/model.sdf"] =
        model_text(next + "<name>a</name></include>" + next + "<name>b</name></include>");
  }
  texts["/models/n30/model.sdf"] = model_text(kBoxLink);
  const std::string notes = notes_of_world("<include><uri>model://n0</uri></include>", texts);
  EXPECT_NE(notes.find("error "), std::string::npos);
  EXPECT_NE(notes.find("there are more than 300000"), std::string::npos) << notes;
}

TEST(SdfWorld, TenThousandBoxesAreQuick) {
  std::string inside;
  for (int i = 0; i < 10'000; ++i) {
    inside += box("box_" + std::to_string(i), std::to_string(i) + " 0 0 0 0 0");
  }
  const auto begin = std::chrono::steady_clock::now();
  const World world = world_of(inside);
  const auto end = std::chrono::steady_clock::now();
  EXPECT_EQ(world.models.size(), 10'000U);
  EXPECT_EQ(world.models.back().pose.position.x, 9'999);
  EXPECT_LT(std::chrono::duration<double>(end - begin).count(), 5);
}

}  // namespace
