// See xacro_evaluator.hpp: `$(name arguments)`, which are fewer than those of launch files.
#include <algorithm>
#include <cctype>
#include <utility>

#include "bundler/launch/python/python_function_table.hpp"
#include "bundler/launch/python/python_functions.hpp"
#include "bundler/launch/xacro/xacro_evaluator.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

using Texts = std::vector<std::string>;

[[noreturn]] void fail(std::string message, std::vector<std::string> why = {}) {
  throw XacroFault{.message = std::move(message), .why = std::move(why)};
}

Texts words_of(const std::string& text) {
  Texts result;
  std::string word;
  for (const char c : text + " ") {
    if (c != ' ') {
      word += c;
    } else if (!word.empty()) {
      result.push_back(std::exchange(word, {}));
    }
  }
  return result;
}

std::string joined(const Texts& words, std::size_t from) {
  std::string result;
  for (std::size_t i = from; i < words.size(); ++i) result += (i > from ? " " : "") + words[i];
  return result;
}

void need(const Texts& words, std::size_t count) {
  if (words.size() != count)
    fail("`$(" + joined(words, 0) + ")` takes " + std::to_string(count - 1) + " argument" +
         (count == 2 ? "" : "s"));
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.rfind('/'));
}

/// The value of a name, or a fault that names those that are set.
const std::string& value_among(const std::map<std::string, std::string>& values,
                               const std::string& name, const std::string& kind) {
  const auto found = values.find(name);
  if (found != values.end()) return found->second;
  Texts names;
  for (const auto& [one, value] : values) names.push_back(one);
  std::vector<std::string> why{names.empty() ? "none is set" : "set are: " + name_list(names)};
  if (const auto similar = nearest(name, names)) why.push_back("there is `" + *similar + "`");
  fail("there is no " + kind + " `" + name + "`", std::move(why));
}

/// An argument in `$(eval ...)`: a number or boolean where its text is one.
PythonValue typed(const std::string& text) {
  try {
    return text.find('.') != std::string::npos ? python_to_float({text})
                                               : python_to_integer({text});
  } catch (const PythonFault&) {
    std::string word = text;
    std::transform(word.begin(), word.end(), word.begin(), ::tolower);
    if (word == "true") return {true};
    if (word == "false") return {false};
    return {text};
  }
}

}  // namespace

std::string XacroEvaluator::package_share(const std::string& package) const {
  const auto prefix = world_.prefix_of(package);
  if (!prefix)
    fail("there is no package `" + package + "`",
         {"neither the workspace nor its channels' packages install it",
          "a package that is looked up is a dependency: its name belongs into package.xml, as "
          "`<exec_depend>" +
              package + "</exec_depend>`"});
  return *prefix + "/share/" + package;
}

std::string XacroEvaluator::substituted(const std::string& call) {
  if (call == "cwd") return request_.directory;
  if (call.starts_with("eval ")) return evaluated(call.substr(5));
  const Texts words = words_of(call);
  if (words.empty()) fail("`$()` names no substitution");
  if (words[0] == "find") {
    need(words, 2);
    return package_share(words[1]);
  }
  if (words[0] == "env") {
    need(words, 2);
    return value_among(request_.environment, words[1], "environment variable");
  }
  if (words[0] == "dirname") {
    need(words, 1);
    return folder_of(files.back());
  }
  if (words[0] == "optenv") {
    if (words.size() < 2) fail("`$(optenv)` takes the name of an environment variable");
    const auto found = request_.environment.find(words[1]);
    return found != request_.environment.end() ? found->second : joined(words, 2);
  }
  if (words[0] != "arg")
    fail("there is no substitution `$(" + call + ")`",
         {"there are: arg, cwd, dirname, env, eval, find, optenv"});
  need(words, 2);
  std::string text = value_among(arguments, words[1], "argument");
  // A value may look for packages itself.
  for (std::size_t at = text.find("$(find "); at != std::string::npos; at = text.find("$(find ")) {
    const std::size_t end = text.find(')', at);
    if (end == std::string::npos) break;
    const Texts inner = words_of(text.substr(at + 2, end - at - 2));
    need(inner, 2);
    text.replace(at, end + 1 - at, package_share(inner[1]));
  }
  return text;
}

std::optional<PythonValue> XacroEvaluator::argument_value(const std::string& name) const {
  const auto found = arguments.find(name);
  return found != arguments.end() ? std::optional(typed(found->second)) : std::nullopt;
}

std::string XacroEvaluator::evaluated(const std::string& expression) {
  PythonTable table;
  const auto text_at = [](const PythonArguments& a, std::size_t at) {
    return at < a.values.size() ? python_text(a.values[at]) : std::string();
  };
  add_python_function(table, "arg", 1, 1, [&](const PythonArguments& a) {
    return typed(value_among(arguments, text_at(a, 0), "argument"));
  });
  add_python_function(table, "dirname", 0, 0,
                      [&](const PythonArguments&) { return PythonValue{folder_of(files.back())}; });
  add_python_function(table, "env", 1, 1, [&](const PythonArguments& a) {
    return PythonValue{value_among(request_.environment, text_at(a, 0), "environment variable")};
  });
  add_python_function(table, "find", 1, 1, [&](const PythonArguments& a) {
    return PythonValue{package_share(text_at(a, 0))};
  });
  add_python_function(table, "optenv", 1, 2, [&](const PythonArguments& a) {
    const auto found = request_.environment.find(text_at(a, 0));
    return PythonValue{found != request_.environment.end() ? found->second : text_at(a, 1)};
  });
  const auto name = [&](const std::string& one) -> std::optional<PythonValue> {
    if (one == "true" || one == "false") return PythonValue{one == "true"};
    if (auto function = python_function(table, one)) return function;
    if (auto number = python_math(one)) return number;
    if (auto argument = argument_value(one)) return argument;
    return python_builtin(one);
  };
  try {
    return python_text(python_evaluated(expression, {.name = name, .limits = &limits_}));
  } catch (const PythonFault& fault) {
    fail(fault.message, {"the expression is: " + expression.substr(0, 200)});
  }
}

}  // namespace ros2wasm
