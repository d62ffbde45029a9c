// See node_arguments.hpp.
#include "bundler/launch/node_arguments.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "bundler/launch/ros2_command.hpp"

namespace ros2wasm {
namespace {

std::string text_of(bool value) {
  return value ? "true" : "false";
}
std::string text_of(std::int64_t value) {
  return std::to_string(value);
}

std::string text_of(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  std::string text(buffer.data(), end);
  // A double must not turn into an integer on the way; YAML 1.1 wants a dot before an exponent.
  const auto exponent = text.find('e');
  if (text.find('.') == std::string::npos) {
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  }
  return text;
}

/// Always quoted, so that '1' and 'true' stay strings.
std::string text_of(const std::string& value) {
  bool plain = true;
  for (const char c : value) plain = plain && static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
  std::string result;
  if (plain) {
    result = "'";
    for (const char c : value) result += c == '\'' ? std::string("''") : std::string(1, c);
    return result + "'";
  }
  constexpr std::string_view kHex = "0123456789abcdef";
  result = "\"";
  for (const char c : value) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (byte < 0x20 || byte == 0x7f) {
      result += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 15U]};
    } else {
      result += c;
    }
  }
  return result + "\"";
}

template <typename T>
std::string text_of(const std::vector<T>& values) {
  std::string result = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) result += ", ";
    result += text_of(static_cast<T>(values[i]));
  }
  return result + "]";
}

}  // namespace

std::string parameter_text(const ParameterValue& value) {
  return std::visit([](const auto& one) { return text_of(one); }, value);
}

std::vector<std::string> node_arguments(const NodeEntry& entry,
                                        const std::vector<FileRules>& files) {
  std::vector<std::string> result = entry.arguments;
  std::vector<std::string> ros = entry.ros_arguments;
  const auto add = [&ros](const char* option, std::string value) {
    ros.emplace_back(option);
    ros.push_back(std::move(value));
  };
  if (entry.name) add("-r", "__node:=" + entry.name->value);
  if (entry.name_space) add("-r", "__ns:=" + entry.name_space->value);
  std::size_t files_done = 0;
  const auto add_files_up_to = [&](std::size_t count) {
    for (; files_done < count && files_done < files.size(); ++files_done) {
      for (const ParameterRule& rule : files[files_done]) {
        add("-p", (rule.pattern.empty() ? "" : rule.pattern + ":") + rule.name + ":=" + rule.value);
      }
    }
  };
  // As launch_ros writes them: for the node alone when its whole name is known, else for every node
  // of the process, which matters beside files that name it.
  std::string own;
  if (entry.name && entry.name_space) own = node_label(entry) + ":";
  for (const ParameterEntry& parameter : entry.parameters) {
    add_files_up_to(parameter.files_before);
    add("-p", own + parameter.name + ":=" + parameter_text(parameter.value));
  }
  add_files_up_to(files.size());
  for (const auto& [from, to] : entry.remappings) add("-r", from + ":=" + to);
  if (!ros.empty()) {
    result.emplace_back("--ros-args");
    result.insert(result.end(), ros.begin(), ros.end());
  }
  return result;
}

std::string program_label(const NodeEntry& entry) {
  if (!entry.is_command) return entry.package.value + "/" + entry.executable.value;
  std::vector<std::string> words{entry.executable.value};
  words.insert(words.end(), entry.arguments.begin(), entry.arguments.end());
  return shown_command(words);
}

std::string node_label(const NodeEntry& entry) {
  if (entry.is_command) return program_label(entry);
  std::string space = entry.name_space ? entry.name_space->value : "/";
  if (!entry.name) return entry.executable.value + (space == "/" ? "" : " (" + space + ")");
  if (!space.ends_with('/')) space += '/';
  return space + entry.name->value;
}

}  // namespace ros2wasm
