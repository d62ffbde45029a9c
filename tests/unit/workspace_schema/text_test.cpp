// The small text tools: places in a text, UTF-8, suggestions, JSON output.
#include <gtest/gtest.h>

#include <cmath>

#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/replaced_text.hpp"
#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/text_encoding.hpp"

namespace ros2wasm {
namespace {

TEST(SourceText, Places) {
  const SourceText source("ab\r\n\ncd", "f");
  EXPECT_EQ(source.line_text(1), "ab");
  EXPECT_EQ(source.line_text(2), "");
  EXPECT_EQ(source.line_text(3), "cd");
  EXPECT_EQ(source.line_text(9), "");
  const SourceSpan d = source.span(6, 10);
  EXPECT_EQ(d.line, 3U);
  EXPECT_EQ(d.column, 2U);
  EXPECT_EQ(d.length, 1U);
  EXPECT_EQ(source.span(99, 1).line, 3U);
  EXPECT_EQ(SourceText("", "f").span(0, 5).line, 1U);
}

TEST(ReplacedText, EveryPlaceOnce) {
  EXPECT_EQ(with_replaced("aXbX", "X", "XX"), "aXXbXX");
  EXPECT_EQ(with_replaced("aaa", "aa", ""), "a");
  EXPECT_EQ(with_replaced("a", "", "b"), "a");
  EXPECT_EQ(with_replaced("", "a", "b"), "");
}

TEST(TextEncoding, FindsInvalidBytes) {
  EXPECT_EQ(first_invalid_utf8("a\xC3\xA9\xF0\x9F\x90\xA2"), std::nullopt);
  EXPECT_EQ(first_invalid_utf8("a\xC3"), 1U);
  EXPECT_EQ(first_invalid_utf8("\xC0\x80"), 0U);          // overlong
  EXPECT_EQ(first_invalid_utf8("\xED\xA0\x80"), 0U);      // surrogate
  EXPECT_EQ(first_invalid_utf8("\xF4\x90\x80\x80"), 0U);  // behind the last character
  EXPECT_EQ(valid_utf8("a\xFF"
                       "b"),
            "a\xEF\xBF\xBD"
            "b");
}

TEST(TextEncoding, Widths) {
  EXPECT_EQ(terminal_width(std::string_view("abc")), 3U);
  EXPECT_EQ(terminal_width(std::string_view("\xE5\xB1\xB1")), 2U);
  EXPECT_EQ(terminal_width(std::string_view("e\xCC\x81")), 1U);
  EXPECT_EQ(terminal_width(std::string_view("\xF0\x9F\x90\xA2")), 2U);
}

TEST(Suggestion, EditDistance) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("ab", "ba"), 1U);
  EXPECT_EQ(edit_distance("same", "same"), 0U);
}

TEST(Suggestion, Nearest) {
  const std::vector<std::string> names{"package", "packages", "executable", "ui"};
  EXPECT_EQ(nearest("pakage", names), "package");
  EXPECT_EQ(nearest("PACKAGES", names), "packages");
  EXPECT_EQ(nearest("executible", names), "executable");
  EXPECT_EQ(nearest("ux", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
  EXPECT_EQ(nearest("entirely else", names), std::nullopt);
}

TEST(Suggestion, NameList) {
  const std::vector<std::string> names{"a", "b", "c", "d"};
  EXPECT_EQ(name_list(names, 4), "a, b, c, d");
  EXPECT_EQ(name_list(names, 3), "a, b, c, d");  // "(and 1 more)" would be no shorter
  EXPECT_EQ(name_list(names, 2), "a, b (and 2 more)");
}

// Guarantee, hostile input: a JSON text of more than two million values is refused before it takes
// the memory
TEST(JsonReader, RefusesMoreValuesThanItsLimit) {
  std::string text = "[";
  for (int i = 0; i < 1'999'998; ++i) text += "[],";
  EXPECT_TRUE(parse_json(text + "0]", "x.json", "R2W0605"));
  const auto more = parse_json(text + "0,0]", "x.json", "R2W0605");
  ASSERT_FALSE(more);
  EXPECT_EQ(more.errors().front().why.front(), "it has more than 2000000 values");
}

TEST(JsonWriter, Nests) {
  JsonWriter json;
  json.begin_object()
      .field("a", "x\"\n\x01")
      .key("b")
      .begin_array()
      .integer(-1)
      .number(0.5)
      .number(NAN)
      .boolean(true);
  json.null()
      .begin_object()
      .end_object()
      .end_array()
      .key("c")
      .unsigned_integer(18446744073709551615ULL)
      .end_object();
  EXPECT_EQ(json.text(),
            R"({"a":"x\"\n\u0001","b":[-1,0.5,null,true,null,{}],"c":18446744073709551615})");
}

}  // namespace
}  // namespace ros2wasm
