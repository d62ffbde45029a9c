// See launch_scope.hpp. One row per substitution.
#include "bundler/launch/launch_scope.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "bundler/launch/launch_python.hpp"
#include "bundler/launch/launch_values.hpp"
#include "bundler/launch/node_arguments.hpp"
#include "bundler/launch/python/python_expression.hpp"
#include "bundler/launch/simulator_command.hpp"
#include "bundler/launch/xacro/xacro.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kXacro = "xacro";
constexpr std::size_t kLongestText = 4U << 20U;  // bytes
/// In the place of a description of which a file is not there yet.
constexpr const char* kLaterRobot = "<?xml version=\"1.0\" ?><robot name=\"later\"/>";

using Texts = std::vector<std::string>;

struct Call {
  const Texts& arguments;
  const SourceSpan& span;
  const LaunchScope& scope;
  const LaunchFilePlace& file;
  const LaunchWorld& world;
};
using Result = Outcome<std::string>;

Diagnostic fault(const Call& call, DiagnosticCode code, std::string message,
                 std::vector<std::string> why = {}) {
  return {.code = code, .message = std::move(message), .span = call.span, .why = std::move(why)};
}

/// The value of a name in `values`, or the default, the second argument.
Result looked_up(const Call& call, const std::map<std::string, std::string>& values,
                 const std::string& kind) {
  const std::string& name = call.arguments[0];
  if (const auto found = values.find(name); found != values.end()) return found->second;
  if (call.arguments.size() > 1) return call.arguments[1];
  Diagnostic error = fault(call, "R2W0412", "there is no " + kind + " `" + name + "` here");
  Texts names;
  for (const auto& [one, value] : values) names.push_back(one);
  error.why.push_back(names.empty() ? "none is set" : "set are: " + name_list(names));
  if (const auto similar = nearest(name, names)) error.why.push_back("there is `" + *similar + "`");
  return error;
}

Result variable(const Call& call) {
  return looked_up(call, call.scope.configurations, "launch configuration");
}

/// Whether it is set to that text; without one, whether it is not set.
Result variable_is(const Call& call) {
  const auto found = call.scope.configurations.find(call.arguments[0]);
  const bool is_set = found != call.scope.configurations.end();
  if (call.arguments.size() < 2) return std::string(is_set ? "false" : "true");
  return std::string(is_set && found->second == call.arguments[1] ? "true" : "false");
}

/// A substitution that a launch file in Python made itself.
Result python_object(const Call& call) {
  std::int64_t number = -1;
  const std::string& text = call.arguments[0];
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0)
    return fault(call, "R2W0411", "`$(python " + text + ")` names nothing");
  return perform_python(
      number, {.scope = call.scope, .file = call.file, .world = call.world, .span = call.span});
}

/// As Python's os.path.join has it: an absolute part leaves out what is before it.
Result joined_path(const Call& call) {
  std::string result;
  for (const std::string& part : call.arguments) {
    if (part.starts_with('/')) result.clear();
    if (!result.empty() && !result.ends_with('/')) result += '/';
    result += part;
  }
  return result;
}

std::map<std::string, std::string> environment_of(const Call& call) {
  std::map<std::string, std::string> all = call.scope.environment;
  all.insert(call.world.environment.begin(), call.world.environment.end());
  return all;
}

Result environment(const Call& call) {
  Result found = looked_up(call, environment_of(call), "environment variable");
  if (found) return found;
  Diagnostic error = found.errors().front();
  error.fix.push_back("in workspace.yaml: " + variable_in_manifest(call.arguments[0]));
  return error;
}

Result loop_value(const Call& call) {
  return looked_up(call, call.scope.loop, "value of the loop");
}

/// A value of an event, if a text can use it before the event happens.
Result event_value(const Call& call) {
  const std::string& name = call.arguments[0];
  if (const auto found = call.scope.event.find(name); found != call.scope.event.end())
    return found->second;
  return fault(call, "R2W0411",
               "`" + name + "` is known while a launch runs, not when a site is packed",
               {"`event.reason` can stand in what an OnShutdown handler says"});
}

Result parameter(const Call& call) {
  std::map<std::string, std::string> values;
  for (const LaunchParameter& one : call.scope.parameters) {
    if (one.file) continue;
    if (const auto* text = std::get_if<std::string>(&one.value)) values[one.name] = *text;
    if (const auto* whole = std::get_if<std::int64_t>(&one.value))
      values[one.name] = std::to_string(*whole);
    if (const auto* real = std::get_if<double>(&one.value))
      values[one.name] = parameter_text(*real);
    if (const auto* flag = std::get_if<bool>(&one.value))
      values[one.name] = *flag ? "True" : "False";
  }
  return looked_up(call, values, "parameter of `set_parameter`");
}

Result prefix(const Call& call, const std::string& package) {
  if (const auto found = call.world.prefix_of(package)) return *found;
  return fault(call, "R2W0413", "there is no package `" + package + "`",
               {"neither the workspace nor its channels' packages install it",
                "a package that is looked up is a dependency: its name belongs into package.xml, "
                "as `<exec_depend>" +
                    package + "</exec_depend>`"});
}

Result package_prefix(const Call& call) {
  return prefix(call, call.arguments[0]);
}

Result package_share(const Call& call) {
  auto found = prefix(call, call.arguments[0]);
  return found ? Result(*found + "/share/" + call.arguments[0]) : found;
}

Result executable_in(const Call& call) {
  // A command that begins with it is known without the program.
  if (call.arguments[0] == kXacro && call.arguments[1] == kXacro) return std::string(kXacro);
  auto found = prefix(call, call.arguments[1]);
  return found ? Result(*found + "/lib/" + call.arguments[1] + "/" + call.arguments[0]) : found;
}

/// The second argument names modules; those of `math` are there anyway.
Result evaluated(const Call& call) {
  if (call.arguments.size() > 1) {
    std::string modules = call.arguments[1];
    std::erase(modules, ' ');
    if (modules != "math")
      return fault(call, "R2W0411", "`$(eval)` has the module math only, not `" + modules + "`",
                   {"an expression with spaces must be in quotes: `$(eval '1 + 2')`"});
  }
  return evaluate_python(call.arguments[0], call.span);
}

Result directory(const Call& call) {
  return call.file.directory();
}
Result file_name(const Call& call) {
  return call.file.path;
}
Result log_directory(const Call&) {
  return std::string("/home/user/.ros/log");
}

/// The same for the same name, and never that of another; the same in every pack too.
Result anonymous(const Call& call) {
  return call.arguments[0] + "_site";
}

/// Whether a file that cannot be read may be there when the site is packed; then that is told.
bool comes_later(const Call& call, const std::string& path) {
  if (!call.world.is_later || !call.world.note_later || !call.world.is_later(path)) return false;
  call.world.note_later(path, call.span);
  return true;
}

Result content_of(const Call& call, const std::string& path) {
  auto text = call.world.read(path);
  if (text) return text;
  if (comes_later(call, path)) return std::string();
  return fault(call, "R2W0413", "`" + path + "` cannot be read", text.errors().front().why);
}

Result file_content(const Call& call) {
  return content_of(call, call.arguments[0]);
}

/// Nothing is run: the description is expanded here.
Result expanded(const Call& call, XacroRequest request) {
  request.environment = environment_of(call);
  std::string missing;  // the first file that cannot be read
  LaunchWorld world = call.world;
  world.read = [&](const std::string& path) {
    auto text = call.world.read(path);
    if (!text && missing.empty()) missing = path;
    return text;
  };
  auto text = expand_xacro(request, world);
  if (text) return text;
  if (!missing.empty() && comes_later(call, missing)) return std::string(kLaterRobot);
  Diagnostics errors = std::move(text).errors();
  if (!errors.front().span) {
    errors.front().span = call.span;
    return errors;
  }
  errors.front().why.push_back("asked for by `$(command ...)` at " + call.span.file + ":" +
                               std::to_string(call.span.line));
  return errors;
}

Result command(const Call& call) {
  const std::string& line = call.arguments[0];
  if (auto request = xacro_command(line, call.file.directory(), call.span)) {
    if (!*request) return request->errors();
    return expanded(call, std::move(**request));
  }
  if (const auto path = cat_command(line, call.file.directory())) return content_of(call, *path);
  return fault(
      call, "R2W0414", "`$(command ...)` is not run",
      {"the command is: " + line,
       "a pack runs nothing of a workspace but compilers; only `xacro` and `cat` are known "
       "to it"});
}

Result find_executable(const Call& call) {
  // ros2wasm handles these commands itself and runs no program, so the name is enough.
  for (const std::string_view known : {std::string_view("cat"), std::string_view("ros2"), kXacro})
    if (call.arguments[0] == known) return call.arguments[0];
  if (is_program_of_gazebo(call.arguments[0]) || call.arguments[0] == "ruby")
    return call.arguments[0];
  return fault(call, "R2W0414",
               "`$(find-exec " + call.arguments[0] +
                   ")` finds nothing: a site has no programs besides its nodes");
}

std::string as_text(bool value) {
  return value ? "true" : "false";
}

Result booleans(const Call& call, bool all) {
  bool result = all;
  for (const std::string& one : call.arguments) {
    const auto value = launch_boolean(one);
    if (!value) return fault(call, "R2W0411", "`" + one + "` is neither true nor false");
    result = all ? result && *value : result || *value;
  }
  return as_text(result);
}
Result conjunction(const Call& call) {
  return booleans(call, true);
}
Result disjunction(const Call& call) {
  return booleans(call, false);
}

Result negation(const Call& call) {
  const auto value = launch_boolean(call.arguments[0]);
  if (!value)
    return fault(call, "R2W0411", "`" + call.arguments[0] + "` is neither true nor false");
  return as_text(!*value);
}

std::optional<double> real(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

/// As booleans when both are, as numbers when both are, else as texts.
bool equal(const std::string& a, const std::string& b) {
  const auto flag_a = condition_of(a);
  const auto flag_b = condition_of(b);
  if (flag_a && flag_b) return *flag_a == *flag_b;
  const auto real_a = real(a);
  const auto real_b = real(b);
  if (real_a && real_b) {
    const double larger = std::max(std::fabs(*real_a), std::fabs(*real_b));
    return *real_a == *real_b || std::fabs(*real_a - *real_b) <= 1e-9 * larger;
  }
  return a == b;
}
Result equals(const Call& call) {
  return as_text(equal(call.arguments[0], call.arguments[1]));
}
Result differs(const Call& call) {
  return as_text(!equal(call.arguments[0], call.arguments[1]));
}

Result chosen(const Call& call) {
  const auto value = launch_boolean(call.arguments[0]);
  if (!value)
    return fault(call, "R2W0411", "`" + call.arguments[0] + "` is neither true nor false");
  if (*value) return call.arguments[1];
  return call.arguments.size() > 2 ? call.arguments[2] : std::string();
}

Result joined(const Call& call) {
  std::string result;
  for (std::size_t i = 1; i < call.arguments.size(); ++i)
    result += (i > 1 ? call.arguments[0] : "") + call.arguments[i];
  return result;
}

Result stripped(const Call& call) {
  return std::string(trimmed(call.arguments[0]));
}

struct Row {
  std::string_view name;
  std::size_t least;
  std::size_t most;
  Result (*evaluate)(const Call& call);
  bool of_python = false;  ///< what launch files in Python are written down with
};

constexpr std::size_t kMany = 1000;
constexpr Row kRows[] = {
    {"all", 1, kMany, conjunction},
    {"and", 2, 2, conjunction},
    {"anon", 1, 1, anonymous},
    {"any", 1, kMany, disjunction},
    {"command", 1, 2, command},
    {"dirname", 0, 0, directory},
    {"env", 1, 2, environment},
    {"equals", 2, 2, equals},
    {"eval", 1, 2, evaluated},
    {"exec-in-pkg", 2, 2, executable_in},
    {"exec-in-package", 2, 2, executable_in},
    {"file-content", 1, 1, file_content},
    {"filename", 0, 0, file_name},
    {"find-exec", 1, 1, find_executable},
    {"find-pkg-prefix", 1, 1, package_prefix},
    {"find-pkg-share", 1, 1, package_share},
    {"for-var", 1, 2, loop_value},
    {"if", 2, 3, chosen},
    {"index", 1, 2, loop_value},
    {"launch_log_dir", 0, 0, log_directory},
    {"local", 1, 1, event_value, true},
    {"log_dir", 0, 0, log_directory},
    {"not", 1, 1, negation},
    {"not-equals", 2, 2, differs},
    {"or", 2, 2, disjunction},
    {"param", 1, 2, parameter},
    {"path-join", 1, kMany, joined_path},
    {"python", 1, 1, python_object, true},
    {"string-join", 1, kMany, joined},
    {"string-strip", 1, 1, stripped},
    {"var", 1, 2, variable},
    {"var-is", 1, 2, variable_is, true},
};

Result evaluate_call(const LaunchCall& called, const SourceSpan& span, const LaunchScope& scope,
                     const LaunchFilePlace& file, const LaunchWorld& world) {
  Texts arguments;
  for (const LaunchText& argument : called.arguments) {
    auto text = evaluate_text(argument, span, scope, file, world);
    if (!text) return text;
    arguments.push_back(std::move(*text));
  }
  const Call call{arguments, span, scope, file, world};
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows),
                                 [&](const Row& one) { return one.name == called.name; });
  if (row == std::end(kRows)) {
    Texts names;
    for (const Row& one : kRows)
      if (!one.of_python) names.emplace_back(one.name);
    Diagnostic error = fault(call, "R2W0411", "there is no substitution `$(" + called.name + ")`",
                             {"there are: " + name_list(names, names.size())});
    if (const auto similar = nearest(called.name, names))
      error.why.push_back("did you mean `" + *similar + "`?");
    return error;
  }
  if (arguments.size() < row->least || arguments.size() > row->most) {
    return fault(call, "R2W0411",
                 "`$(" + called.name + ")` takes " + std::to_string(row->least) +
                     (row->most == row->least ? ""
                      : row->most == kMany    ? " or more"
                                              : " to " + std::to_string(row->most)) +
                     " arguments, found " + std::to_string(arguments.size()),
                 called.name == "eval" ? Texts{"an expression with spaces must be in quotes: "
                                               "`$(eval '1 + 2')`"}
                                       : Texts());
  }
  return row->evaluate(call);
}

}  // namespace

std::string variable_in_manifest(const std::string& name) {
  return "`launch: {file: ..., environment: {" + name + ": ...}}`";
}

Outcome<std::string> evaluate_text(const LaunchText& text, const SourceSpan& span,
                                   const LaunchScope& scope, const LaunchFilePlace& file,
                                   const LaunchWorld& world) {
  std::string result;
  for (const LaunchPiece& piece : text) {
    if (const auto* plain = std::get_if<std::string>(&piece)) {
      result += *plain;
      continue;
    }
    auto part = evaluate_call(std::get<LaunchCall>(piece), span, scope, file, world);
    if (!part) return part;
    result += *part;
    if (result.size() > kLongestText)
      return Diagnostic{
          .code = "R2W0411", .message = "a text comes to more than 4 MiB", .span = span};
  }
  return result;
}

std::optional<bool> condition_of(std::string_view text) {
  const std::string word = ascii_lower(trimmed(text));
  if (word == "true" || word == "1") return true;
  if (word == "false" || word == "0") return false;
  return std::nullopt;
}

}  // namespace ros2wasm
