// Reads the messages of a bag.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rclcpp/serialization.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rosbag2_cpp/bag_events.hpp"
#include "rosbag2_cpp/converter_options.hpp"
#include "rosbag2_cpp/readers/sequential_reader.hpp"
#include "rosbag2_cpp/visibility_control.hpp"
#include "rosbag2_storage/bag_metadata.hpp"
#include "rosbag2_storage/serialized_bag_message.hpp"
#include "rosbag2_storage/storage_filter.hpp"
#include "rosbag2_storage/storage_options.hpp"
#include "rosbag2_storage/topic_metadata.hpp"

namespace rosbag2_cpp {

/// Functions that fail throw std::runtime_error; so do calls before open().
class Reader {
 public:
  explicit Reader(std::unique_ptr<reader_interfaces::BaseReaderInterface> reader_impl =
                      std::make_unique<readers::SequentialReader>());
  ~Reader();

  /// `uri`: a bag's folder, or a file of one.
  void open(const std::string& uri);
  void open(const rosbag2_storage::StorageOptions& storage_options,
            const ConverterOptions& converter_options = ConverterOptions());
  void close();
  /// False: the bag cannot be read so.
  bool set_read_order(const rosbag2_storage::ReadOrder& read_order);
  bool has_next();
  std::shared_ptr<rosbag2_storage::SerializedBagMessage> read_next();
  template <class MessageT>
  MessageT read_next() {
    MessageT message;
    const auto read = read_next();
    const rclcpp::SerializedMessage serialized(*read->serialized_data);
    rclcpp::Serialization<MessageT>().deserialize_message(&serialized, &message);
    return message;
  }
  const rosbag2_storage::BagMetadata& get_metadata() const;
  std::vector<rosbag2_storage::TopicMetadata> get_all_topics_and_types() const;
  void get_all_message_definitions(std::vector<rosbag2_storage::MessageDefinition>& definitions);
  void set_filter(const rosbag2_storage::StorageFilter& storage_filter);
  void reset_filter();
  /// The next message is the first one at that time (ns since 1970) or later.
  void seek(const rcutils_time_point_value_t& timestamp);
  reader_interfaces::BaseReaderInterface& get_implementation_handle() const {
    return *reader_impl_;
  }
  void add_event_callbacks(bag_events::ReaderEventCallbacks& callbacks);

 private:
  std::unique_ptr<reader_interfaces::BaseReaderInterface> reader_impl_;
};

}  // namespace rosbag2_cpp
