// See xml_reader.hpp. tinyxml2 is known here only.
#include "workspace_schema/base/xml_reader.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string>

#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/text_encoding.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLargestFile = 4U << 20U;
constexpr std::string_view kSpace = " \t\r\n";

/// The library knows lines only; columns are found again in the text, from the last place on, so
/// that equal tags on one line are told apart. To be asked in the order of the document.
class TagFinder {
 public:
  explicit TagFinder(const SourceText& source) : source_(source) {}

  std::size_t find(const tinyxml2::XMLElement& element) {
    const std::size_t line = static_cast<std::size_t>(std::max(1, element.GetLineNum()));
    const std::size_t search_from = std::max(cursor_, source_.line_start(line));
    std::size_t at = source_.text().find(std::string("<") + element.Name(), search_from);
    if (at == std::string_view::npos) at = search_from;
    cursor_ = std::min(at + 1, source_.text().size());
    return at;
  }
  void go_on_from(std::size_t offset) { cursor_ = offset; }

 private:
  const SourceText& source_;
  std::size_t cursor_ = 0;
};

/// Walks the library's tree in document order.
class TreeBuilder {
 public:
  explicit TreeBuilder(const SourceText& source) : source_(source), tags_(source) {}

  XmlElement build(const tinyxml2::XMLElement& from) {
    XmlElement element;
    element.name = from.Name();
    const std::size_t at = tags_.find(from);
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
    tags_.go_on_from(end);
  }

  const SourceText& source_;
  TagFinder tags_;
};

/// The meaning of the library's error, in the words of the person who wrote the file.
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

const std::string* XmlNode::attribute(std::string_view wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [wanted](const auto& one) { return one.first == wanted; });
  return found == attributes.end() ? nullptr : &found->second;
}

void XmlNode::set_attribute(const std::string& name, std::string value) {
  for (auto& [one, old] : attributes) {
    if (one != name) continue;
    old = std::move(value);
    return;
  }
  attributes.emplace_back(name, std::move(value));
}

bool is_xml_name(std::string_view text) {
  const auto fits = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == ':' || c == '-' || c == '.' || c >= 0x80;
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), fits) &&
         std::string_view("0123456789-.").find(text.front()) == std::string_view::npos;
}

namespace {

/// Parses the text into the caller's `document`; returns the error, if any.
std::optional<Diagnostic> load(const SourceText& source, tinyxml2::XMLDocument& document) {
  const std::string_view text = source.text();
  if (text.size() > kLargestFile) return not_xml(source, 0, 0, "the file is larger than 4 MiB");
  if (const auto bad = first_invalid_utf8(text))
    return not_xml(source, *bad, 1, "this byte is not UTF-8");
  if (const auto nul = text.find('\0'); nul != std::string_view::npos)
    return not_xml(source, nul, 1, "the file holds a NUL byte");
  const tinyxml2::XMLError error = document.Parse(text.data(), text.size());
  if (error != tinyxml2::XML_SUCCESS) {
    const auto line = static_cast<std::size_t>(std::max(1, document.ErrorLineNum()));
    const std::string_view line_text = source.line_text(line);
    const std::size_t indent = std::min(line_text.find_first_not_of(kSpace), line_text.size());
    return not_xml(source, source.line_start(line) + indent, line_text.size() - indent,
                   reason_of(error));
  }
  if (document.RootElement() == nullptr)
    return not_xml(source, 0, 0, "there is no element in the file");
  return std::nullopt;
}

std::string_view prefix_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

class NodeBuilder {
 public:
  explicit NodeBuilder(const SourceText& source) : source_(source), tags_(source) {}

  XmlNode build(const tinyxml2::XMLElement& from) {
    const std::size_t at = tags_.find(from);
    const SourceSpan span = source_.span(at, 0);
    XmlNode node{.text = from.Name(), .line = span.line, .column = span.column};
    const std::set<std::string, std::less<>> outer = prefixes_;
    for (const tinyxml2::XMLAttribute* a = from.FirstAttribute(); a != nullptr; a = a->Next()) {
      if (node.attribute(a->Name()) != nullptr)
        fail(at, node, std::string("the attribute `") + a->Name() + "` appears here twice");
      std::string value = a->Value();
      std::replace_if(
          value.begin(), value.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; },
          ' ');
      if (prefix_of(a->Name()) == "xmlns") prefixes_.insert(std::string(a->Name()).substr(6));
      node.attributes.emplace_back(a->Name(), std::move(value));
    }
    check_name(at, node, node.text);
    for (const auto& [name, value] : node.attributes) check_name(at, node, name);
    children(from, node);
    prefixes_ = outer;
    return node;
  }

  [[nodiscard]] Diagnostics& problems() { return problems_; }

 private:
  void children(const tinyxml2::XMLElement& from, XmlNode& node) {
    const tinyxml2::XMLNode* first = from.FirstChild();
    if (first != nullptr && first->GetLineNum() > from.GetLineNum() && first->ToText() == nullptr)
      node.children.push_back(space(1));
    for (const tinyxml2::XMLNode* n = first; n != nullptr; n = n->NextSibling()) {
      if (const tinyxml2::XMLElement* element = n->ToElement()) {
        node.children.push_back(build(*element));
      } else {
        node.children.push_back(leaf(*n));
        if (n->ToUnknown() != nullptr) unexpected(*n);
      }
      const tinyxml2::XMLNode* next = n->NextSibling();
      if (n->ToText() != nullptr || (next != nullptr && next->ToText() != nullptr)) continue;
      node.children.push_back(space(breaks_between(*n, next)));
    }
  }

  static XmlNode leaf(const tinyxml2::XMLNode& from) {
    XmlNode node{.kind = XmlNodeKind::kComment, .text = from.Value()};
    node.line = static_cast<std::uint32_t>(std::max(0, from.GetLineNum()));
    if (const tinyxml2::XMLText* text = from.ToText())
      node.kind = text->CData() ? XmlNodeKind::kCdata : XmlNodeKind::kText;
    return node;
  }

  /// The library drops white space between tags; the lines of comments tell how much it was.
  static int breaks_between(const tinyxml2::XMLNode& from, const tinyxml2::XMLNode* next) {
    if (from.ToComment() == nullptr || next == nullptr) return 1;
    const std::string_view text = from.Value();
    const auto inside = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    return std::clamp(next->GetLineNum() - from.GetLineNum() - inside, 0, 1000);
  }
  static XmlNode space(int breaks) {
    return {.kind = XmlNodeKind::kText,
            .text = breaks == 0 ? " " : std::string(static_cast<std::size_t>(breaks), '\n')};
  }

  void check_name(std::size_t at, const XmlNode& node, const std::string& name) {
    if (!is_xml_name(name)) fail(at, node, "`" + name + "` is not a name");
    const std::string_view prefix = prefix_of(name);
    if (!prefix.empty() && !prefixes_.contains(prefix))
      fail(at, node,
           "the prefix `" + std::string(prefix) +
               "` is not declared by an xmlns:" + std::string(prefix));
  }

  void unexpected(const tinyxml2::XMLNode& from) {
    const auto line = static_cast<std::size_t>(std::max(1, from.GetLineNum()));
    if (problems_.empty())
      problems_.push_back(
          not_xml(source_, source_.line_start(line), 1, "`<!` begins nothing here"));
  }

  void fail(std::size_t at, const XmlNode& node, std::string reason) {
    if (problems_.empty())
      problems_.push_back(not_xml(source_, at, node.text.size() + 1, std::move(reason)));
  }

  const SourceText& source_;
  TagFinder tags_;
  std::set<std::string, std::less<>> prefixes_{"xml", "xmlns"};
  Diagnostics problems_;
};

}  // namespace

Outcome<XmlNode> parse_xml_nodes(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  tinyxml2::XMLDocument document(true, tinyxml2::PRESERVE_WHITESPACE);
  if (auto problem = load(source, document)) return std::move(*problem);
  const tinyxml2::XMLElement* second = document.RootElement()->NextSiblingElement();
  if (second != nullptr) {
    const std::size_t begin =
        source.line_start(static_cast<std::size_t>(std::max(1, second->GetLineNum())));
    return not_xml(source, begin, 1, "a file has one element at its top");
  }
  const std::size_t control =
      text.find_first_of(std::string_view("\x01\x02\x03\x04\x05\x06\x07\x08\x0B\x0C\x0E\x0F"
                                          "\x10\x11\x12\x13\x14\x15\x16\x17\x18\x19\x1A\x1B"
                                          "\x1C\x1D\x1E\x1F"));
  if (control != std::string_view::npos)
    return not_xml(source, control, 1, "XML has no such control character");
  NodeBuilder builder(source);
  XmlNode root = builder.build(*document.RootElement());
  if (!builder.problems().empty()) return std::move(builder.problems());
  return root;
}

Outcome<XmlElement> parse_xml(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  tinyxml2::XMLDocument document(true, tinyxml2::PRESERVE_WHITESPACE);
  if (auto problem = load(source, document)) return std::move(*problem);
  return TreeBuilder(source).build(*document.RootElement());
}

}  // namespace ros2wasm
