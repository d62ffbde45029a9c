// See param_files.hpp.
#include "param_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "ros2wasm/yaml.hpp"

namespace controller_manager {
namespace {

using ros2wasm::YamlNode;

const YamlNode* entry(const YamlNode& map, const std::string& key) {
  for (const auto& [name, value] : map.entries) {
    if (name == key) {
      return &value;
    }
  }
  return nullptr;
}

YamlNode contents_of(const std::string& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  try {
    return ros2wasm::parse_yaml(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

}  // namespace

ControllerFileFacts read_param_files(const std::string& controller, const std::string& name_space,
                                     const std::vector<std::string>& files) {
  const std::string full = (name_space == "/" ? "" : name_space) + "/" + controller;
  const std::vector<std::string> keys = {controller, full, "/**/" + controller, "/**" + full};
  ControllerFileFacts facts;
  for (const std::string& file : files) {
    if (std::find(facts.files.begin(), facts.files.end(), file) != facts.files.end()) {
      continue;
    }
    const YamlNode root = contents_of(file);
    const YamlNode* const wildcard = entry(root, "/**");
    std::vector<const YamlNode*> sections;
    for (const std::string& key : keys) {
      const YamlNode* section = entry(root, key);
      if (section != nullptr && key == controller && name_space != "/") {
        facts.lacks_namespace = true;
        break;
      }
      if (section == nullptr && wildcard != nullptr) {
        section = entry(*wildcard, key);
      }
      if (section != nullptr) {
        sections.push_back(section);
      }
    }
    if (wildcard != nullptr && entry(*wildcard, "ros__parameters") != nullptr) {
      sections.push_back(wildcard);
    }
    for (const YamlNode* const section : sections) {
      const YamlNode* const parameters = entry(*section, "ros__parameters");
      if (parameters == nullptr) {
        throw std::runtime_error(
            "YAML file : " + file +
            " is not a valid ROS parameter file for controller node : " + full);
      }
      const YamlNode* const type = entry(*parameters, "type");
      if (type != nullptr && facts.type.empty()) {
        facts.type = type->text;
      }
      const YamlNode* const fallbacks = entry(*parameters, "fallback_controllers");
      if (fallbacks != nullptr && facts.fallbacks.empty()) {
        for (const YamlNode& item : fallbacks->items) {
          facts.fallbacks.push_back(item.text);
        }
      }
    }
    if (!sections.empty()) {
      facts.files.push_back(file);
    }
  }
  return facts;
}

ControllerArgumentFacts read_param_arguments(const std::string& controller,
                                             const std::string& name_space,
                                             const std::vector<std::string>& arguments) {
  const std::string full = (name_space == "/" ? "" : name_space) + "/" + controller;
  const std::vector<std::string> nodes = {full, "/**/" + controller, "/**" + full, "/**"};
  ControllerArgumentFacts facts;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i - 1] != "-p" && arguments[i - 1] != "--param") {
      continue;
    }
    const std::string& rule = arguments[i];
    const std::size_t assigned = rule.find(":=");
    const std::size_t colon = rule.find(':');
    if (assigned == std::string::npos || colon == assigned ||
        std::find(nodes.begin(), nodes.end(), rule.substr(0, colon)) == nodes.end()) {
      continue;  // of the spawner itself, or of another controller
    }
    const std::string name = rule.substr(colon + 1, assigned - colon - 1);
    const YamlNode value = ros2wasm::parse_yaml(rule.substr(assigned + 2));
    if (name == "type") {
      facts.type = value.text;
    } else if (name == "fallback_controllers") {
      facts.fallbacks.clear();
      for (const YamlNode& item : value.items) {
        facts.fallbacks.push_back(item.text);
      }
    }
    if (facts.ros_args.empty()) {
      facts.ros_args.emplace_back("--ros-args");
    }
    facts.ros_args.insert(facts.ros_args.end(), {"-p", rule});
  }
  return facts;
}

}  // namespace controller_manager
