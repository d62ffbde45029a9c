// `checks:` of a manifest: each kind, and what is refused where.
#include "workspace_schema/schema/manifest_checks.hpp"

#include <gtest/gtest.h>

#include "workspace_schema/schema/check_json.hpp"
#include "workspace_schema/schema/manifest_reader.hpp"

namespace ros2wasm {
namespace {

const std::string kHead = "schema: 1\nname: lab\nlaunch: [{package: p, executable: e}]\nchecks:\n";

/// The check as site.json has it, or the code and label of what is wrong.
std::string check_of(const std::string& check) {
  const auto manifest = read_manifest(kHead + "  - " + check + "\n", "workspace.yaml");
  if (!manifest) {
    std::string all;
    for (const Diagnostic& error : manifest.errors()) all += error.code + " " + error.message + ";";
    return all;
  }
  JsonWriter json;
  json.begin_object();
  write_check_fields(json, manifest->checks.at(0));
  json.end_object();
  return json.text();
}

TEST(ManifestChecks, ReadsEachKind) {
  EXPECT_EQ(check_of("{topic: odom, above: 10 Hz, below: 20.5Hz, within: 5 s}"),
            R"({"kind":"rate","topic":"/odom","above":10,"below":20.5,"within_ms":5000})");
  EXPECT_EQ(check_of("topic: /chatter"), R"({"kind":"rate","topic":"/chatter","within_ms":10000})");
  EXPECT_EQ(check_of("{title: moved, topic: /pose, field: 'a.b[3]', above: -1, equals: 2.0}"),
            R"({"title":"moved","kind":"message","topic":"/pose","field":"a.b[3]","above":-1,)"
            R"("equals":2.0,"within_ms":10000})");
  EXPECT_EQ(check_of(R"({node: talker, log: 'Hello \d+', within: 500ms})"),
            R"({"kind":"log","node":"talker","log":"Hello \\d+","within_ms":500})");
  EXPECT_EQ(check_of("{node: robot1/talker, parameter: a.b, equals: 'yes'}"),
            R"({"kind":"parameter","node":"/robot1/talker","parameter":"a.b","equals":"yes",)"
            R"("within_ms":10000})");
  EXPECT_EQ(check_of("{node: talker-1, state: running, within: 2 m}"),
            R"({"kind":"state","node":"talker-1","state":"running","within_ms":120000})");
  EXPECT_EQ(check_of("{node: talker, exit_code: 3}"),
            R"({"kind":"exit_code","node":"talker","exit_code":3,"within_ms":10000})");
}

TEST(ManifestChecks, RefusesWhatSaysNothingOrTooMuch) {
  EXPECT_EQ(check_of("{within: 5 s}"), "R2W0117 this check says nothing of what must be seen;");
  EXPECT_EQ(check_of("{topic: /a, log: b}"),
            "R2W0117 `log` does not belong to a check of a topic's rate;");
  EXPECT_EQ(check_of("{topic: /a, equals: 3}"),
            "R2W0117 `equals` does not belong to a check of a topic's rate;");
  EXPECT_EQ(check_of("{topic: /a, field: x}"),
            "R2W0117 this check does not say what the value must be;");
  EXPECT_EQ(check_of("{topic: /a, above: 5 Hz, below: 5 Hz}"),
            "R2W0117 nothing is above and below these at once;");
  EXPECT_EQ(check_of("{parameter: a, equals: 1}"), "R2W0106 a check of a parameter has no `node`;");
}

TEST(ManifestChecks, RefusesWrongValues) {
  EXPECT_EQ(check_of("{topic: /a, above: 10}"), "R2W0103 `above` of a topic is a rate in Hz;");
  EXPECT_EQ(check_of("{topic: ~/a}"), "R2W0104 `~/a` is a topic of a node that is not named here;");
  EXPECT_TRUE(check_of("{topic: a b}").starts_with("R2W0104"));
  EXPECT_TRUE(check_of("{topic: /a, field: 'x[', equals: 1}").starts_with("R2W0104"));
  EXPECT_TRUE(check_of("{topic: /a, field: 'x.', equals: 1}").starts_with("R2W0104"));
  EXPECT_TRUE(check_of("{topic: /a, field: x, equals: [1]}").starts_with("R2W0103"));
  EXPECT_TRUE(check_of("{topic: /a, field: x, above: high}").starts_with("R2W0103"));
  EXPECT_EQ(check_of("{log: '(a+)+'}"), "R2W0116 `(a+)+` cannot be used as a regular expression;");
  EXPECT_EQ(check_of("{log: a, within: soon}"), "R2W0103 `within` cannot be `soon`;");
  EXPECT_EQ(check_of("{node: a, state: dead}"), "R2W0103 `state` cannot be `dead`;");
  EXPECT_TRUE(check_of("{node: a, exit_code: 256}").starts_with("R2W0103"));
  EXPECT_TRUE(check_of("talker runs").starts_with("R2W0103"));
}

TEST(ManifestChecks, NamesThePlaceInAnExpression) {
  const auto manifest = read_manifest(kHead + "  - log: ab(c+)*d\n", "workspace.yaml");
  ASSERT_FALSE(manifest.ok());
  EXPECT_EQ(manifest.errors()[0].span->line, 5U);
  EXPECT_EQ(manifest.errors()[0].span->column, 12U);
  EXPECT_EQ(manifest.errors()[0].span->length, 5U);
}

}  // namespace
}  // namespace ros2wasm
