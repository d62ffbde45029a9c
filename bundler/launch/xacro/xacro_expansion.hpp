// Walks a document of xacro and builds the one that it comes to. Its functions throw XacroFault;
// place() says where they were then.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/xacro/xacro_evaluator.hpp"
#include "bundler/launch/xacro/xacro_symbols.hpp"
#include "workspace_schema/base/xml_reader.hpp"

namespace ros2wasm {

class XacroExpansion {
 public:
  XacroExpansion(const XacroRequest& request, const LaunchWorld& world);

  /// The document's element, expanded.
  XmlNode document(const std::string& path);

  /// The element at work, and the calls and includes that lead to it, the innermost first.
  [[nodiscard]] std::optional<SourceSpan> place() const;
  [[nodiscard]] std::vector<std::string> trail() const;

 private:
  struct Scope {
    XacroSymbols& symbols;
    XacroMacros& macros;
  };
  struct File {
    std::string shown;
    std::string text;
  };
  /// By value: the document at fault may be gone when it is asked for.
  struct Place {
    std::uint32_t file = kNoFile;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::size_t size = 0;
  };
  struct Trail {
    std::string what;
    Place at;
  };
  static constexpr std::uint32_t kNoFile = 0xFFFFFFFF;

  // xacro_expansion.cpp: the walk.
  XmlNode parsed(const std::string& path);
  void content(const XmlNode& from, Scope scope, XmlNode& into);
  void element(const XmlNode& from, Scope scope, XmlNode& into);
  XmlNode expanded(const XmlNode& from, Scope scope);
  void attributes(const XmlNode& from, Scope scope, XmlNode& into);
  void text(const XmlNode& from, Scope scope, XmlNode& into, bool& in_comments);
  void add(XmlNode node, XmlNode& into);
  const std::string& needed(const XmlNode& from, const char* name) const;
  int drop_comments(XmlNode& into);
  void end_comments(int mark, XmlNode& into);

  // xacro_elements.cpp: one function per element of xacro.
  void include(const XmlNode& from, Scope scope, XmlNode& into);
  void included(const std::string& path, Scope scope, XmlNode& into);
  void property(const XmlNode& from, Scope scope, XmlNode& into);
  void argument(const XmlNode& from, Scope scope, XmlNode& into);
  void named_element(const XmlNode& from, Scope scope, XmlNode& into);
  void attribute(const XmlNode& from, Scope scope, XmlNode& into);
  void condition(const XmlNode& from, Scope scope, XmlNode& into);
  void insert_block(const XmlNode& from, Scope scope, XmlNode& into);

  // xacro_macro_call.cpp
  void macro(const XmlNode& from, Scope scope, XmlNode& into);
  void dynamic_call(const XmlNode& from, Scope scope, XmlNode& into);
  void call(const XmlNode& from, Scope scope, XmlNode& into);
  void call_of(const std::string& name, const XmlNode& from, Scope scope, XmlNode& into);
  void arguments_of(const XmlNode& from, const XacroMacro& macro, Scope scope, XacroSymbols& inner);

  struct Row;
  static const Row* row_of(const std::string& name);

  const LaunchWorld& world_;
  XacroEvaluator evaluator_;
  std::vector<File> files_;
  std::vector<Trail> trail_;
  Place at_;
  int depth_ = 0;
  int last_mark_ = 0;
  std::size_t output_left_;
};

}  // namespace ros2wasm
