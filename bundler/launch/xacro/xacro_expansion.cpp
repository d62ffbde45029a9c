// See xacro_expansion.hpp: the walk over elements, texts and comments.
#include "bundler/launch/xacro/xacro_expansion.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "bundler/launch/xacro/xacro_element_row.hpp"
#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/xml_writer.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kMostOutput = 16U << 20U;
/// The size of an element in bytes, without its texts.
constexpr std::size_t kNodeSize = 64;
constexpr int kDeepest = 700;
constexpr std::size_t kLongestTrail = 8;
constexpr std::string_view kSpace = " \t\r\n";

bool is_blank(const XmlNode& node) {
  return node.kind == XmlNodeKind::kText &&
         node.text.find_first_not_of(kSpace) == std::string::npos;
}

void stamp(XmlNode& node, std::uint32_t file) {
  node.file = file;
  for (XmlNode& child : node.children) stamp(child, file);
}

}  // namespace

XacroExpansion::XacroExpansion(const XacroRequest& request, const LaunchWorld& world)
    : world_(world), evaluator_(request, world), output_left_(kMostOutput) {}

XmlNode XacroExpansion::parsed(const std::string& path) {
  const std::string shown = xacro_shown(path, world_);
  std::string text = evaluator_.read(path);
  auto root = parse_xml_nodes(text, shown);
  if (!root) throw XacroFault{.ready = root.errors()};
  stamp(*root, static_cast<std::uint32_t>(files_.size()));
  files_.push_back({.shown = shown, .text = std::move(text)});
  return std::move(*root);
}

XmlNode XacroExpansion::document(const std::string& path) {
  evaluator_.files.push_back(path);
  XmlNode root = parsed(path);
  if (const std::string* space = root.attribute("xacro:targetNamespace"))
    root.set_attribute("xmlns", std::string(*space));
  XacroSymbols symbols;
  XacroMacros macros;
  at_ = {root.file, root.line, root.column, root.text.size() + 1};
  return expanded(root, {symbols, macros});
}

XmlNode XacroExpansion::expanded(const XmlNode& from, Scope scope) {
  XmlNode result{.text = from.text, .file = from.file, .line = from.line, .column = from.column};
  attributes(from, scope, result);
  content(from, scope, result);
  return result;
}

void XacroExpansion::attributes(const XmlNode& from, Scope scope, XmlNode& into) {
  for (const auto& [name, written] : from.attributes) {
    if (name == "xmlns:xacro" || name.starts_with("xacro:")) continue;
    into.set_attribute(name, evaluator_.text(written, scope.symbols));
  }
}

void XacroExpansion::content(const XmlNode& from, Scope scope, XmlNode& into) {
  if (++depth_ > kDeepest)
    throw XacroFault{.message = "macros and elements stand too deep in each other",
                     .why = {"a macro that calls itself needs a condition that ends it"}};
  bool in_comments = false;
  for (const XmlNode& child : from.children) {
    if (child.kind != XmlNodeKind::kElement) {
      text(child, scope, into, in_comments);
      continue;
    }
    in_comments = false;
    const Place before =
        std::exchange(at_, Place{child.file, child.line, child.column, child.text.size() + 1});
    element(child, scope, into);
    at_ = before;
  }
  --depth_;
}

void XacroExpansion::element(const XmlNode& from, Scope scope, XmlNode& into) {
  evaluator_.spend(1);
  if (const Row* row = row_of(from.text)) {
    (this->*row->expand)(from, scope, into);
  } else if (from.text.starts_with("xacro:")) {
    call(from, scope, into);
  } else {
    add(expanded(from, scope), into);
  }
}

/// Texts, comments and the rest. `in_comments`: whether comments are evaluated.
void XacroExpansion::text(const XmlNode& from, Scope scope, XmlNode& into, bool& in_comments) {
  XmlNode node = from;
  if (node.kind == XmlNodeKind::kText) {
    node.text = evaluator_.text(from.text, scope.symbols);
    if (!is_blank(node)) in_comments = false;
  } else if (node.kind == XmlNodeKind::kComment) {
    if (node.text.find("xacro:eval-comments") != std::string::npos) {
      in_comments = node.text.find("xacro:eval-comments:off") == std::string::npos;
      return;
    }
    if (in_comments) node.text = evaluator_.text(from.text, scope.symbols);
  }
  add(std::move(node), into);
}

void XacroExpansion::add(XmlNode node, XmlNode& into) {
  std::size_t size = kNodeSize + node.text.size();
  for (const auto& [name, value] : node.attributes) size += name.size() + value.size();
  if (size > output_left_) throw XacroFault{.message = "the expanded document is too large"};
  output_left_ -= size;
  into.children.push_back(std::move(node));
}

const std::string& XacroExpansion::needed(const XmlNode& from, const char* name) const {
  if (const std::string* value = from.attribute(name)) return *value;
  throw XacroFault{.message = "`" + from.text + "` needs the attribute `" + name + "`"};
}

/// Comments directly before an element of xacro are about it, and go with it. A blank line keeps
/// them, and so does the end of another such element, which leaves a mark: only the last mark
/// counts. Gives the mark to be set behind the element; 0: none.
int XacroExpansion::drop_comments(XmlNode& into) {
  auto& nodes = into.children;
  const auto skip_old_marks = [&](std::size_t end) {
    while (end > 0 && nodes[end - 1].file == kXacroMark &&
           static_cast<int>(nodes[end - 1].line) != last_mark_)
      --end;
    return end;
  };
  std::size_t end = skip_old_marks(nodes.size());
  while (end > 0) {
    std::size_t at = end;
    const XmlNode& last = nodes[at - 1];
    if (is_blank(last) && std::count(last.text.begin(), last.text.end(), '\n') <= 1)
      at = skip_old_marks(at - 1);
    if (at == 0 || nodes[at - 1].kind != XmlNodeKind::kComment) return ++last_mark_;
    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(at) - 1);
    end = skip_old_marks(at - 1);
  }
  return 0;
}

void XacroExpansion::end_comments(int mark, XmlNode& into) {
  if (mark == 0) return;
  XmlNode node{.kind = XmlNodeKind::kText, .text = "\n\n"};
  node.file = kXacroMark;
  node.line = static_cast<std::uint32_t>(mark);
  into.children.push_back(std::move(node));
}

std::optional<SourceSpan> XacroExpansion::place() const {
  if (at_.file >= files_.size()) return std::nullopt;
  const File& file = files_[at_.file];
  const SourceText source(file.text, file.shown);
  const std::size_t begin = source.line_start(at_.line) + std::max(1U, at_.column) - 1;
  return source.span(begin, at_.size);
}

std::vector<std::string> XacroExpansion::trail() const {
  std::vector<std::string> result;
  for (auto one = trail_.rbegin(); one != trail_.rend(); ++one) {
    if (result.size() == kLongestTrail) {
      result.push_back("and " + std::to_string(trail_.rend() - one) + " more");
      break;
    }
    const bool known = one->at.file < files_.size();
    result.push_back(one->what + (known ? " at " + files_[one->at.file].shown + ":" +
                                              std::to_string(one->at.line)
                                        : std::string()));
  }
  return result;
}

Outcome<std::string> expand_xacro(const XacroRequest& request, const LaunchWorld& world) {
  XacroExpansion expansion(request, world);
  const auto failed = [&](const std::string& message, std::vector<std::string> why) {
    for (std::string& one : expansion.trail()) why.push_back(std::move(one));
    return Diagnostic{
        .code = "R2W0418",
        .message = "`" + xacro_shown(request.path, world) + "` cannot be expanded: " + message,
        .span = expansion.place(),
        .why = std::move(why)};
  };
  try {
    return xml_text(expansion.document(request.path));
  } catch (XacroFault& fault) {
    if (!fault.ready.empty()) return std::move(fault.ready);
    return failed(fault.message, std::move(fault.why));
  } catch (const PythonFault& fault) {
    return failed(fault.message, {});
  }
}

}  // namespace ros2wasm
