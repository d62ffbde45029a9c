// Reading ROS arguments and applying remap rules.
#include "ros2wasm/arguments.hpp"

#include <cctype>
#include <stdexcept>

#include "ros2wasm/names.hpp"

namespace ros2wasm {
namespace {

struct Split {
  std::string left;
  std::string right;
};

Split split_rule(const std::string& flag, const std::string& rule, const char* what) {
  const size_t at = rule.find(":=");
  if (at == std::string::npos || at == 0) {
    throw std::invalid_argument(std::string("Couldn't parse ") + what + ": '" + flag + " " + rule +
                                "'. Error: expected 'name:=value'");
  }
  return {rule.substr(0, at), rule.substr(at + 2)};
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

// Takes "node:" off the front, unless it is the colon of an URL scheme.
std::string take_node_prefix(std::string& from) {
  const size_t colon = from.find(':');
  if (colon == std::string::npos || starts_with(from, "rostopic://") ||
      starts_with(from, "rosservice://")) {
    return {};
  }
  std::string node = from.substr(0, colon);
  from.erase(0, colon + 1);
  return node;
}

[[noreturn]] void refuse_remap(const std::string& flag, const std::string& rule,
                               const std::string& why) {
  throw std::invalid_argument("Couldn't parse remap rule: '" + flag + " " + rule +
                              "'. Error: " + why);
}

RemapRule parse_remap(const std::string& flag, const std::string& rule) {
  Split split = split_rule(flag, rule, "remap rule");
  RemapRule result{RemapKind::topic_and_service, take_node_prefix(split.left), split.left,
                   split.right};
  if (result.from == "__node" || result.from == "__name") {
    result.kind = RemapKind::node_name;
    if (const auto problem = check_node_name(result.to)) {
      refuse_remap(flag, rule, problem->message);
    }
    return result;
  }
  if (result.from == "__ns") {
    result.kind = RemapKind::node_namespace;
    if (const auto problem = check_namespace(result.to)) {
      refuse_remap(flag, rule, problem->message);
    }
    return result;
  }
  if (starts_with(result.from, "rostopic://")) {
    result.kind = RemapKind::topic;
    result.from.erase(0, std::string_view("rostopic://").size());
  } else if (starts_with(result.from, "rosservice://")) {
    result.kind = RemapKind::service;
    result.from.erase(0, std::string_view("rosservice://").size());
  }
  if (const auto problem = check_topic_name(result.from)) {
    refuse_remap(flag, rule, problem->message);
  }
  if (const auto problem = check_topic_name(result.to)) {
    refuse_remap(flag, rule, problem->message);
  }
  return result;
}

ParameterRule parse_parameter(const std::string& flag, const std::string& rule) {
  Split split = split_rule(flag, rule, "parameter override rule");
  ParameterRule result{{}, split.left, split.right};
  const size_t colon = split.left.find(':');
  if (colon != std::string::npos) {
    result.node = split.left.substr(0, colon);
    result.name = split.left.substr(colon + 1);
  }
  // No name has a colon, so a second one is a mistake, as is nothing on either side of the first.
  const bool empty = result.name.empty() || colon == 0;
  if (empty || result.name.find(':') != std::string::npos) {
    throw std::invalid_argument("Couldn't parse parameter override rule: '" + flag + " " + rule +
                                "'. Error: expected 'node:name:=value' or 'name:=value'");
  }
  return result;
}

int severity_from(const std::string& flag, const std::string& text) {
  std::string upper = text;
  for (char& c : upper) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  constexpr std::pair<const char*, int> kLevels[] = {{"UNSET", 0}, {"DEBUG", 10}, {"INFO", 20},
                                                     {"WARN", 30}, {"ERROR", 40}, {"FATAL", 50}};
  for (const auto& [name, level] : kLevels) {
    if (upper == name) {
      return level;
    }
  }
  throw std::invalid_argument("Couldn't parse log level: '" + flag + " " + text +
                              "'. Error: Argument does not use a valid severity level");
}

std::pair<std::string, int> parse_log_level(const std::string& flag, const std::string& text) {
  const size_t at = text.find(":=");
  if (at == std::string::npos) {
    return {std::string(), severity_from(flag, text)};
  }
  return {text.substr(0, at), severity_from(flag, text.substr(at + 2))};
}

// "--enable-X" or "--disable-X" sets `value`.
bool parse_switch(const std::string& argument, const std::string& name, bool* value) {
  if (argument == "--enable-" + name) {
    *value = true;
    return true;
  }
  if (argument == "--disable-" + name) {
    *value = false;
    return true;
  }
  return false;
}

const RemapRule* find_rule(const Arguments* arguments, bool (*fits)(const RemapRule&, const void*),
                           const void* wanted) {
  if (arguments != nullptr) {
    for (const RemapRule& rule : arguments->remaps) {
      if (fits(rule, wanted)) {
        return &rule;
      }
    }
  }
  return nullptr;
}

struct WantedName {
  const std::string& full_name;
  bool is_service;
  const std::string& node;
  const std::string& ns;
};

bool fits_name(const RemapRule& rule, const void* pointer) {
  const auto& wanted = *static_cast<const WantedName*>(pointer);
  const bool right_kind = rule.kind == RemapKind::topic_and_service ||
                          rule.kind == (wanted.is_service ? RemapKind::service : RemapKind::topic);
  return right_kind && (rule.node.empty() || rule.node == wanted.node) &&
         expand_topic_name(rule.from, wanted.node, wanted.ns) == wanted.full_name;
}

bool fits_node_name(const RemapRule& rule, const void* pointer) {
  return rule.kind == RemapKind::node_name &&
         (rule.node.empty() || rule.node == *static_cast<const std::string*>(pointer));
}

bool fits_namespace(const RemapRule& rule, const void* pointer) {
  return rule.kind == RemapKind::node_namespace &&
         (rule.node.empty() || rule.node == *static_cast<const std::string*>(pointer));
}

const RemapRule* find_rule(const Arguments* local, const Arguments* global,
                           bool (*fits)(const RemapRule&, const void*), const void* wanted) {
  const RemapRule* rule = find_rule(local, fits, wanted);
  return rule != nullptr ? rule : find_rule(global, fits, wanted);
}

}  // namespace

Arguments parse_arguments(const std::vector<std::string>& arguments) {
  Arguments result;
  bool in_ros = false;
  bool external_logs = true;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (!in_ros) {
      if (argument == "--ros-args") {
        in_ros = true;
      } else {
        result.other_arguments.push_back(argument);
      }
      continue;
    }
    if (argument == "--ros-args") {
      continue;
    }
    if (argument == "--") {
      in_ros = false;
      continue;
    }
    const auto value = [&]() -> const std::string& {
      if (i + 1 >= arguments.size()) {
        throw std::invalid_argument("Couldn't parse trailing " + argument +
                                    " flag. No value found.");
      }
      return arguments[++i];
    };
    if (argument == "-r" || argument == "--remap") {
      result.remaps.push_back(parse_remap(argument, value()));
    } else if (argument == "-p" || argument == "--param") {
      result.parameters.push_back({false, {}, parse_parameter(argument, value())});
    } else if (argument == "--params-file") {
      result.parameters.push_back({true, value(), {}});
    } else if (argument == "--log-level") {
      result.log_levels.push_back(parse_log_level(argument, value()));
    } else if (argument == "-e" || argument == "--enclave") {
      result.enclave = value();
    } else if (argument == "--log-config-file" || argument == "--log-file-name") {
      value();
    } else if (!parse_switch(argument, "rosout-logs", &result.log_rosout) &&
               !parse_switch(argument, "stdout-logs", &result.log_stdout) &&
               !parse_switch(argument, "external-lib-logs", &external_logs)) {
      if (argument.find(":=") != std::string::npos) {
        result.remaps.push_back(parse_remap("--remap", argument));
      } else {
        result.unknown_ros_arguments.push_back(argument);
      }
    }
  }
  return result;
}

std::string remap_topic_or_service(const Arguments* local, const Arguments* global,
                                   const std::string& full_name, bool is_service,
                                   const std::string& node, const std::string& ns) {
  const WantedName wanted{full_name, is_service, node, ns};
  const RemapRule* rule = find_rule(local, global, &fits_name, &wanted);
  return rule == nullptr ? full_name : expand_topic_name(rule->to, node, ns);
}

std::string remap_node_name(const Arguments* local, const Arguments* global,
                            const std::string& name) {
  const RemapRule* rule = find_rule(local, global, &fits_node_name, &name);
  return rule == nullptr ? name : rule->to;
}

std::string remap_node_namespace(const Arguments* local, const Arguments* global,
                                 const std::string& name, const std::string& ns) {
  const RemapRule* rule = find_rule(local, global, &fits_namespace, &name);
  return rule == nullptr ? ns : rule->to;
}

}  // namespace ros2wasm
