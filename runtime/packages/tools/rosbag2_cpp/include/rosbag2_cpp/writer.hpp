// Writes messages into a bag that does not exist yet.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "rclcpp/serialization.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/time.hpp"
#include "rmw/rmw.h"
#include "rosbag2_cpp/bag_events.hpp"
#include "rosbag2_cpp/converter_options.hpp"
#include "rosbag2_cpp/detail/known_type.hpp"
#include "rosbag2_cpp/visibility_control.hpp"
#include "rosbag2_cpp/writers/sequential_writer.hpp"
#include "rosbag2_storage/serialized_bag_message.hpp"
#include "rosbag2_storage/storage_options.hpp"
#include "rosbag2_storage/topic_metadata.hpp"
#include "rosidl_runtime_cpp/traits.hpp"

namespace rosbag2_cpp {

/// Functions that fail throw std::runtime_error.
class Writer {
 public:
  explicit Writer(std::unique_ptr<writer_interfaces::BaseWriterInterface> writer_impl =
                      std::make_unique<writers::SequentialWriter>());
  /// Closes.
  ~Writer();

  /// `uri`: the bag's folder.
  void open(const std::string& uri);
  void open(const rosbag2_storage::StorageOptions& storage_options,
            const ConverterOptions& converter_options = ConverterOptions());
  void close();

  /// Nothing for a topic that is there.
  void create_topic(const rosbag2_storage::TopicMetadata& topic_with_type);
  void create_topic(const rosbag2_storage::TopicMetadata& topic_with_type,
                    const rosbag2_storage::MessageDefinition& message_definition);
  void remove_topic(const rosbag2_storage::TopicMetadata& topic_with_type);
  /// False when the bag is not written in snapshots.
  bool take_snapshot();
  /// The next file begins.
  void split_bagfile();

  /// The message's topic must have been created.
  void write(std::shared_ptr<const rosbag2_storage::SerializedBagMessage> message);

  // These create the topic when it is not there.

  void write(std::shared_ptr<const rosbag2_storage::SerializedBagMessage> message,
             const std::string& topic_name, const std::string& type_name,
             const std::string& serialization_format = "cdr");
  [[deprecated("use write() with a shared pointer to the message")]] void write(
      const rclcpp::SerializedMessage& message, const std::string& topic_name,
      const std::string& type_name, const rclcpp::Time& time);
  void write(std::shared_ptr<const rclcpp::SerializedMessage> message,
             const std::string& topic_name, const std::string& type_name, const rclcpp::Time& time);
  void write(std::shared_ptr<const rclcpp::SerializedMessage> message,
             const std::string& topic_name, const std::string& type_name,
             const rcutils_time_point_value_t& recv_timestamp,
             const rcutils_time_point_value_t& send_timestamp);
  template <class MessageT>
  void write(const MessageT& message, const std::string& topic_name, const rclcpp::Time& time) {
    (void)detail::KnownType<MessageT>::is_known;
    const auto serialized = std::make_shared<rclcpp::SerializedMessage>();
    rclcpp::Serialization<MessageT>().serialize_message(&message, serialized.get());
    write(serialized, topic_name, rosidl_generator_traits::name<MessageT>(), time);
  }

  writer_interfaces::BaseWriterInterface& get_implementation_handle() const {
    return *writer_impl_;
  }
  void add_event_callbacks(bag_events::WriterEventCallbacks& callbacks);

 private:
  std::mutex mutex_;
  std::unique_ptr<writer_interfaces::BaseWriterInterface> writer_impl_;
};

}  // namespace rosbag2_cpp
