// XML as a plain tree with places. The XML library ends in xml_reader.cpp. No DTD, no entities
// beyond XML's own five, bounded depth and size.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct XmlElement {
  std::string name;
  SourceSpan span;  ///< of `<name`
  std::map<std::string, std::string> attributes;
  std::string text;      ///< character data directly inside, trimmed at both ends
  SourceSpan text_span;  ///< of that text; of the tag when there is none
  std::vector<XmlElement> children;

  /// The first child of that name, or nullptr.
  [[nodiscard]] const XmlElement* child(std::string_view wanted) const;
  /// The attribute's value, or empty.
  [[nodiscard]] std::string attribute(std::string_view wanted) const;
};

enum class XmlNodeKind { kElement, kText, kCdata, kComment };

/// A part of a document as it is written: elements, texts and comments in their order.
struct XmlNode {
  XmlNodeKind kind = XmlNodeKind::kElement;
  std::string text;  ///< the name of an element; of others what they say
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlNode> children;
  std::uint32_t file = 0;  ///< for who reads more than one; never set here
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  /// The attribute's value, or nullptr.
  [[nodiscard]] const std::string* attribute(std::string_view wanted) const;
  void set_attribute(const std::string& name, std::string value);
};

/// Whether an element or attribute can have this name.
[[nodiscard]] bool is_xml_name(std::string_view text);

/// The root element with all that stands in it. White space alone is a text of line breaks only,
/// as many as stand there behind a comment, else one. R2W0120 when the text is not well-formed
/// XML, too large, or uses a prefix that is not declared.
[[nodiscard]] Outcome<XmlNode> parse_xml_nodes(std::string_view text, const std::string& file);

/// The root element. R2W0120 when the text is not well-formed XML (or too large).
[[nodiscard]] Outcome<XmlElement> parse_xml(std::string_view text, const std::string& file);

}  // namespace ros2wasm
