// See xacro_evaluator.hpp: the names that expressions have without a definition, in the document.
#include <string_view>

#include "bundler/launch/python/python_function_table.hpp"
#include "bundler/launch/python/python_functions.hpp"
#include "bundler/launch/xacro/xacro_evaluator.hpp"
#include "bundler/launch/xacro/xacro_yaml.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

/// Those of Python that stand for themselves; all others are `python.name`.
constexpr std::string_view kPlainBuiltins[] = {"list",  "dict",  "map",    "len",   "str",
                                               "float", "int",   "True",   "False", "min",
                                               "max",   "round", "sorted", "range"};
/// Those of xacro that stand without `xacro.` too.
constexpr std::string_view kPlainFunctions[] = {"load_yaml", "abs_filename", "dotify"};

PythonValue space(const std::string& name,
                  std::function<std::optional<PythonValue>(const std::string&)> attribute) {
  return {std::make_shared<const PythonNamespace>(PythonNamespace{name, std::move(attribute)})};
}

const std::string& text_of(const PythonValue& value) {
  const auto* text = std::get_if<std::string>(&value.held);
  if (text == nullptr)
    throw PythonFault{"TypeError: a str is needed, not " + std::string(python_type(value))};
  return *text;
}

PythonValue tokenized(const PythonArguments& a) {
  const auto given = [&](std::size_t at, const char* name) {
    return at < a.values.size() ? &a.values[at] : python_named(a, name);
  };
  const PythonValue* marks = given(1, "sep");
  const PythonValue* skip = given(2, "skip_empty");
  const std::string separators = marks != nullptr ? text_of(*marks) : ",; ";
  const bool skip_empty = skip == nullptr || truth(*skip);
  PythonList result;
  std::string word;
  for (const char c : text_of(a.values[0]) + separators.substr(0, 1)) {
    if (separators.find(c) == std::string::npos) {
      word += c;
    } else {
      if (!skip_empty || !word.empty()) result.push_back({word});
      word.clear();
    }
  }
  return {std::move(result)};
}

std::string joined(const PythonArguments& a) {
  std::string result;
  for (const PythonValue& one : a.values) result += (result.empty() ? "" : " ") + python_text(one);
  return result;
}

}  // namespace

void XacroEvaluator::add_functions() {
  PythonTable table;
  constexpr std::size_t many = 1000;
  const auto silent = [](const PythonArguments&) { return PythonValue{std::string()}; };
  for (const char* name : {"error", "message", "print_location", "warning"})
    add_python_function(table, name, 0, many, silent, "*");
  add_python_function(table, "abs_filename", 1, 1, [this](const PythonArguments& a) {
    return PythonValue{absolute(text_of(a.values[0]))};
  });
  add_python_function(table, "arg", 1, 1, [this](const PythonArguments& a) {
    const auto found = arguments.find(text_of(a.values[0]));
    if (found == arguments.end())
      throw PythonFault{"KeyError: there is no argument " + python_text(a.values[0], true)};
    return PythonValue{found->second};
  });
  add_python_function(table, "dotify", 1, 1,
                      [](const PythonArguments& a) { return python_dotted(a.values[0]); });
  add_python_function(table, "fatal", 0, many, [](const PythonArguments& a) -> PythonValue {
    throw PythonFault{joined(a)};
  });
  add_python_function(table, "load_yaml", 1, 1, [this](const PythonArguments& a) {
    return yaml(absolute(text_of(a.values[0])));
  });
  add_python_function(table, "tokenize", 1, 3, tokenized, "sep skip_empty");

  globals_["math"] = space("math", python_math);
  globals_["python"] = space("python", python_builtin);
  globals_["xacro"] =
      space("xacro", [table](const std::string& name) { return python_function(table, name); });
  for (const std::string_view name : kPlainBuiltins)
    globals_[std::string(name)] = *python_builtin(std::string(name));
  for (const std::string_view name : kPlainFunctions)
    globals_[std::string(name)] = *python_function(table, std::string(name));
  globals_["None"] = {PythonNone{}};
}

std::optional<PythonValue> XacroEvaluator::global(const std::string& name) const {
  const auto found = globals_.find(name);
  return found != globals_.end() ? std::optional(found->second) : python_math(name);
}

PythonValue XacroEvaluator::yaml(const std::string& path) {
  const auto known = yaml_files_.find(path);
  if (known != yaml_files_.end()) return known->second;
  const std::string text = read(path);
  auto value = read_xacro_yaml(text, xacro_shown(path, world_), [this](const std::string& one) {
    const auto name = [this](const std::string& global_name) { return global(global_name); };
    return python_evaluated(one, {.name = name, .limits = &limits_});
  });
  if (!value) throw XacroFault{.ready = value.errors()};
  return yaml_files_.emplace(path, std::move(*value)).first->second;
}

}  // namespace ros2wasm
