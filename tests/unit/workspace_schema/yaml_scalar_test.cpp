// Tests of the meaning of scalars, and that written texts are read back unchanged.
#include "workspace_schema/base/yaml_scalar.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ros2wasm {
namespace {

YamlValue value(const std::string& text, bool quoted = false, const std::string& tag = {}) {
  return scalar_value(
      YamlNode{.kind = YamlKind::kScalar, .quoted = quoted, .tag = tag, .text = text});
}

template <typename T>
void expect(const std::string& text, const T& wanted) {
  const YamlValue found = value(text);
  const T* same = std::get_if<T>(&found);
  ASSERT_NE(same, nullptr) << text;
  EXPECT_EQ(*same, wanted) << text;
}

TEST(YamlScalar, Integers) {
  expect<std::int64_t>("0", 0);
  expect<std::int64_t>("-17", -17);
  expect<std::int64_t>("+17", 17);
  expect<std::int64_t>("010", 10);
  expect<std::int64_t>("0x1F", 31);
  expect<std::int64_t>("0o17", 15);
  expect<std::int64_t>("9223372036854775807", INT64_MAX);
  expect<std::int64_t>("-9223372036854775808", INT64_MIN);
  EXPECT_TRUE(std::holds_alternative<YamlIntegerTooLarge>(value("9223372036854775808")));
}

TEST(YamlScalar, Doubles) {
  expect<double>("1.", 1.0);
  expect<double>(".5", 0.5);
  expect<double>("-1.5e-3", -1.5e-3);
  expect<double>("1e3", 1000.0);
  expect<double>("+2.5", 2.5);
  expect<double>(".inf", INFINITY);
  expect<double>("-.INF", -INFINITY);
  expect<double>("1e999", INFINITY);
  expect<double>("1e-999", 0.0);
  const YamlValue nan = value(".nan");
  EXPECT_TRUE(std::isnan(std::get<double>(nan)));
}

TEST(YamlScalar, BooleansAndNulls) {
  expect<bool>("true", true);
  expect<bool>("False", false);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value("null")));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value("~")));
}

TEST(YamlScalar, EverythingElseIsText) {
  for (const char* text : {"yes", "1.2.3", "1_000", "0x", "0o8", "e3", ".", "-", "+", "1e", "1e+",
                           "tRUE", "inf", "nan", "12:30"}) {
    expect<std::string>(text, text);
  }
  EXPECT_TRUE(std::holds_alternative<std::string>(value("10", true)));
  EXPECT_TRUE(std::holds_alternative<std::string>(value("", true)));
}

TEST(YamlScalar, Tags) {
  const std::string core = "tag:yaml.org,2002:";
  EXPECT_EQ(std::get<std::string>(value("10", false, core + "str")), "10");
  EXPECT_EQ(std::get<double>(value("10", false, core + "float")), 10.0);
  EXPECT_EQ(std::get<std::int64_t>(value("10", true, core + "int")), 10);
  EXPECT_EQ(std::get<bool>(value("true", false, core + "bool")), true);
  EXPECT_TRUE(std::holds_alternative<YamlUnknownTag>(value("x", false, core + "int")));
  EXPECT_TRUE(std::holds_alternative<YamlUnknownTag>(value("x", false, "!mine")));
}

TEST(YamlScalar, TextsAreReadBack) {
  for (const std::string text :
       {"plain", "two words", "10",  "true", "yes",   "",     " a", "a ",  "- a",
        "a: b",  "a #b",      "[a]", "*a",   "src/*", "a\nb", "\"", "'",   "\\",
        "~",     "null",      "1e3", "@x",   "%x",    "?",    "!a", "a,b", "\xC3\xA9"}) {
    for (const std::string& frame : {std::string("k: "), std::string("k: [")}) {
      const std::string whole = frame + as_yaml_text(text) + (frame.ends_with('[') ? "]" : "");
      const SourceText source(whole, "a.yaml");
      const auto document = parse_yaml(source);
      ASSERT_TRUE(document.ok()) << whole;
      const YamlNode& found = document->root.entries.at(0).value;
      const YamlValue read = scalar_value(frame.ends_with('[') ? found.items.at(0) : found);
      ASSERT_TRUE(std::holds_alternative<std::string>(read)) << whole;
      EXPECT_EQ(std::get<std::string>(read), text) << whole;
    }
  }
}

}  // namespace
}  // namespace ros2wasm
