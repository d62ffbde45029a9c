// See metadata_yaml.hpp.
#include "metadata_yaml.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "rmw/qos_string_conversions.h"
#include "rosbag2_storage/qos.hpp"

namespace rosbag2_storage {
namespace {

using ros2wasm::YamlNode;
using Clock = std::chrono::high_resolution_clock;

// ---- writing

/// Plain where nobody can take it for anything else.
std::string scalar(const std::string& text) {
  constexpr std::string_view kOther[] = {"true", "false", "null", "yes", "no",
                                         "on",   "off",   "y",    "n"};
  std::string lower;
  bool is_plain = !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) != 0 ||
                                    text[0] == '/' || text[0] == '_');
  for (const char one : text) {
    const auto letter = static_cast<unsigned char>(one);
    lower += static_cast<char>(std::tolower(letter));
    is_plain = is_plain && (std::isalnum(letter) != 0 ||
                            std::string_view("/_.-").find(one) != std::string_view::npos);
  }
  if (is_plain && std::find(std::begin(kOther), std::end(kOther), lower) == std::end(kOther)) {
    return text;
  }
  std::string quoted = "\"";
  for (const char one : text) {
    constexpr char kDigits[] = "0123456789abcdef";
    const auto letter = static_cast<unsigned char>(one);
    if (one == '"' || one == '\\') {
      quoted += '\\';
      quoted += one;
    } else if (one == '\n') {
      quoted += "\\n";
    } else if (letter < ' ' || letter == 0x7F) {
      quoted += std::string("\\x") + kDigits[letter >> 4] + kDigits[letter & 15];
    } else {
      quoted += one;
    }
  }
  return quoted + "\"";
}

template <typename T>
std::string field(const std::string& indent, const char* name, const T& value) {
  return indent + name + ": " + value + "\n";
}

std::string nanoseconds(const std::string& indent, const char* name, const char* unit, int64_t ns) {
  return indent + name + ":\n" + field(indent + "  ", unit, std::to_string(ns));
}

std::string duration(const std::string& indent, const char* name, std::chrono::nanoseconds value) {
  return nanoseconds(indent, name, "nanoseconds", value.count());
}

std::string time(const std::string& indent, const char* name,
                 std::chrono::time_point<Clock> value) {
  const auto since = std::chrono::duration_cast<std::chrono::nanoseconds>(value.time_since_epoch());
  return nanoseconds(indent, name, "nanoseconds_since_epoch", since.count());
}

/// `items`: blocks that are indented by two more than their list.
std::string list(const std::string& indent, const char* name,
                 const std::vector<std::string>& items) {
  if (items.empty()) {
    return field(indent, name, "[]");
  }
  std::string text = indent + name + ":\n";
  for (const std::string& item : items) {
    text += indent + "  - " + item.substr(indent.size() + 4);
  }
  return text;
}

std::string policy(const char* word, int number, int version) {
  return version < 9 ? std::to_string(number) : word == nullptr ? "unknown" : word;
}

std::string rmw_time(const std::string& indent, const char* name, const rmw_time_t& value) {
  return indent + name + ":\n" + field(indent + "  ", "sec", std::to_string(value.sec)) +
         field(indent + "  ", "nsec", std::to_string(value.nsec));
}

std::string profile_lines(const rclcpp::QoS& profile, const std::string& indent, int version) {
  const rmw_qos_profile_t& qos = profile.get_rmw_qos_profile();
  return field(indent, "history",
               policy(rmw_qos_history_policy_to_str(qos.history), qos.history, version)) +
         field(indent, "depth", std::to_string(qos.depth)) +
         field(
             indent, "reliability",
             policy(rmw_qos_reliability_policy_to_str(qos.reliability), qos.reliability, version)) +
         field(indent, "durability",
               policy(rmw_qos_durability_policy_to_str(qos.durability), qos.durability, version)) +
         rmw_time(indent, "deadline", qos.deadline) + rmw_time(indent, "lifespan", qos.lifespan) +
         field(indent, "liveliness",
               policy(rmw_qos_liveliness_policy_to_str(qos.liveliness), qos.liveliness, version)) +
         rmw_time(indent, "liveliness_lease_duration", qos.liveliness_lease_duration) +
         field(indent, "avoid_ros_namespace_conventions",
               qos.avoid_ros_namespace_conventions ? "true" : "false");
}

std::string topic_lines(const TopicInformation& topic, const std::string& indent, int version) {
  const TopicMetadata& of = topic.topic_metadata;
  const std::string deeper = indent + "  ";
  std::string text = indent + "topic_metadata:\n";
  text += field(deeper, "name", scalar(of.name)) + field(deeper, "type", scalar(of.type));
  text += field(deeper, "serialization_format", scalar(of.serialization_format));
  const std::string profiles = profiles_yaml(of.offered_qos_profiles, deeper + "  ", version);
  if (version < 9) {
    text += field(deeper, "offered_qos_profiles",
                  scalar(profiles_yaml(of.offered_qos_profiles, "", version)));
  } else if (of.offered_qos_profiles.empty()) {
    text += field(deeper, "offered_qos_profiles", profiles);
  } else {
    text += deeper + "offered_qos_profiles:\n" + profiles + "\n";
  }
  text += field(deeper, "type_description_hash", scalar(of.type_description_hash));
  return text + field(indent, "message_count", std::to_string(topic.message_count));
}

// ---- reading

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("bad conversion: " + what);
}

/// Null: there is none.
const YamlNode* entry(const YamlNode& node, std::string_view name) {
  for (const auto& [key, value] : node.entries) {
    if (key == name) {
      return &value;
    }
  }
  return nullptr;
}

const YamlNode& at(const YamlNode& node, const char* name) {
  const YamlNode* const found = entry(node, name);
  if (found == nullptr) {
    refuse(std::string("there is no '") + name + "'");
  }
  return *found;
}

const std::string& text_at(const YamlNode& node, const char* name) {
  const YamlNode& found = at(node, name);
  if (found.kind != YamlNode::Kind::scalar) {
    refuse(std::string("'") + name + "' is not text");
  }
  return found.text;
}

std::chrono::nanoseconds duration_at(const YamlNode& node, const char* name) {
  return std::chrono::nanoseconds(
      static_cast<int64_t>(to_whole(at(at(node, name), "nanoseconds"))));
}

std::chrono::time_point<Clock> time_at(const YamlNode& node, const char* name) {
  return std::chrono::time_point<Clock>(std::chrono::nanoseconds(
      static_cast<int64_t>(to_whole(at(at(node, name), "nanoseconds_since_epoch")))));
}

/// Reads a time; the values that Foxy's implementations wrote for "no limit" become infinite.
rmw_time_t rmw_time_at(const YamlNode& node, const char* name) {
  const YamlNode& found = at(node, name);
  const rmw_time_t value{to_whole(at(found, "sec")), to_whole(at(found, "nsec"))};
  constexpr uint64_t kFoxy = 0x7FFFFFFF;
  const bool is_endless = rmw_time_equal(value, RMW_DURATION_INFINITE) ||
                          (value.sec == kFoxy && (value.nsec == 0xFFFFFFFF || value.nsec == kFoxy));
  return is_endless ? rmw_time_t RMW_DURATION_INFINITE : value;
}

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](unsigned char digit) { return std::isdigit(digit) != 0; });
}

/// A word, or in older bags its number.
template <typename Policy>
Policy policy_at(const YamlNode& node, const char* name, Policy (*of_word)(const char*)) {
  const std::string& text = text_at(node, name);
  return is_number(text) ? static_cast<Policy>(to_whole(at(node, name)) & 0xF)
                         : of_word(text.c_str());
}

rclcpp::QoS parse_profile(const YamlNode& node) {
  Rosbag2QoS qos;
  qos.get_rmw_qos_profile().depth = static_cast<size_t>(to_whole(at(node, "depth")));
  qos.history(policy_at(node, "history", rmw_qos_history_policy_from_str));
  qos.reliability(policy_at(node, "reliability", rmw_qos_reliability_policy_from_str));
  qos.durability(policy_at(node, "durability", rmw_qos_durability_policy_from_str));
  qos.deadline(rmw_time_at(node, "deadline")).lifespan(rmw_time_at(node, "lifespan"));
  qos.liveliness(policy_at(node, "liveliness", rmw_qos_liveliness_policy_from_str));
  qos.liveliness_lease_duration(rmw_time_at(node, "liveliness_lease_duration"));
  qos.avoid_ros_namespace_conventions(text_at(node, "avoid_ros_namespace_conventions") == "true");
  return qos;
}

TopicInformation parse_topic(const YamlNode& node, int version) {
  TopicInformation topic;
  const YamlNode& of = at(node, "topic_metadata");
  topic.topic_metadata.name = text_at(of, "name");
  topic.topic_metadata.type = text_at(of, "type");
  topic.topic_metadata.serialization_format = text_at(of, "serialization_format");
  if (version >= 9) {
    topic.topic_metadata.offered_qos_profiles = parse_profiles(at(of, "offered_qos_profiles"));
  } else if (version >= 4) {
    topic.topic_metadata.offered_qos_profiles =
        to_rclcpp_qos_vector(text_at(of, "offered_qos_profiles"), version);
  }
  if (version >= 7) {
    topic.topic_metadata.type_description_hash = text_at(of, "type_description_hash");
  }
  topic.message_count = static_cast<size_t>(to_whole(at(node, "message_count")));
  return topic;
}

FileInformation parse_file(const YamlNode& node) {
  FileInformation file;
  file.path = text_at(node, "path");
  file.starting_time = time_at(node, "starting_time");
  file.duration = duration_at(node, "duration");
  file.message_count = static_cast<size_t>(to_whole(at(node, "message_count")));
  return file;
}

}  // namespace

std::string profiles_yaml(const std::vector<rclcpp::QoS>& profiles, const std::string& indent,
                          int version) {
  if (profiles.empty()) {
    return "[]";
  }
  std::string text;
  for (const rclcpp::QoS& profile : profiles) {
    const std::string lines = profile_lines(profile, indent + "  ", version);
    text += indent + "- " + lines.substr(indent.size() + 2);
  }
  text.pop_back();
  return text;
}

std::string metadata_yaml(const BagMetadata& metadata, const std::string& indent) {
  const std::string deeper = indent + "    ";
  std::vector<std::string> topics;
  for (const TopicInformation& topic : metadata.topics_with_message_count) {
    topics.push_back(topic_lines(topic, deeper, metadata.version));
  }
  std::vector<std::string> paths;
  for (const std::string& path : metadata.relative_file_paths) {
    paths.push_back(deeper + scalar(path) + "\n");
  }
  std::vector<std::string> files;
  for (const FileInformation& file : metadata.files) {
    files.push_back(field(deeper, "path", scalar(file.path)) +
                    time(deeper, "starting_time", file.starting_time) +
                    duration(deeper, "duration", file.duration) +
                    field(deeper, "message_count", std::to_string(file.message_count)));
  }
  std::vector<std::pair<std::string, std::string>> custom(metadata.custom_data.begin(),
                                                          metadata.custom_data.end());
  std::sort(custom.begin(), custom.end());
  std::string text = field(indent, "version", std::to_string(metadata.version));
  text += field(indent, "storage_identifier", scalar(metadata.storage_identifier));
  text += duration(indent, "duration", metadata.duration);
  text += time(indent, "starting_time", metadata.starting_time);
  text += field(indent, "message_count", std::to_string(metadata.message_count));
  text += list(indent, "topics_with_message_count", topics);
  text += field(indent, "compression_format", scalar(metadata.compression_format));
  text += field(indent, "compression_mode", scalar(metadata.compression_mode));
  text += list(indent, "relative_file_paths", paths);
  text += list(indent, "files", files);
  text += custom.empty() ? field(indent, "custom_data", "~") : indent + "custom_data:\n";
  for (const auto& [key, value] : custom) {
    text += field(indent + "  ", scalar(key).c_str(), scalar(value));
  }
  return text + field(indent, "ros_distro", scalar(metadata.ros_distro));
}

uint64_t to_whole(const YamlNode& node) {
  char* end = nullptr;
  errno = 0;
  const char* const begin = node.text.c_str();
  // Durations of bags without messages are negative for some writers.
  const bool is_negative = *begin == '-';
  const uint64_t value = std::strtoull(begin + (is_negative ? 1 : 0), &end, 10);
  if (node.kind != YamlNode::Kind::scalar || !is_number(node.text.substr(is_negative ? 1 : 0)) ||
      errno != 0) {
    refuse("'" + node.text.substr(0, 40) + "' is not a whole number");
  }
  return is_negative ? 0 - value : value;
}

std::vector<rclcpp::QoS> parse_profiles(const YamlNode& node) {
  std::vector<rclcpp::QoS> profiles;
  if (node.kind != YamlNode::Kind::sequence) {
    refuse("QoS profiles are no list");
  }
  for (const YamlNode& item : node.items) {
    profiles.push_back(parse_profile(item));
  }
  return profiles;
}

BagMetadata parse_metadata(const YamlNode& node) {
  BagMetadata metadata;
  metadata.version = static_cast<int>(to_whole(at(node, "version")));
  metadata.storage_identifier = text_at(node, "storage_identifier");
  metadata.duration = duration_at(node, "duration");
  metadata.starting_time = time_at(node, "starting_time");
  metadata.message_count = to_whole(at(node, "message_count"));
  for (const YamlNode& topic : at(node, "topics_with_message_count").items) {
    metadata.topics_with_message_count.push_back(parse_topic(topic, metadata.version));
  }
  for (const YamlNode& path : at(node, "relative_file_paths").items) {
    metadata.relative_file_paths.push_back(path.text);
  }
  if (metadata.version >= 3) {
    metadata.compression_format = text_at(node, "compression_format");
    metadata.compression_mode = text_at(node, "compression_mode");
  }
  if (metadata.version >= 5) {
    for (const YamlNode& file : at(node, "files").items) {
      metadata.files.push_back(parse_file(file));
    }
  }
  if (metadata.version >= 6) {
    for (const auto& [key, value] : at(node, "custom_data").entries) {
      metadata.custom_data[key] = value.text;
    }
  }
  if (metadata.version >= 8) {
    metadata.ros_distro = text_at(node, "ros_distro");
  }
  return metadata;
}

}  // namespace rosbag2_storage
