// YAML of parameters: structure, types, and what is refused with its line.
#include "ros2wasm/yaml.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ros2wasm {
namespace {

ParameterData value(const char* text) {
  return to_parameter(parse_yaml(text));
}

TEST(YamlValue, HasTheTypesOfRosParameters) {
  EXPECT_EQ(std::get<bool>(value("true")), true);
  EXPECT_EQ(std::get<bool>(value("off")), false);
  EXPECT_EQ(std::get<int64_t>(value("-5")), -5);
  EXPECT_EQ(std::get<int64_t>(value("0x10")), 16);
  EXPECT_EQ(std::get<double>(value("1.5e3")), 1500.0);
  EXPECT_EQ(std::get<double>(value(".5")), 0.5);
  EXPECT_TRUE(std::isnan(std::get<double>(value(".nan"))));
  EXPECT_TRUE(std::isinf(std::get<double>(value("-.inf"))));
  EXPECT_EQ(std::get<std::string>(value("hello world")), "hello world");
  EXPECT_EQ(std::get<std::string>(value("infinite")), "infinite");
  EXPECT_EQ(std::get<std::string>(value("1.2.3")), "1.2.3");
  EXPECT_EQ(std::get<std::string>(value("'5'")), "5");
  EXPECT_EQ(std::get<std::string>(value("!!str true")), "true");
  EXPECT_EQ(std::get<std::string>(value("\"a\\n\\\"b\\\"\"")), "a\n\"b\"");
  EXPECT_EQ(std::get<std::string>(value(R"("\x0a\e\u00e4\u20ac\U0001f916")")),
            "\n\x1b\u00e4\u20ac\U0001f916");
  EXPECT_EQ(std::get<std::string>(value("'it''s'")), "it's");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value("")));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value("null")));
}

TEST(YamlValue, HasListsOfOneType) {
  EXPECT_EQ(std::get<std::vector<int64_t>>(value("[1, 2, 3]")), (std::vector<int64_t>{1, 2, 3}));
  EXPECT_EQ(std::get<std::vector<double>>(value("[1, 2.5]")), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(std::get<std::vector<bool>>(value("[true, no]")), (std::vector<bool>{true, false}));
  EXPECT_EQ(std::get<std::vector<std::string>>(value("[a, 'b, c']")),
            (std::vector<std::string>{"a", "b, c"}));
  EXPECT_EQ(std::get<std::vector<std::string>>(value("- a\n- b\n")),
            (std::vector<std::string>{"a", "b"}));
  EXPECT_THROW(value("[1, a]"), std::runtime_error);
  EXPECT_THROW(value("[]"), std::runtime_error);
  EXPECT_THROW(value("[[1]]"), std::runtime_error);
  EXPECT_THROW(value("{a: 1}"), std::runtime_error);
}

TEST(YamlDocument, ReadsAParameterFile) {
  const YamlNode node = parse_yaml(
      "# comment\n"
      "/ns/talker:\n"
      "  ros__parameters:\n"
      "    speed: 2.0   # fast\n"
      "    names: [a, b]\n"
      "    more:\n"
      "    - 1\n"
      "    - 2\n"
      "    deep:\n"
      "      er: 'x # y'\n"
      "\n"
      "/**:\n"
      "  ros__parameters: {use_sim_time: true, \"quoted key\": 1}\n");
  ASSERT_EQ(node.entries.size(), 2u);
  EXPECT_EQ(node.entries[0].first, "/ns/talker");
  const YamlNode& parameters = node.entries[0].second.entries[0].second;
  ASSERT_EQ(parameters.entries.size(), 4u);
  EXPECT_EQ(parameters.entries[0].second.text, "2.0");
  EXPECT_EQ(parameters.entries[1].second.items.size(), 2u);
  EXPECT_EQ(parameters.entries[2].second.items[1].text, "2");
  EXPECT_EQ(parameters.entries[3].second.entries[0].second.text, "x # y");
  EXPECT_EQ(node.entries[1].second.entries[0].second.entries[1].first, "quoted key");
}

TEST(YamlDocument, SaysWhereItCannotRead) {
  const auto error = [](const char* text) -> std::string {
    try {
      parse_yaml(text);
    } catch (const std::runtime_error& caught) {
      return caught.what();
    }
    return "";
  };
  EXPECT_EQ(error("a: 1\nb: [1, 2\n"), "line 3: expected ',' or ']'");
  EXPECT_EQ(error("a: &x 1"), "line 1: '&' is not supported in parameter values");
  EXPECT_EQ(error("a: 'x"), "line 1: a quoted text is not closed");
  EXPECT_EQ(error("a: 1\n   b: 2\n"), "line 2: wrong indentation");
  EXPECT_NE(error("a: b: c\n"), "");
  EXPECT_EQ(error(std::string(100000, '[').c_str()), "line 1: values are nested too deep");
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "- ";
  EXPECT_EQ(error(deep.c_str()), "line 1: values are nested too deep");
}

TEST(YamlDocument, ReadsTextsOfSeveralLines) {
  // As PyYAML breaks long texts.
  const YamlNode node = parse_yaml("a: \"one \\\n  two\\\n  \\ three\"\n");
  EXPECT_EQ(node.entries[0].second.text, "one two three");
}

}  // namespace
}  // namespace ros2wasm
