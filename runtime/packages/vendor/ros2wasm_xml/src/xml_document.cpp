// See xml_document.hpp.
#include "ros2wasm_xml/xml_document.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace ros2wasm_xml {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr std::string_view kEndOfName = " \t\r\n/>=<&'\"";
constexpr std::size_t kMaxAttributes = 1000;

void append_utf8(std::string& out, std::uint32_t code) {
  const auto put = [&out](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

/// Walks over the text once, from left to right.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::vector<XmlElement> read() {
    skip("\xEF\xBB\xBF");
    while (at_ < text_.size()) {
      if (text_[at_] != '<') {
        characters();
      } else if (skip("<!--")) {
        past("-->");
      } else if (skip("<?")) {
        past("?>");
      } else if (skip("<![CDATA[")) {
        const std::size_t from = at_;
        past("]]>");
        add_text(text_.substr(from, at_ - 3 - from));
      } else if (skip("<!DOCTYPE")) {
        if (text_.substr(at_, text_.find('>', at_) - at_).find('[') != std::string_view::npos) {
          fail("a document type with definitions is not read");
        }
        past(">");
      } else if (skip("</")) {
        close();
      } else {
        open();
      }
    }
    if (!open_.empty()) {
      fail("the element " + elements_[open_.back()].name + " is not closed");
    }
    if (elements_.empty()) {
      fail("it has no element");
    }
    return std::move(elements_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
    throw XmlError(what, static_cast<std::size_t>(std::count(text_.begin(), end, '\n')) + 1);
  }

  bool skip(std::string_view word) {
    const bool is_there = text_.substr(at_, word.size()) == word;
    at_ += is_there ? word.size() : 0;
    return is_there;
  }
  void past(std::string_view word) {
    const std::size_t found = text_.find(word, at_);
    if (found == std::string_view::npos) {
      fail("the text ends before " + std::string(word));
    }
    at_ = found + word.size();
  }
  void skip_space() { at_ = std::min(text_.find_first_not_of(kSpace, at_), text_.size()); }

  std::string name() {
    const std::size_t end = std::min(text_.find_first_of(kEndOfName, at_), text_.size());
    if (end == at_) {
      fail("a name is missing");
    }
    const std::string result(text_.substr(at_, end - at_));
    at_ = end;
    return result;
  }

  /// With entities replaced.
  std::string plain(std::string_view raw) {
    std::string result;
    while (!raw.empty()) {
      const std::size_t next = std::min(raw.find('&'), raw.size());
      result += raw.substr(0, next);
      raw.remove_prefix(next);
      if (raw.empty()) {
        break;
      }
      const std::size_t end = raw.find(';');
      if (end == std::string_view::npos || end > 10) {
        fail("an & must be written as &amp;");
      }
      entity(raw.substr(1, end - 1), result);
      raw.remove_prefix(end + 1);
    }
    return result;
  }
  void entity(std::string_view word, std::string& out) {
    static constexpr std::pair<std::string_view, char> kNamed[] = {
        {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
    for (const auto& [key, character] : kNamed) {
      if (word == key) {
        out += character;
        return;
      }
    }
    const bool is_hex = word.substr(0, 2) == "#x";
    const std::string_view digits = word.substr(is_hex ? 2 : std::min<std::size_t>(1, word.size()));
    const std::string_view allowed = is_hex ? "0123456789abcdefABCDEF" : "0123456789";
    if (word.substr(0, 1) != "#" || digits.empty() || digits.size() > 7 ||
        digits.find_first_not_of(allowed) != std::string_view::npos) {
      fail("the entity &" + std::string(word) + "; is not known");
    }
    const unsigned long code = std::stoul(std::string(digits), nullptr, is_hex ? 16 : 10);
    if (code == 0 || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) {
      fail("&" + std::string(word) + "; is not a valid character");
    }
    append_utf8(out, static_cast<std::uint32_t>(code));
  }

  void add_text(std::string_view text) {
    if (!open_.empty()) {
      elements_[open_.back()].text += text;
    } else if (text.find_first_not_of(kSpace) != std::string_view::npos) {
      fail("there is text outside of the root");
    }
  }
  void characters() {
    const std::size_t end = std::min(text_.find('<', at_), text_.size());
    add_text(plain(text_.substr(at_, end - at_)));
    at_ = end;
  }

  /// The place of a new element, counted on from that of the element before.
  void locate(XmlElement& element) {
    for (; counted_ < at_; ++counted_) {
      if (text_[counted_] == '\n') {
        ++line_;
        line_begin_ = counted_ + 1;
      }
    }
    element.line = line_;
    element.column = at_ - line_begin_ + 1;
  }
  void open() {
    XmlElement element;
    locate(element);
    ++at_;
    if (!elements_.empty() && open_.empty()) {
      fail("there is a second root");
    }
    element.name = name();
    for (skip_space(); at_ < text_.size() && text_[at_] != '>' && text_[at_] != '/'; skip_space()) {
      attribute(element);
    }
    const bool is_empty = skip("/");
    if (!skip(">")) {
      fail("the tag of " + element.name + " does not end");
    }
    const std::size_t index = elements_.size();
    if (!open_.empty()) {
      elements_[open_.back()].children.push_back(index);
    }
    elements_.push_back(std::move(element));
    if (!is_empty) {
      open_.push_back(index);
    }
  }
  void attribute(XmlElement& element) {
    // Each name is compared with all before it.
    if (element.attributes.size() == kMaxAttributes) {
      fail(element.name + " has more than " + std::to_string(kMaxAttributes) + " attributes");
    }
    std::string key = name();
    if (element.attribute(key) != nullptr) {
      fail(element.name + " has two attributes " + key);
    }
    skip_space();
    if (!skip("=")) {
      fail("the attribute " + key + " has no value");
    }
    skip_space();
    const std::string_view quote = text_.substr(at_, 1);
    if (quote != "\"" && quote != "'") {
      fail("the value of " + key + " has no quotes");
    }
    const std::size_t from = ++at_;
    past(quote);
    const std::string_view raw = text_.substr(from, at_ - 1 - from);
    if (raw.find('<') != std::string_view::npos) {
      fail("the value of " + key + " has a <");
    }
    element.attributes.emplace_back(std::move(key), plain(raw));
  }

  void close() {
    const std::string closed = name();
    skip_space();
    if (open_.empty() || elements_[open_.back()].name != closed) {
      fail("</" + closed + "> does not match the open element" +
           (open_.empty() ? "" : " <" + elements_[open_.back()].name + ">"));
    }
    if (!skip(">")) {
      fail("the tag </" + closed + " does not end");
    }
    open_.pop_back();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t counted_ = 0;     ///< up to where lines were counted
  std::size_t line_ = 1;        ///< that `counted_` is in
  std::size_t line_begin_ = 0;  ///< where that line begins
  std::vector<XmlElement> elements_;
  std::vector<std::size_t> open_;  ///< indices, the innermost last
};

}  // namespace

const std::string* XmlElement::attribute(const std::string& key) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const auto& one) { return one.first == key; });
  return found == attributes.end() ? nullptr : &found->second;
}

XmlDocument::XmlDocument(const std::string& text) : elements_(Reader(text).read()) {}

std::vector<const XmlElement*> XmlDocument::children(const XmlElement& of,
                                                     const std::string& name) const {
  std::vector<const XmlElement*> result;
  for (const std::size_t index : of.children) {
    if (name.empty() || elements_[index].name == name) {
      result.push_back(&elements_[index]);
    }
  }
  return result;
}

const XmlElement* XmlDocument::child(const XmlElement& of, const std::string& name) const {
  for (const std::size_t index : of.children) {
    if (elements_[index].name == name) {
      return &elements_[index];
    }
  }
  return nullptr;
}

}  // namespace ros2wasm_xml
