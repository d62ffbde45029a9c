// See mcap_storage.hpp.
#include "mcap_storage.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "metadata_yaml.hpp"
#include "rcutils/logging_macros.h"
#include "ros2wasm/yaml.hpp"
#include "rosbag2_storage/qos.hpp"
#include "rosbag2_storage/ros_helper.hpp"

namespace rosbag2_storage {
namespace {

using storage_interfaces::IOFlag;

constexpr char kLog[] = "rosbag2_storage_mcap";
constexpr char kProfiles[] = "offered_qos_profiles";
constexpr char kHash[] = "topic_type_hash";
constexpr char kRecordName[] = "rosbag2";
constexpr char kRecordKey[] = "serialized_metadata";
/// The version of bags that do not say theirs: policies are numbers.
constexpr int kOlderVersion = 8;

[[noreturn]] void refuse_compression(const std::string& what) {
  throw std::runtime_error(what + " needs a compression: bags are written without one here");
}

void read_config(const std::string& path, mcap::WriterOptions& options) {
  std::ifstream file(path);
  if (!file) {
    throw std::runtime_error("bad file: " + path);
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [key, value] : ros2wasm::parse_yaml(text).entries) {
    if (key == "noChunking") {
      options.chunks = value.text != "true";
    } else if (key == "chunkSize") {
      options.chunk_size = to_whole(value);
    } else if (key == "compression" && value.text != "None") {
      refuse_compression("compression: " + value.text);
    }
  }
}

mcap::WriterOptions options_of(const StorageOptions& storage_options) {
  mcap::WriterOptions options;
  const std::string& profile = storage_options.storage_preset_profile;
  if (profile == "fastwrite") {
    options.chunks = false;
  } else if (profile == "zstd_fast" || profile == "zstd_small") {
    refuse_compression("MCAP storage preset profile '" + profile + "'");
  } else if (!profile.empty() && profile != "none") {
    throw std::runtime_error(
        "unknown MCAP storage preset profile (valid options are 'none', 'fastwrite', 'zstd_fast', "
        "'zstd_small'): " +
        profile);
  }
  if (!storage_options.storage_config_uri.empty()) {
    read_config(storage_options.storage_config_uri, options);
  }
  return options;
}

bool is_service_event(std::string_view topic) {
  constexpr std::string_view kEnd = "/_service_event";
  return topic.size() > kEnd.size() && topic.substr(topic.size() - kEnd.size()) == kEnd;
}

bool is_in(const std::vector<std::string>& list, const std::string& topic) {
  return std::find(list.begin(), list.end(), topic) != list.end();
}

/// Throws std::regex_error, which is a std::runtime_error, for what is not a regular expression.
std::function<bool(const std::string&)> wanted_by(const StorageFilter& filter) {
  const auto matcher = [](const std::string& text) -> std::optional<std::regex> {
    return text.empty() ? std::nullopt : std::optional<std::regex>(text);
  };
  return [filter, wanted = matcher(filter.regex),
          unwanted = matcher(filter.regex_to_exclude)](const std::string& topic) {
    const bool is_event = is_service_event(topic);
    const auto& listed = is_event ? filter.services_events : filter.topics;
    if (is_in(is_event ? filter.exclude_service_events : filter.exclude_topics, topic) ||
        (unwanted && std::regex_match(topic, *unwanted))) {
      return false;
    }
    return (listed.empty() && !wanted) || is_in(listed, topic) ||
           (wanted && std::regex_match(topic, *wanted));
  };
}

std::string text_of(const mcap::Texts& texts, const std::string& key) {
  const auto found = texts.find(key);
  return found == texts.end() ? "" : found->second;
}

std::vector<rclcpp::QoS> profiles_of(const mcap::Channel& channel, int version) {
  try {
    return to_rclcpp_qos_vector(text_of(channel.metadata, kProfiles), version);
  } catch (const std::runtime_error& error) {
    RCUTILS_LOG_WARN_NAMED(kLog, "The QoS of topic %s cannot be read: %s", channel.topic.c_str(),
                           error.what());
    return {};
  }
}

std::chrono::time_point<std::chrono::high_resolution_clock> time_point_of(uint64_t ns) {
  return std::chrono::time_point<std::chrono::high_resolution_clock>(
      std::chrono::nanoseconds(static_cast<int64_t>(ns)));
}

}  // namespace

mcap::Reader& McapStorage::reader() const {
  if (!reader_) {
    throw std::runtime_error("the storage is not open for reading");
  }
  return *reader_;
}

mcap::Writer& McapStorage::writer() const {
  if (!writer_) {
    throw std::runtime_error("the storage is not open for writing");
  }
  return *writer_;
}

void McapStorage::open(const StorageOptions& storage_options, IOFlag io_flag) {
  if (io_flag == IOFlag::READ_ONLY) {
    path_ = storage_options.uri;
    reader_ = std::make_unique<mcap::Reader>(path_);
    if (!reader_->damage().empty()) {
      RCUTILS_LOG_WARN_NAMED(kLog, "'%s' cannot be read to its end: %s", path_.c_str(),
                             reader_->damage().c_str());
    }
    begin();
    return;
  }
  path_ = storage_options.uri + ".mcap";
  writer_ = std::make_unique<mcap::Writer>(path_, options_of(storage_options));
}

uint64_t McapStorage::get_bagfile_size() const {
  return reader_ ? reader_->size() : writer_ ? writer_->size() : 0;
}

BagMetadata McapStorage::get_metadata() {
  BagMetadata metadata;
  if (reader_) {
    metadata.version = kOlderVersion;
    for (const mcap::Metadata& one : reader_->metadata(kRecordName)) {
      const std::string text = text_of(one.values, kRecordKey);
      try {
        if (!text.empty()) {
          metadata = parse_metadata(ros2wasm::parse_yaml(text));
        }
      } catch (const std::runtime_error& error) {
        RCUTILS_LOG_WARN_NAMED(kLog, "What the file says of its bag cannot be read: %s",
                               error.what());
      }
      const std::string distro = text_of(one.values, "ROS_DISTRO");
      if (!distro.empty()) {
        metadata.ros_distro = distro;
      }
    }
    const mcap::Statistics& counts = reader_->statistics();
    metadata.message_count = counts.messages;
    metadata.starting_time = time_point_of(counts.first_time);
    metadata.duration = std::chrono::nanoseconds(
        static_cast<int64_t>(counts.last_time - std::min(counts.first_time, counts.last_time)));
    metadata.topics_with_message_count.clear();
    for (const auto& [id, channel] : reader_->channels()) {
      const auto schema = reader_->schemas().find(channel.schema);
      if (schema == reader_->schemas().end()) {
        throw std::runtime_error("Could not find schema for topic " + channel.topic);
      }
      TopicInformation topic;
      topic.topic_metadata.id = id;
      topic.topic_metadata.name = channel.topic;
      topic.topic_metadata.type = schema->second.name;
      topic.topic_metadata.serialization_format = channel.encoding;
      topic.topic_metadata.offered_qos_profiles = profiles_of(channel, metadata.version);
      topic.topic_metadata.type_description_hash = text_of(channel.metadata, kHash);
      const auto count = counts.messages_of.find(id);
      topic.message_count =
          count == counts.messages_of.end() ? 0 : static_cast<size_t>(count->second);
      metadata.topics_with_message_count.push_back(std::move(topic));
    }
  }
  metadata.storage_identifier = get_storage_identifier();
  metadata.bag_size = get_bagfile_size();
  metadata.relative_file_paths = {path_};
  return metadata;
}

bool McapStorage::set_read_order(const ReadOrder& read_order) {
  mcap::Order order = mcap::Order::kFile;
  switch (read_order.sort_by) {
    case ReadOrder::ReceivedTimestamp:
      if (!reader().can_sort()) {
        RCUTILS_LOG_WARN_NAMED(
            kLog, "attempted to read in receive timestamp order with no message index");
        return false;
      }
      order = read_order.reverse ? mcap::Order::kTimeReversed : mcap::Order::kTime;
      break;
    case ReadOrder::File:
      if (read_order.reverse) {
        // ROS 2's own storage refuses it too, and published times below, in these words.
        RCUTILS_LOG_WARN_NAMED(kLog, "reverse file-order reading not implemented");
        return false;
      }
      break;
    case ReadOrder::PublishedTimestamp:
      RCUTILS_LOG_WARN_NAMED(kLog, "publish timestamp order reading not implemented");
      return false;
  }
  order_ = order;
  begin();
  return true;
}

void McapStorage::begin() {
  mcap::ReadQuestion question;
  question.order = order_;
  const auto time = static_cast<uint64_t>(std::max<int64_t>(0, time_));
  if (order_ == mcap::Order::kTimeReversed) {
    question.last_time = time;
  } else {
    question.first_time = time;
  }
  question.wants = [is_wanted = wanted_by(filter_)](const mcap::Channel& channel) {
    return is_wanted(channel.topic);
  };
  next_.reset();
  reader().begin(std::move(question));
}

bool McapStorage::is_known(const mcap::ReadMessage& message) const {
  if (!place_ || message.log_time != static_cast<uint64_t>(time_)) {
    return false;
  }
  return order_ == mcap::Order::kTimeReversed ? message.place >= *place_ : message.place <= *place_;
}

bool McapStorage::has_next() {
  while (!next_) {
    next_ = reader().next();
    if (!next_) {
      return false;
    }
    if (is_known(*next_)) {
      next_.reset();
    }
  }
  return true;
}

std::shared_ptr<SerializedBagMessage> McapStorage::read_next() {
  if (!has_next()) {
    throw std::runtime_error("No next message is available.");
  }
  auto message = std::make_shared<SerializedBagMessage>();
  message->recv_timestamp = static_cast<int64_t>(next_->log_time);
  message->send_timestamp = static_cast<int64_t>(next_->publish_time);
  message->topic_name = next_->channel->topic;
  message->serialized_data = make_serialized_message(next_->data.data(), next_->data.size());
  time_ = message->recv_timestamp;
  place_ = next_->place;
  next_.reset();
  return message;
}

std::vector<TopicMetadata> McapStorage::get_all_topics_and_types() {
  std::vector<TopicMetadata> topics;
  for (TopicInformation& topic : get_metadata().topics_with_message_count) {
    topics.push_back(std::move(topic.topic_metadata));
  }
  return topics;
}

void McapStorage::get_all_message_definitions(std::vector<MessageDefinition>& definitions) {
  definitions.clear();
  for (const auto& [id, schema] : reader().schemas()) {
    definitions.push_back({schema.name, schema.encoding, schema.data, ""});
  }
}

void McapStorage::set_filter(const StorageFilter& storage_filter) {
  filter_ = storage_filter;
  begin();
}

void McapStorage::reset_filter() {
  set_filter({});
}

void McapStorage::seek(const rcutils_time_point_value_t& timestamp) {
  if (timestamp != time_) {
    place_.reset();
  }
  time_ = timestamp;
  begin();
}

void McapStorage::write(std::shared_ptr<const SerializedBagMessage> msg) {
  const auto channel = channels_.find(msg->topic_name);
  if (channel == channels_.end()) {
    throw std::runtime_error("Unknown message topic \"" + msg->topic_name + "\"");
  }
  if (msg->recv_timestamp < 0) {
    RCUTILS_LOG_WARN_NAMED(kLog, "Invalid message timestamp %lld",
                           static_cast<long long>(msg->recv_timestamp));
  }
  mcap::MessageRecord message;
  message.channel = channel->second;
  message.log_time = static_cast<uint64_t>(msg->recv_timestamp);
  message.publish_time = static_cast<uint64_t>(msg->send_timestamp);
  message.data = {reinterpret_cast<const char*>(msg->serialized_data->buffer),
                  msg->serialized_data->buffer_length};
  writer().write(message);
}

void McapStorage::write(const std::vector<std::shared_ptr<const SerializedBagMessage>>& msgs) {
  for (const auto& msg : msgs) {
    write(msg);
  }
}

void McapStorage::update_metadata(const BagMetadata& bag_metadata) {
  if (bag_metadata.compression_mode == "message") {
    throw std::runtime_error("MCAP storage plugin does not support message compression");
  }
  writer().write(mcap::Metadata{kRecordName, {{kRecordKey, metadata_yaml(bag_metadata, "")}}});
}

void McapStorage::create_topic(const TopicMetadata& topic,
                               const MessageDefinition& message_definition) {
  if (channels_.count(topic.name) != 0) {
    RCUTILS_LOG_WARN_NAMED(kLog, "Topic with name: %s already exist!", topic.name.c_str());
    return;
  }
  auto schema = schemas_.find(topic.type);
  if (schema == schemas_.end()) {
    const uint16_t id = writer().add_schema({0, topic.type, message_definition.encoding,
                                             message_definition.encoded_message_definition});
    schema = schemas_.emplace(topic.type, id).first;
  }
  channels_[topic.name] =
      writer().add_channel({0,
                            schema->second,
                            topic.name,
                            topic.serialization_format,
                            {{kProfiles, serialize_rclcpp_qos_vector(topic.offered_qos_profiles)},
                             {kHash, topic.type_description_hash}}});
}

/// The messages of the topic that were written stay in the bag.
void McapStorage::remove_topic(const TopicMetadata& topic) {
  channels_.erase(topic.name);
}

uint64_t McapStorage::get_minimum_split_file_size() const {
  constexpr uint64_t kLeast = 1024;
  return kLeast;
}

}  // namespace rosbag2_storage
