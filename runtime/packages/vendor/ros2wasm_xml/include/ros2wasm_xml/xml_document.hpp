// XML as a tree of elements: all that descriptions of robots need, and nothing that can be used
// against the reader. It knows neither namespaces nor document types, and does not recurse.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ros2wasm_xml {

/// A text that is not valid XML, with the line of the mistake.
class XmlError : public std::runtime_error {
 public:
  XmlError(const std::string& reason, std::size_t line)
      : std::runtime_error("line " + std::to_string(line) + ": " + reason),
        reason_(reason),
        line_(line) {}

  /// The message without the line.
  const std::string& reason() const { return reason_; }
  std::size_t line() const { return line_; }

 private:
  std::string reason_;
  std::size_t line_;
};

struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;  ///< in the order of the text
  std::string text;                                             ///< between its children
  std::vector<std::size_t> children;                            ///< indices of the document
  std::size_t line = 0;                                         ///< of its `<`, from 1
  std::size_t column = 0;                                       ///< of its `<`, from 1, in bytes

  /// The value, or null when there is no such attribute.
  const std::string* attribute(const std::string& key) const;
};

class XmlDocument {
 public:
  /// Throws XmlError.
  explicit XmlDocument(const std::string& text);

  const XmlElement& root() const { return elements_.front(); }
  /// The children with a name, or all of them.
  std::vector<const XmlElement*> children(const XmlElement& of, const std::string& name = "") const;
  /// The first of them, or null.
  const XmlElement* child(const XmlElement& of, const std::string& name) const;

 private:
  std::vector<XmlElement> elements_;  ///< in the order of the text, so the first is the root
};

}  // namespace ros2wasm_xml
