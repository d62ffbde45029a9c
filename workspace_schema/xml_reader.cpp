// See xml_reader.hpp. tinyxml2 is known here only.
#include "workspace_schema/xml_reader.hpp"

#include <tinyxml2.h>

#include <algorithm>

#include "workspace_schema/source_text.hpp"
#include "workspace_schema/text_encoding.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLargestFile = 4U << 20U;
constexpr std::string_view kSpace = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// Walks the library's tree in document order. It knows lines only; columns are found again in the
/// text, from the last place on, so that equal tags on one line are told apart.
class TreeBuilder {
 public:
  explicit TreeBuilder(const SourceText& source) : source_(source) {}

  XmlElement build(const tinyxml2::XMLElement& from) {
    XmlElement element;
    element.name = from.Name();
    const std::size_t line = static_cast<std::size_t>(std::max(1, from.GetLineNum()));
    const std::size_t search_from = std::max(cursor_, source_.line_start(line));
    std::size_t at = source_.text().find("<" + element.name, search_from);
    if (at == std::string_view::npos) at = search_from;
    cursor_ = std::min(at + 1, source_.text().size());
    element.span = source_.span(at, element.name.size() + 1);
    element.text_span = element.span;

    for (const tinyxml2::XMLAttribute* a = from.FirstAttribute(); a != nullptr; a = a->Next()) {
      element.attributes.emplace(a->Name(), a->Value());
    }
    for (const tinyxml2::XMLNode* n = from.FirstChild(); n != nullptr; n = n->NextSibling()) {
      if (const tinyxml2::XMLText* text = n->ToText()) {
        element.text += text->Value();
      } else if (const tinyxml2::XMLElement* child = n->ToElement()) {
        element.children.push_back(build(*child));
      }
    }
    element.text = std::string(trimmed(element.text));
    if (!element.text.empty() && element.children.empty()) place_text(element, at);
    return element;
  }

 private:
  void place_text(XmlElement& element, std::size_t tag_at) {
    const std::string_view all = source_.text();
    std::size_t tag_end = tag_at;
    for (char quote = 0; tag_end < all.size() && (quote != 0 || all[tag_end] != '>'); ++tag_end) {
      const char c = all[tag_end];
      if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = 0;
      }
    }
    if (tag_end >= all.size()) return;
    const std::size_t start = all.find_first_not_of(kSpace, tag_end + 1);
    if (start == std::string_view::npos || all[start] == '<') return;
    const std::size_t end = std::min(all.find('<', start), all.size());
    element.text_span = source_.span(start, trimmed(all.substr(start, end - start)).size());
    cursor_ = end;
  }

  const SourceText& source_;
  std::size_t cursor_ = 0;
};

/// What the library's error means, in the reader's words.
std::string reason_of(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an end tag does not fit the start tag that is open here";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file is empty";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "a tag is not closed with `>`";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute lacks its quotes or its value";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "text is not followed by an end tag";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a CDATA section is not closed with `]]>`";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed with `-->`";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "the `<?xml ... ?>` line is not closed";
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return "a `<! ... >` section is not closed";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply";
    default:
      return "this is not well-formed XML";
  }
}

Diagnostic not_xml(const SourceText& source, std::size_t offset, std::size_t length,
                   std::string reason) {
  return Diagnostic{.code = "R2W0120",
                    .message = "`" + source.file() + "` is not well-formed XML",
                    .span = source.span(offset, length),
                    .label = std::move(reason)};
}

}  // namespace

const XmlElement* XmlElement::child(std::string_view wanted) const {
  const auto found =
      std::find_if(children.begin(), children.end(),
                   [wanted](const XmlElement& element) { return element.name == wanted; });
  return found == children.end() ? nullptr : &*found;
}

std::string XmlElement::attribute(std::string_view wanted) const {
  const auto found = attributes.find(std::string(wanted));
  return found == attributes.end() ? std::string() : found->second;
}

Outcome<XmlElement> parse_xml(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  if (text.size() > kLargestFile) return not_xml(source, 0, 0, "the file is larger than 4 MiB");
  if (const auto bad = first_invalid_utf8(text))
    return not_xml(source, *bad, 1, "this byte is not UTF-8");
  if (const auto nul = text.find('\0'); nul != std::string_view::npos) {
    return not_xml(source, nul, 1, "the file holds a NUL byte");
  }
  tinyxml2::XMLDocument document(true, tinyxml2::PRESERVE_WHITESPACE);
  const tinyxml2::XMLError error = document.Parse(text.data(), text.size());
  if (error != tinyxml2::XML_SUCCESS) {
    const auto line = static_cast<std::size_t>(std::max(1, document.ErrorLineNum()));
    const std::string_view line_text = source.line_text(line);
    const std::size_t indent = std::min(line_text.find_first_not_of(kSpace), line_text.size());
    return not_xml(source, source.line_start(line) + indent, line_text.size() - indent,
                   reason_of(error));
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) return not_xml(source, 0, 0, "there is no element in the file");
  return TreeBuilder(source).build(*root);
}

}  // namespace ros2wasm
