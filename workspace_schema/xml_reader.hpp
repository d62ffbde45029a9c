// XML as a plain tree with places. The XML library ends in xml_reader.cpp. No DTD, no entities
// beyond XML's own five, bounded depth and size.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/diagnostic.hpp"
#include "workspace_schema/outcome.hpp"

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

/// The root element. R2W0120 when the text is not well-formed XML (or too large).
[[nodiscard]] Outcome<XmlElement> parse_xml(std::string_view text, const std::string& file);

}  // namespace ros2wasm
