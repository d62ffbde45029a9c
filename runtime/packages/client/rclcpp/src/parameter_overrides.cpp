// Overrides out of parameter files and -p rules.
#include "rclcpp/detail/parameter_overrides.hpp"

#include <cstdio>
#include <stdexcept>
#include <type_traits>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter_map.hpp"
#include "ros2wasm/arguments.hpp"
#include "ros2wasm/yaml.hpp"

namespace rclcpp {
namespace detail {
namespace {

using Overrides = std::map<std::string, rclcpp::ParameterValue>;
using ros2wasm::YamlNode;

[[noreturn]] void fail(const std::string& what) {
  rcutils_set_error_state(what.c_str(), __FILE__, __LINE__);
  exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to read parameter overrides");
}

rclcpp::ParameterValue to_value(const YamlNode& node) {
  return std::visit(
      [](auto&& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
          return rclcpp::ParameterValue();
        } else {
          return rclcpp::ParameterValue(value);
        }
      },
      ros2wasm::to_parameter(node));
}

// Whether a node name of a rule or file, in which "*" stands for one token and "**" for any
// number of them, means this node.
bool matches(const std::string& pattern, const std::string& name) {
  if (pattern.empty()) {
    return name.empty();
  }
  if (pattern.compare(0, 3, "/**") == 0) {
    const std::string rest = pattern.substr(3);
    for (size_t at = 0; at != std::string::npos; at = name.find('/', at + 1)) {
      if (matches(rest, name.substr(at))) {
        return true;
      }
    }
    return matches(rest, "");
  }
  if (name.empty() || pattern[0] != '/' || name[0] != '/') {
    return false;
  }
  const size_t pattern_end = pattern.find('/', 1);
  const size_t name_end = name.find('/', 1);
  const std::string token = pattern.substr(1, pattern_end - 1);
  if (token != "*" && token != name.substr(1, name_end - 1)) {
    return false;
  }
  return matches(pattern_end == std::string::npos ? "" : pattern.substr(pattern_end),
                 name_end == std::string::npos ? "" : name.substr(name_end));
}

std::string absolute(const std::string& pattern) {
  return pattern.empty() || pattern[0] == '/' ? pattern : "/" + pattern;
}

void add_tree(const std::string& prefix, const YamlNode& node, Overrides& out) {
  for (const auto& [key, child] : node.entries) {
    const std::string name = prefix.empty() ? key : prefix + "." + key;
    if (child.kind == YamlNode::Kind::map) {
      add_tree(name, child, out);
    } else {
      out[name] = to_value(child);
    }
  }
}

// Calls `found` with each node name and its parameters. Namespaces may be nested as maps; the key
// ros__parameters ends them.
template <typename FoundT>
void visit_document(const std::string& path, const YamlNode& node, const FoundT& found) {
  for (const auto& [key, child] : node.entries) {
    if (key == "ros__parameters") {
      found(path, child);
    } else if (child.kind == YamlNode::Kind::map) {
      visit_document(path + absolute(key), child, found);
    } else {
      throw std::runtime_error("value '" + key + "' stands outside of ros__parameters");
    }
  }
}

std::string read_file(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    throw std::runtime_error("cannot open it");
  }
  std::string text;
  char buffer[4096];
  size_t count = 0;
  while ((count = std::fread(buffer, 1, sizeof(buffer), file)) > 0) {
    text.append(buffer, count);
  }
  std::fclose(file);
  return text;
}

// The values given for one of the names that match a node; later rules for that name are added.
struct Named {
  std::string node;
  Overrides values;
};

Overrides& values_of(const std::string& node, std::vector<Named>& all) {
  for (Named& one : all) {
    if (one.node == node) {
      return one.values;
    }
  }
  all.push_back({node, {}});
  return all.back().values;
}

// rcl keeps node names in the order in which they appear first, in files as in rules, and rclcpp
// goes through them in that order: of two that match the node, the one that appeared last wins.
void add_arguments(const ros2wasm::Arguments& arguments, const std::string& full_name,
                   const std::string& name, Overrides& out) {
  std::vector<Named> all;
  for (const ros2wasm::ParameterSource& source : arguments.parameters) {
    try {
      if (source.is_file) {
        visit_document("", ros2wasm::parse_yaml(read_file(source.file)),
                       [&](const std::string& node, const YamlNode& parameters) {
                         if (matches(node, full_name)) {
                           add_tree("", parameters, values_of(node, all));
                         }
                       });
      } else {
        const std::string& said = source.rule.node;
        const std::string node = said.empty() ? "/**" : said == name ? full_name : absolute(said);
        if (matches(node, full_name)) {
          values_of(node, all)[source.rule.name] =
              to_value(ros2wasm::parse_yaml(source.rule.value));
        }
      }
    } catch (const std::runtime_error& error) {
      fail((source.is_file ? "parameter file '" + source.file : "parameter '" + source.rule.name) +
           "': " + error.what());
    }
  }
  for (const Named& one : all) {
    for (const auto& [parameter, value] : one.values) {
      out[parameter] = value;
    }
  }
}

}  // namespace

Overrides resolve_parameter_overrides(const node_interfaces::NodeBaseInterface& node,
                                      const std::vector<rclcpp::Parameter>& option_overrides) {
  Overrides overrides;
  for (const ros2wasm::Arguments* arguments :
       {node.get_global_arguments(), node.get_local_arguments()}) {
    if (arguments != nullptr) {
      add_arguments(*arguments, node.get_fully_qualified_name(), node.get_name(), overrides);
    }
  }
  for (const rclcpp::Parameter& parameter : option_overrides) {
    overrides[parameter.get_name()] = parameter.get_parameter_value();
  }
  return overrides;
}

}  // namespace detail

ParameterMap parameter_map_from_yaml_file(const std::string& yaml_filename, const char* node_fqn) {
  ParameterMap map;
  try {
    detail::visit_document("", ros2wasm::parse_yaml(detail::read_file(yaml_filename)),
                           [&](const std::string& node, const ros2wasm::YamlNode& tree) {
                             if (node_fqn != nullptr && !detail::matches(node, node_fqn)) {
                               return;
                             }
                             detail::Overrides values;
                             detail::add_tree("", tree, values);
                             for (const auto& [name, value] : values) {
                               map[node_fqn == nullptr ? node : node_fqn].emplace_back(name, value);
                             }
                           });
  } catch (const std::runtime_error& error) {
    detail::fail("parameter file '" + yaml_filename + "': " + error.what());
  }
  return map;
}

std::vector<Parameter> parameters_from_map(const ParameterMap& parameter_map,
                                           const char* node_fqn) {
  std::vector<Parameter> parameters;
  for (const auto& [node, values] : parameter_map) {
    if (node_fqn == nullptr || detail::matches(node, node_fqn)) {
      parameters.insert(parameters.end(), values.begin(), values.end());
    }
  }
  return parameters;
}

}  // namespace rclcpp
