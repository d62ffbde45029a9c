// Interface of storages to which messages are written.
#pragma once

#include <memory>
#include <vector>

#include "rosbag2_storage/bag_metadata.hpp"
#include "rosbag2_storage/message_definition.hpp"
#include "rosbag2_storage/serialized_bag_message.hpp"
#include "rosbag2_storage/topic_metadata.hpp"

namespace rosbag2_storage {
namespace storage_interfaces {

class BaseWriteInterface {
 public:
  virtual ~BaseWriteInterface() = default;
  /// The message's topic must have been created.
  virtual void write(std::shared_ptr<const SerializedBagMessage> msg) = 0;
  virtual void write(const std::vector<std::shared_ptr<const SerializedBagMessage>>& msgs) = 0;
  virtual void update_metadata(const BagMetadata& bag_metadata) = 0;
  virtual void create_topic(const TopicMetadata& topic,
                            const MessageDefinition& message_definition) = 0;
  virtual void remove_topic(const TopicMetadata& topic) = 0;
};

}  // namespace storage_interfaces
}  // namespace rosbag2_storage
