// See bridge_config.hpp.
#include "bridge_config.hpp"

#include <yaml-cpp/yaml.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace ros_gz_bridge {
namespace {

class EntryFault : public std::runtime_error {
 public:
  explicit EntryFault(const std::string& why)
      : std::runtime_error("Could not parse entry: " + why) {}
};

std::string text_of(const YAML::Node& entry, const char* key) {
  return entry[key] ? entry[key].as<std::string>() : std::string();
}

Direction direction_of(const YAML::Node& entry) {
  if (!entry["direction"]) return Direction::kBoth;
  const std::string text = text_of(entry, "direction");
  if (text == "BIDIRECTIONAL") return Direction::kBoth;
  if (text == "GZ_TO_ROS") return Direction::kGzToRos;
  if (text == "ROS_TO_GZ") return Direction::kRosToGz;
  throw EntryFault("invalid direction [" + text + "]");
}

ServiceEntry service_of(const YAML::Node& entry) {
  ServiceEntry service{.service = text_of(entry, "service_name"),
                       .ros_type = text_of(entry, "ros_type_name"),
                       .gz_request = text_of(entry, "gz_req_type_name"),
                       .gz_answer = text_of(entry, "gz_rep_type_name")};
  if (service.ros_type.empty() || service.gz_request.empty() || service.gz_answer.empty())
    throw EntryFault("ros_type_name, gz_req_type_name and gz_rep_type_name must be set");
  return service;
}

BridgeArgument entry_of(const YAML::Node& entry) {
  if (!entry.IsMap()) throw EntryFault("entry must be a YAML map");
  if (entry["service_name"]) return service_of(entry);
  const std::string both = text_of(entry, "topic_name");
  BridgeEntry result;
  result.ros_topic = text_of(entry, "ros_topic_name");
  result.gz_topic = text_of(entry, "gz_topic_name");
  result.ros_type = text_of(entry, "ros_type_name");
  result.gz_type = text_of(entry, "gz_type_name");
  if (!both.empty() && !result.ros_topic.empty())
    throw EntryFault("topic_name and ros_topic_name are mutually exclusive");
  if (!both.empty() && !result.gz_topic.empty())
    throw EntryFault("topic_name and gz_topic_name are mutually exclusive");
  if (result.ros_type.empty() || result.gz_type.empty())
    throw EntryFault("both ros_type_name and gz_type_name must be set");
  result.direction = direction_of(entry);
  if (result.ros_topic.empty()) result.ros_topic = both.empty() ? result.gz_topic : both;
  if (result.gz_topic.empty()) result.gz_topic = result.ros_topic;
  if (result.ros_topic.empty())
    throw EntryFault("one of topic_name, ros_topic_name and gz_topic_name must be set");
  if (entry["publisher_queue"]) result.publisher_queue = entry["publisher_queue"].as<std::size_t>();
  if (entry["subscriber_queue"])
    result.subscriber_queue = entry["subscriber_queue"].as<std::size_t>();
  if (entry["lazy"]) result.is_lazy = entry["lazy"].as<bool>();
  return result;
}

}  // namespace

BridgeConfig read_bridge_config(const std::string& yaml) {
  BridgeConfig config;
  try {
    const YAML::Node list = YAML::Load(yaml);
    if (!list.IsSequence()) {
      config.faults.emplace_back("Could not parse config: top level must be a YAML sequence");
      return config;
    }
    for (const YAML::Node& entry : list) {
      try {
        config.entries.push_back(entry_of(entry));
      } catch (const EntryFault& fault) {
        config.faults.emplace_back(fault.what());
      } catch (const YAML::Exception& fault) {
        config.faults.push_back(std::string("Could not parse entry: ") + fault.what());
      }
    }
  } catch (const YAML::Exception& fault) {
    config.faults.push_back(std::string("Could not parse config: ") + fault.what());
  }
  return config;
}

BridgeConfig read_bridge_config_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) return {{}, {"Could not parse config: failed to open file [" + path + "]"}};
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (text.empty()) return {{}, {"Could not parse config: file empty [" + path + "]"}};
  return read_bridge_config(text);
}

}  // namespace ros_gz_bridge
