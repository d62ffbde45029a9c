// The definition of a message type, as a bag has it.
#pragma once

#include <string>

namespace rosbag2_storage {

struct MessageDefinition {
  std::string topic_type;
  /// "ros2msg", "ros2idl", or empty: there is none.
  std::string encoding;
  /// With the definitions of all types inside it.
  std::string encoded_message_definition;
  std::string type_hash;

  static MessageDefinition empty_message_definition_for(const std::string& topic_type) {
    return {topic_type, "", "", ""};
  }
  bool operator==(const MessageDefinition& other) const {
    return topic_type == other.topic_type && encoding == other.encoding &&
           encoded_message_definition == other.encoded_message_definition &&
           type_hash == other.type_hash;
  }
};

}  // namespace rosbag2_storage
