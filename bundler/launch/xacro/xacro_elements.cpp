// See xacro_expansion.hpp: what the elements of xacro do, but macros.
#include <algorithm>
#include <iterator>
#include <string_view>
#include <tuple>

#include "bundler/launch/file_pattern.hpp"
#include "bundler/launch/python/python_parser.hpp"
#include "bundler/launch/xacro/xacro_element_row.hpp"
#include "bundler/launch/xacro/xacro_expansion.hpp"

namespace ros2wasm {
namespace {

[[noreturn]] void fail(std::string message) {
  throw XacroFault{.message = std::move(message)};
}

/// Declarations of prefixes stay valid where content goes to.
void take_prefixes(const XmlNode& from, XmlNode& into) {
  for (const auto& [name, value] : from.attributes)
    if (name.starts_with("xmlns:") && name != "xmlns:xacro" && into.attribute(name) == nullptr)
      into.set_attribute(name, value);
}

}  // namespace

void xacro_take_content(XmlNode& from, XmlNode& into) {
  take_prefixes(from, into);
  std::move(from.children.begin(), from.children.end(), std::back_inserter(into.children));
}

const XacroExpansion::Row* XacroExpansion::row_of(const std::string& name) {
  using E = XacroExpansion;
  static const Row rows[] = {
      {"xacro:arg", &E::argument},
      {"xacro:attribute", &E::attribute},
      {"xacro:call", &E::dynamic_call},
      {"xacro:element", &E::named_element},
      {"xacro:if", &E::condition},
      {"xacro:include", &E::include},
      {"xacro:insert_block", &E::insert_block},
      {"xacro:macro", &E::macro},
      {"xacro:property", &E::property},
      {"xacro:unless", &E::condition},
  };
  const auto* found = std::find_if(std::begin(rows), std::end(rows),
                                   [&](const Row& row) { return row.tag == name; });
  return found == std::end(rows) ? nullptr : found;
}

void XacroExpansion::include(const XmlNode& from, Scope scope, XmlNode& into) {
  const std::string& written = needed(from, "filename");
  const std::string* optional = from.attribute("optional");
  const std::string* space = from.attribute("ns");
  std::shared_ptr<XacroSymbols> symbols;
  std::shared_ptr<XacroMacros> macros;
  if (space != nullptr && !space->empty()) {
    const std::string name = evaluator_.text(*space, scope.symbols);
    symbols = std::make_shared<XacroSymbols>(
        XacroSymbols{.parent = &scope.symbols, .is_namespace = true});
    macros = std::make_shared<XacroMacros>();
    scope.symbols.own[name] = {.space = symbols};
    scope.macros.own.erase(name);
    scope.macros.spaces[name] = macros;
  }
  const bool may_lack = optional != nullptr && XacroEvaluator::condition({*optional}, *optional);
  const Scope inner = symbols ? Scope{*symbols, *macros} : scope;
  const std::string path = evaluator_.absolute(evaluator_.text(written, scope.symbols));
  XmlNode content_of_it;
  const auto before = std::tuple(depth_, at_, trail_.size(), evaluator_.files.size());
  try {
    if (is_file_pattern(path)) {
      for (const std::string& one : matching_paths(path, world_))
        included(one, inner, content_of_it);
    } else {
      included(path, inner, content_of_it);
    }
  } catch (const XacroFault& fault) {
    if (!may_lack || !fault.no_file) throw;
    depth_ = std::get<0>(before);
    at_ = std::get<1>(before);
    trail_.resize(std::get<2>(before));
    evaluator_.files.resize(std::get<3>(before));
  }
  const int mark = drop_comments(into);
  xacro_take_content(content_of_it, into);
  end_comments(mark, into);
}

void XacroExpansion::included(const std::string& path, Scope scope, XmlNode& into) {
  if (evaluator_.files.size() >= kMostOpenFiles) fail("too many files include each other");
  evaluator_.files.push_back(path);
  trail_.push_back({.what = "included", .at = at_});
  XmlNode root = expanded(parsed(path), scope);
  xacro_take_content(root, into);
  trail_.pop_back();
  evaluator_.files.pop_back();
}

void XacroExpansion::property(const XmlNode& from, Scope scope, XmlNode& into) {
  const int mark = drop_comments(into);
  end_comments(mark, into);
  const std::string name = evaluator_.text(needed(from, "name"), scope.symbols);
  if (!is_python_name(name)) fail("`" + name + "` is not a valid name for a property");
  if (name.starts_with("__")) fail("names of properties do not begin with `__`: `" + name + "`");
  const auto flag = [&](const char* attribute, bool otherwise) {
    const std::string* written = from.attribute(attribute);
    if (written == nullptr || written->empty()) return otherwise;
    return XacroEvaluator::condition(evaluator_.value(*written, scope.symbols), *written);
  };
  const std::string* value = from.attribute("value");
  const std::string* otherwise = from.attribute("default");
  const std::string* reach = from.attribute("scope");
  const bool remove = flag("remove", false);
  if ((value != nullptr ? 1 : 0) + (otherwise != nullptr ? 1 : 0) + (remove ? 1 : 0) > 1)
    fail("`default`, `value` and `remove` exclude each other: property `" + name + "`");
  const bool known = scope.symbols.find(name) != nullptr;
  if (remove && known) {
    for (XacroSymbols* table = &scope.symbols; table != nullptr; table = table->parent)
      table->own.erase(name);
    return;
  }
  if (otherwise != nullptr) {
    if (known || evaluator_.find(name, scope.symbols)) return;
    value = otherwise;
  }
  bool lazily = flag("lazy_eval", true);
  XacroSymbols* table = &scope.symbols;
  if (reach != nullptr && *reach == "global") {
    while (table->parent != nullptr) table = table->parent;
    lazily = false;
  } else if (reach != nullptr && *reach == "parent") {
    const bool in_macro = !table->is_namespace;
    table = table->parent;
    while (in_macro && table != nullptr && table->is_namespace) table = table->parent;
    if (table == nullptr) fail("property `" + name + "`: there is no scope around this one");
    lazily = false;
  }
  if (value == nullptr) {
    evaluator_.spend(from.children.size());
    table->own["**" + name] = {.block = std::make_shared<const XmlNode>(from)};
  } else {
    evaluator_.set(*table, name,
                   lazily ? PythonValue{*value} : evaluator_.value(*value, scope.symbols), lazily);
  }
}

void XacroExpansion::argument(const XmlNode& from, Scope scope, XmlNode& into) {
  const std::string& name = needed(from, "name");
  const std::string& otherwise = needed(from, "default");
  if (!evaluator_.arguments.contains(name))
    evaluator_.arguments[name] = evaluator_.text(otherwise, scope.symbols);
  end_comments(drop_comments(into), into);
}

void XacroExpansion::named_element(const XmlNode& from, Scope scope, XmlNode& into) {
  XmlNode renamed = from;
  renamed.text = evaluator_.text(needed(from, "xacro:name"), scope.symbols);
  if (!is_xml_name(renamed.text)) fail("`" + renamed.text + "` is not a valid name for an element");
  evaluator_.spend(1 + from.children.size());
  std::erase_if(renamed.attributes, [](const auto& one) { return one.first == "xacro:name"; });
  element(renamed, scope, into);
}

void XacroExpansion::attribute(const XmlNode& from, Scope scope, XmlNode& into) {
  const std::string name = evaluator_.text(needed(from, "name"), scope.symbols);
  if (!is_xml_name(name)) fail("`" + name + "` is not a valid name for an attribute");
  into.set_attribute(name, evaluator_.text(needed(from, "value"), scope.symbols));
}

void XacroExpansion::condition(const XmlNode& from, Scope scope, XmlNode& into) {
  const int mark = drop_comments(into);
  const std::string& written = needed(from, "value");
  const bool holds = XacroEvaluator::condition(evaluator_.value(written, scope.symbols), written);
  if (holds == (from.text == "xacro:if")) {
    XmlNode inner;
    content(from, scope, inner);
    std::move(inner.children.begin(), inner.children.end(), std::back_inserter(into.children));
  }
  end_comments(mark, into);
}

void XacroExpansion::insert_block(const XmlNode& from, Scope scope, XmlNode& into) {
  const std::string& name = needed(from, "name");
  const XacroSymbol* all = scope.symbols.find("**" + name);
  const XacroSymbol* one = all == nullptr ? scope.symbols.find("*" + name) : nullptr;
  if (all == nullptr && one == nullptr) fail("there is no block `" + name + "`");
  const std::shared_ptr<const XmlNode> block = all != nullptr ? all->block : one->block;
  if (one != nullptr) return add(expanded(*block, scope), into);
  XmlNode inner;
  content(*block, scope, inner);
  std::move(inner.children.begin(), inner.children.end(), std::back_inserter(into.children));
}

}  // namespace ros2wasm
