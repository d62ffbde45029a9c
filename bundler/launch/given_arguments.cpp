// See given_arguments.hpp.
#include "bundler/launch/given_arguments.hpp"

#include <algorithm>

#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {

std::map<std::string, std::string> values_by_name(const std::vector<GivenArgument>& given) {
  std::map<std::string, std::string> result;
  for (const GivenArgument& one : given) result[one.name.value] = one.value;
  return result;
}

std::map<std::string, SourceSpan> places_by_name(const std::vector<GivenArgument>& given) {
  std::map<std::string, SourceSpan> result;
  for (const GivenArgument& one : given)
    if (!one.name.span.file.empty()) result[one.name.value] = one.name.span;
  return result;
}

Diagnostics undeclared_arguments(
    const std::vector<GivenArgument>& given, const std::vector<LaunchArgument>& declared,
    const std::function<std::string(const std::string& name, const std::string& value)>& written) {
  std::vector<std::string> names;
  for (const LaunchArgument& one : declared) {
    if (std::find(names.begin(), names.end(), one.name) == names.end()) names.push_back(one.name);
  }
  Diagnostics errors;
  for (const GivenArgument& one : given) {
    if (std::find(names.begin(), names.end(), one.name.value) != names.end()) continue;
    Diagnostic error{
        .code = "R2W0730",
        .message = "the launch file has no argument `" + one.name.value + "`",
        .why = {names.empty() ? "it declares none" : "its arguments are: " + name_list(names)}};
    if (!one.name.span.file.empty()) error.span = one.name.span;
    if (const auto similar = nearest(one.name.value, names))
      error.fix.push_back(written(*similar, one.value));
    errors.push_back(std::move(error));
  }
  return errors;
}

Diagnostics undeclared_in_manifest(const std::vector<GivenArgument>& given,
                                   const std::vector<LaunchArgument>& declared) {
  const auto written = [](const std::string& name, const std::string& /*value*/) {
    return "write `" + as_yaml_text(name) + "`";
  };
  return undeclared_arguments(given, declared, written);
}

}  // namespace ros2wasm
