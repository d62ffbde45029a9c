// Texts of xacro's documents: `${expression}`, `$(substitution)`, and what the names in them stand
// for. Its functions throw XacroFault, and PythonFault for values that have no text.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bundler/launch/python/python_expression.hpp"
#include "bundler/launch/xacro/xacro.hpp"
#include "bundler/launch/xacro/xacro_symbols.hpp"

namespace ros2wasm {

class XacroEvaluator {
 public:
  XacroEvaluator(const XacroRequest& request, const LaunchWorld& world);

  /// A text that is one expression has its value, others are texts.
  PythonValue value(const std::string& written, XacroSymbols& symbols);
  std::string text(const std::string& written, XacroSymbols& symbols);
  /// `written`: for the message.
  static bool condition(const PythonValue& value, const std::string& written);

  /// Texts of numbers and booleans become those. `lazily`: a text is evaluated at first use.
  void set(XacroSymbols& table, const std::string& name, PythonValue value, bool lazily);
  /// The value of a property, of a global name too.
  std::optional<PythonValue> find(const std::string& name, XacroSymbols& symbols);

  /// Relative paths are relative to the file at work.
  [[nodiscard]] std::string absolute(const std::string& path) const;
  std::string read(const std::string& path);
  void spend(std::size_t steps);

  std::map<std::string, std::string> arguments;
  std::vector<std::string> files;  ///< the one at work is the last

 private:
  PythonValue expression(const std::string& written, XacroSymbols& symbols);
  PythonValue resolved(const std::string& name, XacroSymbol& symbol, XacroSymbols& table);
  std::optional<PythonValue> global(const std::string& name) const;
  void add_functions();
  PythonValue yaml(const std::string& path);

  // Substitutions, `$(...)`.
  std::string substituted(const std::string& call);
  std::string evaluated(const std::string& expression);
  std::optional<PythonValue> argument_value(const std::string& name) const;
  std::string package_share(const std::string& package) const;

  const XacroRequest& request_;
  const LaunchWorld& world_;
  PythonLimits limits_;
  std::map<std::string, PythonValue> globals_;
  std::map<std::string, PythonValue> yaml_files_;
  std::vector<std::pair<const XacroSymbols*, std::string>> resolving_;
};

/// "`FILE`" as messages name it.
[[nodiscard]] std::string xacro_shown(const std::string& path, const LaunchWorld& world);

}  // namespace ros2wasm
