// The YAML reader: places of values and of missing values, aliases, limits, and what is refused.
#include "workspace_schema/base/yaml_reader.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

/// "line:column+length" of a range.
std::string place(const SourceText& source, TextRange range) {
  const SourceSpan span = source.span(range.offset, range.length);
  return std::to_string(span.line) + ":" + std::to_string(span.column) + "+" +
         std::to_string(span.length);
}

/// The tree on one line, every scalar and null with its place.
std::string shown(const SourceText& source, const YamlNode& node) {
  switch (node.kind) {
    case YamlKind::kNull:
      return std::string(node.written ? "null@" : "nothing@") + place(source, node.range);
    case YamlKind::kScalar:
      return (node.quoted ? "'" + node.text + "'" : node.text) + "@" + place(source, node.range);
    case YamlKind::kSequence: {
      std::string out = "[";
      for (const YamlNode& item : node.items)
        out += (out.size() > 1 ? ", " : "") + shown(source, item);
      return out + "]";
    }
    case YamlKind::kMap: {
      std::string out = "{";
      for (const YamlEntry& entry : node.entries) {
        out += (out.size() > 1 ? ", " : "") + entry.key + ": " + shown(source, entry.value);
      }
      return out + "}";
    }
  }
  return "?";
}

std::string read_yaml(std::string_view text) {
  const SourceText source(text, "a.yaml");
  const auto document = parse_yaml(source);
  if (!document) return document.errors()[0].code + ": " + document.errors()[0].message;
  std::string out = shown(source, document->root);
  for (const Diagnostic& problem : document->problems) out += " !" + problem.code;
  return out;
}

TEST(YamlReader, PlacesOfValues) {
  EXPECT_EQ(read_yaml("a: b"), "{a: b@1:4+1}");
  EXPECT_EQ(read_yaml("a:  'b c'\n"), "{a: 'b c'@1:5+5}");
  EXPECT_EQ(read_yaml("a: \"x\\\"y\""), "{a: 'x\"y'@1:4+6}");
  EXPECT_EQ(read_yaml("a: 'it''s'"), "{a: 'it's'@1:4+7}");
  EXPECT_EQ(read_yaml("a: [b, {c: d}]"), "{a: [b@1:5+1, {c: d@1:12+1}]}");
  EXPECT_EQ(read_yaml("- x\n-   y\n"), "[x@1:3+1, y@2:5+1]");
  EXPECT_EQ(read_yaml("\xEF\xBB\xBF"
                      "a: b"),
            "{a: b@1:7+1}");
  EXPECT_EQ(read_yaml("a: b\r\nc: d\r\n"), "{a: b@1:4+1, c: d@2:4+1}");
  EXPECT_EQ(read_yaml("\xC3\xA9: \xC3\xBC"), "{\xC3\xA9: \xC3\xBC@1:5+2}");
}

TEST(YamlReader, SeveralLines) {
  EXPECT_EQ(read_yaml("a: |\n  x\n  y\nb: c"), "{a: 'x\ny\n'@1:4+1, b: c@4:4+1}");
  EXPECT_EQ(read_yaml("a: >-\n  x\n  y\n"), "{a: 'x y'@1:4+1}");
  EXPECT_EQ(read_yaml("a: x\n  y\n"), "{a: x y@1:4+1}");
}

TEST(YamlReader, EmptyValuesDoNotBearTheNextTokensPlace) {
  EXPECT_EQ(read_yaml("a:\nb: c"), "{a: nothing@1:3+0, b: c@2:4+1}");
  EXPECT_EQ(read_yaml("a:   # remark\nb: c"), "{a: nothing@1:3+1, b: c@2:4+1}");
  EXPECT_EQ(read_yaml("a:"), "{a: nothing@1:3+0}");
  EXPECT_EQ(read_yaml("a:\n  b:\nc: d"), "{a: {b: nothing@2:5+0}, c: d@3:4+1}");
  EXPECT_EQ(read_yaml("-\n- a\n-\n"), "[nothing@1:1+1, a@2:3+1, nothing@3:1+1]");
  EXPECT_EQ(read_yaml("- # remark - here\n- a"), "[nothing@1:1+1, a@2:3+1]");
  EXPECT_EQ(read_yaml("{a: , b: c}"), "{a: nothing@1:4+1, b: c@1:10+1}");
  EXPECT_EQ(read_yaml("{a, b: c}"), "{a: nothing@1:3+1, b: c@1:8+1}");
}

TEST(YamlReader, WrittenNulls) {
  EXPECT_EQ(read_yaml("a: null"), "{a: null@1:4+4}");
  EXPECT_EQ(read_yaml("a: ~\nb: NULL"), "{a: null@1:4+1, b: null@2:4+4}");
  EXPECT_EQ(read_yaml("[~, null]"), "[null@1:2+1, null@1:5+4]");
  // The key of the next line is the word null: the value before it is empty all the same.
  EXPECT_EQ(read_yaml("a:\nnullable: x"), "{a: nothing@1:3+0, nullable: x@2:11+1}");
}

TEST(YamlReader, TagsAndAnchors) {
  EXPECT_EQ(read_yaml("a: !!str 5"), "{a: 5@1:10+1}");
  EXPECT_EQ(read_yaml("a: &x b\nc: *x"), "{a: b@1:7+1, c: b@1:7+1}");
  EXPECT_EQ(read_yaml("a: &x [1]\nc: *x"), "{a: [1@1:8+1], c: [1@1:8+1]}");
  EXPECT_EQ(read_yaml("a: &x [*x]"), "R2W0101: an alias is inside the value that it names");
}

TEST(YamlReader, DuplicateKeysAreReportedAndTheFirstCounts) {
  EXPECT_EQ(read_yaml("a: 1\nb: 2\na: 3"), "{a: 1@1:4+1, b: 2@2:4+1} !R2W0105");
  EXPECT_EQ(read_yaml("{a: {b: 1, b: 2}, a: 3}"), "{a: {b: 1@1:9+1}} !R2W0105 !R2W0105");
  EXPECT_EQ(read_yaml("a: 1\n'a': 3"), "{a: 1@1:4+1} !R2W0105");
}

TEST(YamlReader, TheLastOfTwoKeysMayCount) {
  const SourceText source("a: 1\nb: {c: 1, c: 2}\na: 3", "a.yaml");
  const auto document = parse_yaml(source, DuplicateKeys::kLastCounts);
  ASSERT_TRUE(document.ok());
  EXPECT_TRUE(document->problems.empty());
  EXPECT_EQ(shown(source, document->root), "{a: 3@3:4+1, b: {c: 2@2:14+1}}");
}

TEST(YamlReader, Refuses) {
  for (const std::string_view text :
       {"a: b: c", "a: [", "a: 'b", "a: \"b", "\ta: b\n- c", "a: }", "? [a]\n: b", "a: @b", "a: *b",
        "~: a", ": a", "a: 1\nb\n", "a: 1\n b: 2", "a: b\n---\nc: d", "- a\nb: c", "a: \"\\q\""}) {
    EXPECT_EQ(read_yaml(text).substr(0, 8), "R2W0101:") << text;
  }
}

TEST(YamlReader, RefusesWhatIsNoText) {
  using namespace std::string_literals;
  for (const std::string& text :
       {"a: \0b"s, "a: \x04"s, "a: \x7F"s, "a: \xFF"s,
        "\xFF\xFE"
        "a"s,
        "a: \xC0\x80"s, "a: b\rc"s, "a: \xED\xA0\x80"s, std::string((1U << 20U) + 1, ' ')}) {
    EXPECT_EQ(read_yaml(text).substr(0, 8), "R2W0111:") << text.substr(0, 20);
  }
}

// Guarantee, hostile input: YAML: depth, size and aliases are bounded
TEST(YamlReader, Limits) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(read_yaml(nested(40)).substr(0, 3), "[[[");
  EXPECT_EQ(read_yaml(nested(60)).substr(0, 8), "R2W0111:");
  EXPECT_EQ(read_yaml(nested(100'000)).substr(0, 4), "R2W0");
  std::string many = "[";
  for (int i = 0; i < 60'000; ++i) many += "a,";
  EXPECT_EQ(read_yaml(many + "]").substr(0, 8), "R2W0111:");
  std::string bomb = "a0: &a0 [x, x]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before + ", " + before +
            "]\n";
  }
  EXPECT_EQ(read_yaml(bomb).substr(0, 8), "R2W0111:");
}

TEST(YamlReader, NothingToRead) {
  EXPECT_EQ(read_yaml(""), "nothing@1:1+0");
  EXPECT_EQ(read_yaml("# only a remark\n"), "nothing@1:1+0");
  EXPECT_EQ(read_yaml("---\n"), "nothing@1:1+0");
}

}  // namespace
}  // namespace ros2wasm
