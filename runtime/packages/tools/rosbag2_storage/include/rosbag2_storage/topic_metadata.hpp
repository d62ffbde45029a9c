// A topic, as a bag has it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rclcpp/qos.hpp"

namespace rosbag2_storage {

struct TopicMetadata {
  uint16_t id = 0;  ///< given by the storage
  std::string name;
  /// "std_msgs/msg/String"
  std::string type;
  /// "cdr"
  std::string serialization_format;
  /// The QoS profiles of its publishers.
  std::vector<rclcpp::QoS> offered_qos_profiles;
  /// "RIHS01_...", or empty.
  std::string type_description_hash;

  bool operator==(const TopicMetadata& other) const {
    return id == other.id && name == other.name && type == other.type &&
           serialization_format == other.serialization_format &&
           type_description_hash == other.type_description_hash;
  }
};

}  // namespace rosbag2_storage
