// See writer.hpp.
#include "rosbag2_cpp/writer.hpp"

#include <stdexcept>
#include <utility>

#include "rmw/rmw.h"
#include "rosbag2_storage/ros_helper.hpp"

namespace rosbag2_cpp {

using Lock = std::lock_guard<std::mutex>;

Writer::Writer(std::unique_ptr<writer_interfaces::BaseWriterInterface> writer_impl)
    : writer_impl_(std::move(writer_impl)) {}

Writer::~Writer() = default;

void Writer::open(const std::string& uri) {
  rosbag2_storage::StorageOptions options;
  options.uri = uri;
  open(options);
}

void Writer::open(const rosbag2_storage::StorageOptions& storage_options,
                  const ConverterOptions& converter_options) {
  const Lock lock(mutex_);
  writer_impl_->open(storage_options, converter_options);
}

void Writer::close() {
  const Lock lock(mutex_);
  writer_impl_->close();
}

void Writer::create_topic(const rosbag2_storage::TopicMetadata& topic_with_type) {
  const Lock lock(mutex_);
  writer_impl_->create_topic(topic_with_type);
}

void Writer::create_topic(const rosbag2_storage::TopicMetadata& topic_with_type,
                          const rosbag2_storage::MessageDefinition& message_definition) {
  const Lock lock(mutex_);
  writer_impl_->create_topic(topic_with_type, message_definition);
}

void Writer::remove_topic(const rosbag2_storage::TopicMetadata& topic_with_type) {
  const Lock lock(mutex_);
  writer_impl_->remove_topic(topic_with_type);
}

bool Writer::take_snapshot() {
  const Lock lock(mutex_);
  return writer_impl_->take_snapshot();
}

void Writer::split_bagfile() {
  const Lock lock(mutex_);
  writer_impl_->split_bagfile();
}

void Writer::write(std::shared_ptr<const rosbag2_storage::SerializedBagMessage> message) {
  const Lock lock(mutex_);
  writer_impl_->write(std::move(message));
}

void Writer::write(std::shared_ptr<const rosbag2_storage::SerializedBagMessage> message,
                   const std::string& topic_name, const std::string& type_name,
                   const std::string& serialization_format) {
  if (message->topic_name != topic_name) {
    throw std::runtime_error("trying to write a message with mismatching topic information: (" +
                             message->topic_name + ") vs (" + topic_name + ")");
  }
  rosbag2_storage::TopicMetadata topic;
  topic.name = topic_name;
  topic.type = type_name;
  topic.serialization_format = serialization_format;
  create_topic(topic);
  write(std::move(message));
}

void Writer::write(const rclcpp::SerializedMessage& message, const std::string& topic_name,
                   const std::string& type_name, const rclcpp::Time& time) {
  write(std::make_shared<const rclcpp::SerializedMessage>(message), topic_name, type_name, time);
}

void Writer::write(std::shared_ptr<const rclcpp::SerializedMessage> message,
                   const std::string& topic_name, const std::string& type_name,
                   const rclcpp::Time& time) {
  write(std::move(message), topic_name, type_name, time.nanoseconds(), time.nanoseconds());
}

void Writer::write(std::shared_ptr<const rclcpp::SerializedMessage> message,
                   const std::string& topic_name, const std::string& type_name,
                   const rcutils_time_point_value_t& recv_timestamp,
                   const rcutils_time_point_value_t& send_timestamp) {
  auto written = std::make_shared<rosbag2_storage::SerializedBagMessage>();
  written->topic_name = topic_name;
  written->recv_timestamp = recv_timestamp;
  written->send_timestamp = send_timestamp;
  // Its bytes, which live as long as the message that has them.
  auto* const bytes = new rcutils_uint8_array_t(message->get_rcl_serialized_message());
  written->serialized_data = {bytes, [message](rcutils_uint8_array_t* one) { delete one; }};
  write(std::move(written), topic_name, type_name, rmw_get_serialization_format());
}

void Writer::add_event_callbacks(bag_events::WriterEventCallbacks& callbacks) {
  writer_impl_->add_event_callbacks(callbacks);
}

}  // namespace rosbag2_cpp
