// See xml_writer.hpp.
#include "workspace_schema/base/xml_writer.hpp"

#include <string_view>

namespace ros2wasm {
namespace {

std::string escaped(std::string_view text, bool in_attribute) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"' && in_attribute) {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

bool is_space(const XmlNode& node) {
  return node.kind == XmlNodeKind::kText &&
         node.text.find_first_not_of(" \t\r\n") == std::string::npos;
}

void write_leaf(const XmlNode& node, std::string& into) {
  switch (node.kind) {
    case XmlNodeKind::kText:
      into += escaped(node.text, false);
      return;
    case XmlNodeKind::kCdata:
      into += "<![CDATA[" + node.text + "]]>";
      return;
    case XmlNodeKind::kComment:
      into += "<!--" + node.text + "-->";
      return;
    case XmlNodeKind::kElement:
      return;
  }
}

void write(const XmlNode& node, std::size_t depth, std::string& into) {
  const std::string indent(2 * depth, ' ');
  into += indent;
  if (node.kind != XmlNodeKind::kElement) {
    write_leaf(node, into);
    into += '\n';
    return;
  }
  into += "<" + node.text;
  for (const auto& [name, value] : node.attributes)
    into += " " + name + "=\"" + escaped(value, true) + "\"";
  if (node.children.empty()) {
    into += "/>\n";
    return;
  }
  into += '>';
  if (node.children.size() == 1 && node.children[0].kind == XmlNodeKind::kText) {
    write_leaf(node.children[0], into);
  } else {
    into += '\n';
    for (const XmlNode& child : node.children)
      if (!is_space(child)) write(child, depth + 1, into);
    into += indent;
  }
  into += "</" + node.text + ">\n";
}

}  // namespace

std::string xml_text(const XmlNode& element) {
  std::string result;
  write(element, 0, result);
  return result;
}

}  // namespace ros2wasm
