// XML as it is written, with its texts and comments, and back to text.
#include <gtest/gtest.h>

#include "workspace_schema/base/xml_reader.hpp"
#include "workspace_schema/base/xml_writer.hpp"

namespace ros2wasm {
namespace {

std::string again(const std::string& xml) {
  const auto root = parse_xml_nodes(xml, "a.xml");
  return root ? xml_text(*root) : root.errors()[0].code + ": " + root.errors()[0].label;
}

TEST(XmlNodes, KeepWhatIsThereInItsOrder) {
  EXPECT_EQ(again("<?xml version='1.0'?><!-- out --><a z='1' b=\"2\"/>"), "<a z=\"1\" b=\"2\"/>\n");
  EXPECT_EQ(again("<a>x<b/>y<!-- c --><![CDATA[<d>]]></a>"),
            "<a>\n  x\n  <b/>\n  y\n  <!-- c -->\n  <![CDATA[<d>]]>\n</a>\n");
  EXPECT_EQ(again("<a> two words </a>"), "<a> two words </a>\n");
  EXPECT_EQ(again("<a><b>\n</b></a>"), "<a>\n  <b/>\n</a>\n");
  EXPECT_EQ(again("<a b='&lt;&amp;&quot;&#39;'>&gt;&#xe4;</a>"),
            "<a b=\"&lt;&amp;&quot;'\">&gt;\xC3\xA4</a>\n");
  EXPECT_EQ(again("<a b='1\n 2\t3'/>"), "<a b=\"1  2 3\"/>\n");
  EXPECT_EQ(again("<?xml version='1.0'?>\n<?model 'x'?>\n<a/>"), "<a/>\n");
}

TEST(XmlNodes, HaveTheirPlaces) {
  const auto root = parse_xml_nodes("<a>\n  <b/><b/>\n  <!-- c -->\n\n  <b/></a>", "a.xml");
  ASSERT_TRUE(root.ok());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
  std::string spaces;
  for (const XmlNode& child : root->children) {
    if (child.kind == XmlNodeKind::kElement) places.emplace_back(child.line, child.column);
    if (child.kind == XmlNodeKind::kText) spaces += child.text + "|";
  }
  EXPECT_EQ(places, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{2, 3}, {2, 7}, {5, 3}}));
  EXPECT_EQ(spaces, "\n|\n|\n|\n\n|\n|");
}

TEST(XmlNodes, WhatIsNoXmlIsRefused) {
  for (const char* xml : {"", "a", "<a>", "<a/><b/>", "<a b='1' b='2'/>", "<a b=1/>", "<a></b>",
                          "<x:a/>", "<a x:b='1'/>", "<a><b xmlns:x='u'/><x:c/></a>", "<a>\xff</a>",
                          "<a><!b></a>", "<a><?b?></a>", "<a,b/>", "<a b,='1'/>", "<a>\x01</a>"})
    EXPECT_EQ(again(xml).substr(0, 8), "R2W0120:") << xml;
  EXPECT_EQ(again("<x:a xmlns:x='u'><x:b/></x:a>"), "<x:a xmlns:x=\"u\">\n  <x:b/>\n</x:a>\n");
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_EQ(again(deep).substr(0, 8), "R2W0120:");
}

}  // namespace
}  // namespace ros2wasm
