// workspace.yaml -> Manifest: what good manifests mean. What bad ones print is in
// tests/golden/manifest.
#include "workspace_schema/schema/manifest_reader.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "workspace_schema/schema/manifest_json.hpp"

namespace ros2wasm {
namespace {

Manifest manifest_of(const std::string& text) {
  auto manifest = read_manifest(text, "workspace.yaml");
  if (!manifest) {
    ADD_FAILURE() << manifest.errors()[0].message;
    return {};
  }
  return *manifest;
}

std::string example(const std::string& name) {
  std::ifstream file(std::string(ROS2WASM_SOURCE_DIR "/workspace_schema/schemas/examples/") + name);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty()) << name;
  return text.str();
}

TEST(ManifestReader, Version1StaysReadable) {
  const Manifest manifest = manifest_of(example("valid/version_1.yaml"));
  EXPECT_EQ(manifest.schema, 1);
  EXPECT_EQ(manifest.name.value, "turtle_lab-2.1");
  EXPECT_EQ(manifest.title, "Lab 2: a turtle that listens");
  EXPECT_EQ(manifest.version, "2.1.0");
  ASSERT_EQ(manifest.authors.size(), 2U);
  EXPECT_EQ(manifest.authors[0].name, "Ada Lovelace");
  EXPECT_EQ(manifest.authors[0].email, "ada@example.org");
  EXPECT_EQ(manifest.authors[1].orcid, "0000-0002-1825-0097");
  EXPECT_EQ(manifest.authors[1].affiliation, "Navy");
  EXPECT_EQ(manifest.license, "Apache-2.0");
  EXPECT_EQ(manifest.distro, "jazzy");
  ASSERT_EQ(manifest.channels.size(), 2U);
  EXPECT_EQ(manifest.channels[1].value, "./my_channel");
  EXPECT_EQ(manifest.dependencies[0].value, "demo_nodes_cpp >=0.33");
  EXPECT_EQ(manifest.packages[1].value, "../shared/src/messages");
  EXPECT_FALSE(manifest.launch_file.has_value());
  ASSERT_EQ(manifest.nodes.size(), 2U);

  const NodeEntry& talker = manifest.nodes[0];
  EXPECT_EQ(talker.package.value, "demo_nodes_cpp");
  EXPECT_EQ(talker.executable.value, "talker");
  EXPECT_EQ(talker.executable.span.line, 25U);
  EXPECT_EQ(talker.executable.span.column, 17U);
  EXPECT_EQ(talker.name->value, "talker1");
  EXPECT_EQ(talker.name_space->value, "/robot1");
  const std::vector<std::pair<std::string, std::string>> remappings{
      {"chatter", "/news"}, {"~/status", "status"}, {"rosservice://add", "{node}/add"}};
  EXPECT_EQ(talker.remappings, remappings);
  EXPECT_EQ(talker.arguments, (std::vector<std::string>{"--verbose", "3", "true"}));
  EXPECT_EQ(talker.output, NodeOutput::kBoth);
  EXPECT_TRUE(talker.respawn);
  EXPECT_EQ(manifest.nodes[1].remappings[0].second, "/robot1/news");
  EXPECT_EQ(manifest.ui.at("theme"), "dark");
  EXPECT_EQ(manifest.ui.at("autostart"), "false");
  EXPECT_EQ(manifest.site.at("exceptions"), "standard");
  EXPECT_TRUE(manifest.warnings.empty());
}

TEST(ManifestReader, ParametersKeepTypesAndOrder) {
  const Manifest manifest = manifest_of(example("valid/version_1.yaml"));
  const NodeEntry& node = manifest.nodes[0];
  ASSERT_EQ(node.parameter_files.size(), 2U);
  ASSERT_EQ(node.parameters.size(), 7U);
  const auto expect = [&](std::size_t index, const std::string& name, const ParameterValue& value) {
    EXPECT_EQ(node.parameters[index].name, name);
    EXPECT_EQ(node.parameters[index].value, value) << name;
    EXPECT_EQ(node.parameters[index].files_before, 1U) << name;
  };
  expect(0, "rate", std::int64_t{10});
  expect(1, "frame", std::string("map"));
  expect(2, "limits.speed", 1.5);
  expect(3, "limits.steps", std::vector<std::int64_t>{1, 2, 3});
  expect(4, "limits.names", std::vector<std::string>{"a", "b"});
  expect(5, "limits.flags", std::vector<bool>{true, false});
  expect(6, "gains", std::vector<double>{1.0, 0.5});
}

TEST(ManifestReader, ANamespaceIsAbsoluteWithoutItsSlashToo) {
  const Manifest manifest = manifest_of(
      "schema: 1\nname: lab\nlaunch:\n  - {package: a, executable: b, namespace: robot1/arm}\n");
  ASSERT_EQ(manifest.nodes.size(), 1U);
  EXPECT_EQ(manifest.nodes[0].name_space->value, "/robot1/arm");
}

TEST(ManifestReader, DefaultsOfTheSmallest) {
  const Manifest manifest = manifest_of(example("valid/smallest.yaml"));
  EXPECT_EQ(manifest.distro, "jazzy");
  EXPECT_EQ(manifest.launch_file->value, "launch/demo.launch.py");
  EXPECT_TRUE(manifest.nodes.empty());
  EXPECT_TRUE(manifest.channels.empty());
}

TEST(ManifestReader, LaunchArgumentsAreTextsAsWritten) {
  const Manifest manifest = manifest_of(example("valid/launch_arguments.yaml"));
  EXPECT_EQ(manifest.launch_file->value, "src/demo/launch/bringup.launch.py");
  std::vector<std::pair<std::string, std::string>> given;
  for (const GivenArgument& one : manifest.launch_arguments)
    given.emplace_back(one.name.value, one.value);
  const std::vector<std::pair<std::string, std::string>> expected{
      {"robot", "r2"},  {"speed", "2.50"},         {"use_sim_time", "true"}, {"frame", ""},
      {"port", "0x1F"}, {"lines", "two\nlines\n"}, {"odd name", "x"}};
  EXPECT_EQ(given, expected);
  EXPECT_EQ(manifest.launch_arguments[1].name.span.line, 7U);
  EXPECT_EQ(manifest.launch_arguments[1].name.span.column, 5U);
}

TEST(ManifestReader, VariablesOfTheLaunchFileAreTextsAsWritten) {
  const Manifest manifest = manifest_of(
      "schema: 1\nname: a\nlaunch:\n  file: l.xml\n  environment: {MODEL: burger, LEVEL_2: 0x1F, "
      "_ON: true}");
  const std::map<std::string, std::string> expected{
      {"LEVEL_2", "0x1F"}, {"MODEL", "burger"}, {"_ON", "true"}};
  EXPECT_EQ(manifest.launch_variables, expected);
  EXPECT_NE(manifest_json(manifest).find(
                R"("launch":{"file":"l.xml","environment":{"LEVEL_2":"0x1F","MODEL":"burger",)"),
            std::string::npos);
  for (const char* wrong : {"{2ND: x}", "{A-B: x}", "[MODEL]", "MODEL=burger"}) {
    const auto read = read_manifest(
        "schema: 1\nname: a\nlaunch:\n  file: l.xml\n  environment: " + std::string(wrong),
        "w.yaml");
    EXPECT_FALSE(read.ok()) << wrong;
  }
}

TEST(ManifestReader, PythonIsWrittenWhole) {
  const std::string json = manifest_json(manifest_of(example("valid/python_libraries.yaml")));
  EXPECT_NE(
      json.find(
          R"("python":{"wheels":[{"file":"wheels/gear_box-2.0-cp312-cp312-pyodide_2024_0_wasm32.whl"},)"),
      std::string::npos)
      << json;
  EXPECT_NE(json.find(R"("packages":["scipy","pandas>=2","scikit-learn"],)"
                      R"("index":"https://mirror.example.org/pyodide/v0.27.8/full/",)"
                      R"("lock":"libraries/pyodide-lock.json"})"),
            std::string::npos)
      << json;
}

TEST(ManifestReader, AllStylesOfText) {
  const Manifest manifest = manifest_of(example("valid/texts_in_all_styles.yaml"));
  EXPECT_EQ(manifest.name.value, "2024");
  EXPECT_EQ(manifest.title, "A folded text");
  const auto& parameters = manifest.nodes[0].parameters;
  EXPECT_EQ(parameters[0].value, ParameterValue(std::string("two\nlines\n")));
  EXPECT_EQ(parameters[1].value, ParameterValue(std::string("10")));
  EXPECT_EQ(parameters[2].value, ParameterValue(1.0));
  EXPECT_EQ(parameters[4].value, ParameterValue(1000.0));
}

TEST(ManifestReader, AnchorsUnfold) {
  const Manifest manifest = manifest_of(example("valid/anchors.yaml"));
  ASSERT_EQ(manifest.nodes.size(), 2U);
  ASSERT_EQ(manifest.nodes[1].parameters.size(), 2U);
  EXPECT_EQ(manifest.nodes[0].parameters[1].value, manifest.nodes[1].parameters[1].value);
}

TEST(ManifestReader, VersionsAreTakenAsWritten) {
  EXPECT_EQ(manifest_of("schema: 1\nname: a\nversion: 1.10\nlaunch: l.xml").version, "1.10");
  EXPECT_EQ(manifest_of("schema: 1\nname: a\nversion: 2\nlaunch: l.xml").version, "2");
}

TEST(ManifestReader, NeverMoreThanAHundredErrors) {
  std::string text = "schema: 1\nname: a\nlaunch: l.xml\n";
  for (int i = 0; i < 500; ++i) text += "unknown" + std::to_string(i) + ": 1\n";
  const auto manifest = read_manifest(text, "workspace.yaml");
  ASSERT_FALSE(manifest.ok());
  EXPECT_LE(manifest.errors().size(), 100U);
}

TEST(ManifestJson, IsCompleteAndKeepsOrder) {
  const std::string json = manifest_json(manifest_of(example("valid/version_1.yaml")));
  EXPECT_NE(json.find(R"("parameters":["config/defaults.yaml",{"rate":10,)"), std::string::npos)
      << json;
  EXPECT_NE(json.find(R"("gains":[1.0,0.5]},"config/robot1.yaml"])"), std::string::npos) << json;
}

TEST(ManifestJson, HasTheLaunchFileWithItsArguments) {
  const std::string json = manifest_json(manifest_of(example("valid/launch_arguments.yaml")));
  EXPECT_NE(
      json.find(
          R"("launch":{"file":"src/demo/launch/bringup.launch.py","arguments":{"robot":"r2","speed":"2.50")"),
      std::string::npos)
      << json;
}

}  // namespace
}  // namespace ros2wasm
