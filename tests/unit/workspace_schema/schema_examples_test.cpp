// The reader and the JSON Schema agree on every example; the schema names every key that the reader
// knows.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "unit/workspace_schema/schema_validator.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {

const std::filesystem::path kSchemas = ROS2WASM_SOURCE_DIR "/workspace_schema/schemas";

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::filesystem::path> examples(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(kSchemas / "examples" / folder)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

class SchemaExamples : public ::testing::Test {
 protected:
  void SetUp() override {
    auto parsed =
        parse_json(read(kSchemas / "workspace.schema.json"), "workspace.schema.json", "R2W0990");
    ASSERT_TRUE(parsed.ok());
    schema_ = *parsed;
  }

  /// Nothing when the schema accepts the text.
  std::string schema_error(const std::string& text) const {
    const SourceText source(text, "example.yaml");
    const auto document = parse_yaml(source);
    if (!document) return "not YAML";
    return ros2wasm::testing::SchemaValidator(schema_).first_error(document->root);
  }

  JsonValue schema_;
};

TEST_F(SchemaExamples, ValidOnesPleaseBoth) {
  const auto paths = examples("valid");
  ASSERT_GE(paths.size(), 7U);
  for (const auto& path : paths) {
    const std::string text = read(path);
    const auto manifest = read_manifest(text, path.filename());
    EXPECT_TRUE(manifest.ok()) << path << ": " << manifest.errors()[0].message;
    EXPECT_EQ(schema_error(text), "") << path;
  }
}

TEST_F(SchemaExamples, InvalidOnesDispleaseBoth) {
  const auto paths = examples("invalid");
  ASSERT_GE(paths.size(), 40U);
  for (const auto& path : paths) {
    const std::string text = read(path);
    EXPECT_FALSE(read_manifest(text, path.filename()).ok()) << path;
    const bool beyond_the_schema = text.starts_with("# beyond the schema: ");
    EXPECT_EQ(schema_error(text).empty(), beyond_the_schema) << path;
  }
}

TEST_F(SchemaExamples, TheSchemaHasTheReadersKeys) {
  // The reader lists its keys in the error for an unknown one.
  const auto manifest =
      read_manifest("schema: 1\nname: a\nlaunch: [{package: p, executable: e, zz: 1}]\nzz: 1", "a");
  ASSERT_FALSE(manifest.ok());
  ASSERT_EQ(manifest.errors().size(), 2U);
  const auto keys_of = [](const JsonValue& object) {
    std::string all;
    for (const auto& [key, value] : object.find("properties")->members())
      all += (all.empty() ? "" : ", ") + key;
    return "its keys are: " + all;
  };
  EXPECT_EQ(manifest.errors()[0].why[0], keys_of(*schema_.find("$defs")->find("node")));
  EXPECT_EQ(manifest.errors()[1].why[0], keys_of(schema_));
}

}  // namespace
}  // namespace ros2wasm
