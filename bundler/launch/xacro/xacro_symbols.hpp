// Definitions in xacro's documents: properties and macros, in tables that see the tables around
// them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/python/python_value.hpp"
#include "workspace_schema/base/xml_reader.hpp"

namespace ros2wasm {

/// Ends an expansion. What was at work then is still on the stacks of who catches it.
struct XacroFault {
  std::string message;
  std::vector<std::string> why;
  Diagnostics ready;     ///< instead, when the fault is one of another step
  bool no_file = false;  ///< a file that cannot be read
};

struct XacroSymbols;

/// One of three: a value, parts of a document, a namespace.
struct XacroSymbol {
  PythonValue value{PythonNone{}};
  bool unevaluated = false;  ///< the value is a text that is evaluated when it is first asked for
  std::shared_ptr<const XmlNode> block;  ///< names begin with `*` (one element) or `**` (contents)
  std::shared_ptr<XacroSymbols> space;
};

/// `parent` outlives it; behind the last one are the global names.
struct XacroSymbols {
  XacroSymbols* parent = nullptr;
  bool is_namespace = false;
  std::map<std::string, XacroSymbol> own = {};

  /// Its own or one around it, or nullptr.
  [[nodiscard]] XacroSymbol* find(const std::string& name);
};

/// `params="name name:=default name:=^ name:=^|default *block **blocks"`.
struct XacroParameter {
  std::string name;      ///< with its `*`
  bool forward = false;  ///< `^`: the caller's property of that name
  std::optional<std::string> otherwise;
};

struct XacroMacro {
  std::string name;
  XmlNode body;
  std::vector<XacroParameter> parameters;
};

struct XacroMacros {
  const XacroMacros* parent = nullptr;
  std::map<std::string, std::shared_ptr<const XacroMacro>> own = {};
  std::map<std::string, std::shared_ptr<XacroMacros>> spaces = {};

  [[nodiscard]] std::shared_ptr<const XacroMacro> find(const std::string& name) const;
  [[nodiscard]] std::shared_ptr<XacroMacros> space(const std::string& name) const;
};

/// Throws XacroFault.
[[nodiscard]] std::vector<XacroParameter> xacro_parameters(const std::string& written);

}  // namespace ros2wasm
