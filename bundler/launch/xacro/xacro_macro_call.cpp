// See xacro_expansion.hpp: macros and their calls.
#include <algorithm>

#include "bundler/launch/xacro/xacro_element_row.hpp"
#include "bundler/launch/xacro/xacro_expansion.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

[[noreturn]] void fail(std::string message, std::vector<std::string> why = {}) {
  throw XacroFault{.message = std::move(message), .why = std::move(why)};
}

constexpr std::string_view kPrefix = "xacro:";

std::size_t size_of(const XmlNode& node) {
  std::size_t result = 1;
  for (const XmlNode& child : node.children) result += size_of(child);
  return result;
}

/// `a.b.name`: the namespaces, then the name.
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> result(1);
  for (const char c : name) {
    if (c == '.') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

[[noreturn]] void unknown(const std::string& name, const XacroMacros& macros) {
  std::vector<std::string> names;
  for (const XacroMacros* table = &macros; table != nullptr; table = table->parent)
    for (const auto& [one, macro] : table->own) names.push_back(one);
  std::vector<std::string> why;
  if (const auto similar = nearest(name, names)) why.push_back("there is `" + *similar + "`");
  fail("there is no macro `" + name + "`", std::move(why));
}

}  // namespace

void XacroExpansion::macro(const XmlNode& from, Scope scope, XmlNode& into) {
  end_comments(drop_comments(into), into);
  std::string name = needed(from, "name");
  if (name == "call") fail("a macro cannot have the name `call`");
  if (name.find('.') != std::string::npos)
    fail("`" + name + "`: the names of macros have no `.`, which follows a namespace");
  if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
  evaluator_.spend(size_of(from));
  const std::string* parameters = from.attribute("params");
  XacroMacro result{.name = name, .body = from};
  if (parameters != nullptr) result.parameters = xacro_parameters(*parameters);
  scope.macros.spaces.erase(name);
  scope.macros.own[name] = std::make_shared<const XacroMacro>(std::move(result));
}

void XacroExpansion::dynamic_call(const XmlNode& from, Scope scope, XmlNode& into) {
  const std::string name = evaluator_.text(needed(from, "macro"), scope.symbols);
  if (name.empty()) fail("`xacro:call` needs the name of a macro");
  XmlNode renamed = from;
  evaluator_.spend(size_of(from));
  std::erase_if(renamed.attributes, [](const auto& one) { return one.first == "macro"; });
  call_of(name, renamed, scope, into);
}

void XacroExpansion::call(const XmlNode& from, Scope scope, XmlNode& into) {
  call_of(from.text.substr(kPrefix.size()), from, scope, into);
}

void XacroExpansion::call_of(const std::string& name, const XmlNode& from, Scope scope,
                             XmlNode& into) {
  std::shared_ptr<const XacroMacro> macro = scope.macros.find(name);
  // Keeps the namespaces alive: the called macro may replace the one that it is defined in.
  std::vector<std::shared_ptr<void>> kept;
  XacroSymbols* symbols = &scope.symbols;
  XacroMacros* macros = &scope.macros;
  if (macro == nullptr) {
    const std::vector<std::string> parts = parts_of(name);
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      const XacroSymbol* symbol = symbols->find(parts[i]);
      const auto space = macros->space(parts[i]);
      if (symbol == nullptr || !symbol->space || !space) unknown(name, scope.macros);
      kept.push_back(symbol->space);
      kept.push_back(space);
      symbols = symbol->space.get();
      macros = space.get();
    }
    macro = parts.size() > 1 ? macros->find(parts.back()) : nullptr;
    if (macro == nullptr) unknown(name, *macros);
  }
  XacroSymbols inner{.parent = symbols};
  XacroMacros inner_macros{.parent = macros};
  trail_.push_back({.what = "in the macro `" + macro->name + "`, called", .at = at_});
  arguments_of(from, *macro, {*symbols, *macros}, inner);
  XmlNode body;
  content(macro->body, {inner, inner_macros}, body);
  for (const auto& [attribute, value] : macro->body.attributes)
    if (attribute.starts_with("xmlns:"))
      body.set_attribute(attribute, evaluator_.text(value, inner));
  trail_.pop_back();
  const int mark = drop_comments(into);
  xacro_take_content(body, into);
  end_comments(mark, into);
}

/// The call's attributes, then its blocks, then defaults, all of them as the caller sees them.
void XacroExpansion::arguments_of(const XmlNode& from, const XacroMacro& macro, Scope scope,
                                  XacroSymbols& inner) {
  std::vector<const XacroParameter*> open;
  for (const XacroParameter& one : macro.parameters) open.push_back(&one);
  for (const auto& [name, written] : from.attributes) {
    const auto at = std::find_if(open.begin(), open.end(), [&, &wanted = name](const auto* one) {
      return one->name == wanted;
    });
    if (at == open.end()) fail("the macro `" + macro.name + "` has no parameter `" + name + "`");
    open.erase(at);
    evaluator_.set(inner, name, evaluator_.value(written, scope.symbols), false);
  }

  XmlNode given;
  content(from, scope, given);
  std::vector<XmlNode*> blocks;
  for (XmlNode& child : given.children)
    if (child.kind == XmlNodeKind::kElement) blocks.push_back(&child);
  std::size_t used = 0;
  for (const XacroParameter* one : open) {
    if (!one->name.starts_with('*')) continue;
    if (used == blocks.size())
      fail("the macro `" + macro.name + "` needs an element for `" + one->name + "`");
    inner.own[one->name] = {.block = std::make_shared<const XmlNode>(std::move(*blocks[used++]))};
  }
  if (used < blocks.size())
    fail("the macro `" + macro.name + "` has no use for the element `" + blocks[used]->text + "`");

  for (const XacroParameter* one : open) {
    if (one->name.starts_with('*')) continue;
    std::optional<PythonValue> value;
    if (one->forward) value = evaluator_.find(one->name, scope.symbols);
    if (!value && one->otherwise) value = evaluator_.value(*one->otherwise, scope.symbols);
    if (!value)
      fail(one->forward ? "there is no property `" + one->name + "` to be forwarded"
                        : "the macro `" + macro.name + "` needs the parameter `" + one->name + "`");
    evaluator_.set(inner, one->name, std::move(*value), false);
  }
}

}  // namespace ros2wasm
