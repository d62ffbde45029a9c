// See arguments.hpp.
#include "arguments.hpp"

#include <cstdlib>
#include <utility>

namespace gazebo_ros {
namespace {

constexpr const char* kUsage =
    "usage: spawn_entity.py [-h] (-file FILE_NAME | -topic TOPIC_NAME | -database ENTITY_NAME | "
    "-stdin) -entity ENTITY_NAME\n"
    "                       [-reference_frame REFERENCE_FRAME] [-gazebo_namespace "
    "GAZEBO_NAMESPACE]\n"
    "                       [-robot_namespace ROBOT_NAMESPACE] [-timeout TIMEOUT] [-pause] "
    "[-unpause]\n"
    "                       [-wait ENTITY_NAME] [-spawn_service_timeout TIMEOUT] [-x X] [-y Y] "
    "[-z Z]\n"
    "                       [-R R] [-P P] [-Y Y] [-package_to_model] [-b]\n";

/// Where the value of an option goes: one of the three.
struct Option {
  const char* name;
  std::string* text = nullptr;
  double* number = nullptr;
  bool* flag = nullptr;
};

ReadArguments fault(const std::string& what) {
  return {std::nullopt, kUsage + ("spawn_entity.py: error: " + what + "\n"), 2};
}

std::optional<double> number_of(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::nullopt : std::optional(value);
}

/// A word that begins with `-` is an option, unless it is a number.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !number_of(word);
}

/// Sets the option to a value. Returns what is wrong with it; empty: nothing.
std::string set(const Option& option, const std::string& value) {
  if (option.text != nullptr) {
    *option.text = value;
    return {};
  }
  const auto number = number_of(value);
  if (!number)
    return std::string("argument ") + option.name + ": invalid float value: '" + value + "'";
  *option.number = *number;
  return {};
}

std::vector<Option> options_of(Arguments& into, double& old_timeout_s) {
  return {
      {"-file", &into.file},
      {"-topic", &into.topic},
      {"-database", &into.database},
      {"-stdin", nullptr, nullptr, &into.from_stdin},
      {"-entity", &into.entity},
      {"-reference_frame", &into.reference_frame},
      {"-gazebo_namespace", &into.gazebo_namespace},
      {"-robot_namespace", &into.robot_namespace},
      {"-timeout", nullptr, &into.timeout_s},
      {"-pause", nullptr, nullptr, &into.pauses},
      {"-unpause", nullptr, nullptr, &into.unpauses},
      {"-wait", &into.wait_for},
      {"-spawn_service_timeout", nullptr, &old_timeout_s},
      {"-x", nullptr, &into.x},
      {"-y", nullptr, &into.y},
      {"-z", nullptr, &into.z},
      {"-R", nullptr, &into.roll},
      {"-P", nullptr, &into.pitch},
      {"-Y", nullptr, &into.yaw},
      {"-package_to_model", nullptr, nullptr, &into.package_to_model},
      {"-b", nullptr, nullptr, &into.is_bound},
  };
}

/// By its name or, as argparse allows, by what only one name begins with.
const Option* find(const std::vector<Option>& options, const std::string& name) {
  const Option* found = nullptr;
  for (const Option& one : options) {
    if (one.name == name) return &one;
    if (std::string(one.name).rfind(name, 0) != 0) continue;
    if (found != nullptr) return nullptr;
    found = &one;
  }
  return found;
}

}  // namespace

ReadArguments read_arguments(const std::vector<std::string>& words) {
  Arguments result;
  double old_timeout_s = -1;
  const auto options = options_of(result, old_timeout_s);
  std::vector<const char*> sources;
  bool is_named = false;
  std::string unknown;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "-h" || word == "--help") return {std::nullopt, kUsage, 0};
    const std::size_t equals = is_option(word) ? word.find('=') : std::string::npos;
    const Option* option = is_option(word) ? find(options, word.substr(0, equals)) : nullptr;
    if (option == nullptr) {
      unknown += " " + word;
      continue;
    }
    const std::string name = option->name;
    if (name == "-file" || name == "-topic" || name == "-database" || name == "-stdin") {
      if (!sources.empty() && sources.back() != name)
        return fault("argument " + name + ": not allowed with argument " + sources.back());
      sources.push_back(option->name);
    }
    is_named = is_named || name == "-entity";
    if (option->flag != nullptr) {
      *option->flag = true;
      continue;
    }
    const bool has_value =
        equals != std::string::npos || (i + 1 < words.size() && !is_option(words[i + 1]));
    if (!has_value) return fault("argument " + name + ": expected one argument");
    const std::string& value = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
    if (const std::string wrong = set(*option, value); !wrong.empty()) return fault(wrong);
  }
  if (!is_named) return fault("the following arguments are required: -entity");
  if (sources.empty())
    return fault("one of the arguments -file -topic -database -stdin is required");
  if (!unknown.empty()) return fault("unrecognized arguments:" + unknown);
  if (old_timeout_s >= 0) result.old_timeout_s = old_timeout_s;
  return {std::move(result), {}, 0};
}

}  // namespace gazebo_ros
