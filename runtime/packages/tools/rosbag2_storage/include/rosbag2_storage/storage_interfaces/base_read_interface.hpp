// Interface of storages from which messages are read, in an order that can be set.
#pragma once

#include <memory>
#include <vector>

#include "rosbag2_storage/message_definition.hpp"
#include "rosbag2_storage/serialized_bag_message.hpp"
#include "rosbag2_storage/topic_metadata.hpp"

namespace rosbag2_storage {

struct ReadOrder {
  /// By PublishedTimestamp no storage reads.
  enum SortBy { ReceivedTimestamp, PublishedTimestamp, File };

  SortBy sort_by = ReceivedTimestamp;
  bool reverse = false;

  ReadOrder(SortBy order, bool is_reverse) : sort_by(order), reverse(is_reverse) {}
  ReadOrder() = default;
};

inline bool operator==(const ReadOrder& a, const ReadOrder& b) {
  return a.sort_by == b.sort_by && a.reverse == b.reverse;
}

namespace storage_interfaces {

class BaseReadInterface {
 public:
  virtual ~BaseReadInterface() = default;
  /// False: it cannot. The place in the bag stays.
  virtual bool set_read_order(const ReadOrder& read_order) = 0;
  virtual bool has_next() = 0;
  /// Throws std::runtime_error at the end.
  virtual std::shared_ptr<SerializedBagMessage> read_next() = 0;
  virtual std::vector<TopicMetadata> get_all_topics_and_types() = 0;
  virtual void get_all_message_definitions(std::vector<MessageDefinition>& definitions) = 0;
};

}  // namespace storage_interfaces
}  // namespace rosbag2_storage
