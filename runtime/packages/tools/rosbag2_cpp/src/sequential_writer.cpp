// See sequential_writer.hpp.
#include "rosbag2_cpp/writers/sequential_writer.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "formats.hpp"
#include "rcutils/logging_macros.h"
#include "ros2wasm/files.hpp"
#include "rosbag2_storage/default_storage_id.hpp"

namespace rosbag2_cpp {
namespace writers {
namespace {

namespace fs = std::filesystem;
using TimePoint = std::chrono::time_point<std::chrono::high_resolution_clock>;
using rosbag2_storage::storage_interfaces::MAX_BAGFILE_DURATION_NO_SPLIT;
using rosbag2_storage::storage_interfaces::MAX_BAGFILE_SIZE_NO_SPLIT;

constexpr char kLog[] = "rosbag2_cpp";
constexpr char kNotOpen[] = "Bag is not open. Call open() before writing.";

TimePoint at(int64_t ns) {
  return TimePoint(std::chrono::nanoseconds(ns));
}

std::string name_of(const std::string& path) {
  return fs::path(path).filename().generic_string();
}

}  // namespace

SequentialWriter::SequentialWriter(
    std::unique_ptr<rosbag2_storage::StorageFactoryInterface> storage_factory,
    std::unique_ptr<rosbag2_storage::MetadataIo> metadata_io)
    : storage_factory_(std::move(storage_factory)), metadata_io_(std::move(metadata_io)) {}

SequentialWriter::~SequentialWriter() {
  // The objects that the callbacks refer to may be gone.
  callbacks_.clear();
  try {
    SequentialWriter::close();
  } catch (const std::exception& error) {
    RCUTILS_LOG_ERROR_NAMED(kLog, "The bag could not be closed: %s", error.what());
  }
}

void SequentialWriter::open(const rosbag2_storage::StorageOptions& storage_options,
                            const ConverterOptions& converter_options) {
  if (is_open_) {
    return;
  }
  if (converter_options.input_serialization_format !=
      converter_options.output_serialization_format) {
    need_converter(converter_options.input_serialization_format);
    need_converter(converter_options.output_serialization_format);
  }
  folder_ = storage_options.uri;
  options_ = storage_options;
  if (options_.storage_id.empty()) {
    options_.storage_id = rosbag2_storage::get_default_storage_id();
  }
  if (fs::is_directory(folder_)) {
    throw std::runtime_error("Bag directory already exists (" + folder_ +
                             "), can't overwrite existing bag");
  }
  if (!fs::create_directories(folder_)) {
    throw std::runtime_error("Failed to create bag directory (" + folder_ + ").");
  }
  metadata_ = {};
  has_messages_ = false;
  begin_file();
  const uint64_t least = storage_->get_minimum_split_file_size();
  if (options_.max_bagfile_size != MAX_BAGFILE_SIZE_NO_SPLIT && options_.max_bagfile_size < least) {
    throw std::runtime_error(
        "Invalid bag splitting size given. Please provide a value greater than " +
        std::to_string(least) + ". Specified value of " +
        std::to_string(options_.max_bagfile_size));
  }
  if (options_.snapshot_mode && options_.max_cache_size == 0) {
    throw std::runtime_error("Max cache size must be greater than 0 when snapshot mode is enabled");
  }
  metadata_.storage_identifier = storage_->get_storage_identifier();
  metadata_.starting_time = TimePoint(std::chrono::nanoseconds::max());
  metadata_.custom_data = options_.custom_data;
  const char* const distro = std::getenv("ROS_DISTRO");
  metadata_.ros_distro = distro == nullptr ? "" : distro;
  if (metadata_.ros_distro.empty()) {
    RCUTILS_LOG_WARN_NAMED(
        kLog, "Environment variable ROS_DISTRO not set, can't store value in bag metadata.");
  }
  storage_->update_metadata(metadata_);
  is_open_ = true;
}

void SequentialWriter::begin_file() {
  rosbag2_storage::StorageOptions options = options_;
  const std::string number = std::to_string(metadata_.files.size());
  options.uri = (fs::path(folder_) / (name_of(folder_) + "_" + number)).generic_string();
  storage_ = storage_factory_->open_read_write(options);
  if (!storage_) {
    throw std::runtime_error(metadata_.files.empty()
                                 ? "No storage could be initialized. Abort"
                                 : "Failed to rollover bagfile to new file: \"" + options.uri +
                                       "\"!");
  }
  rosbag2_storage::FileInformation file;
  file.path = name_of(storage_->get_relative_file_path());
  file.starting_time = TimePoint(std::chrono::nanoseconds::max());
  metadata_.relative_file_paths.push_back(file.path);
  metadata_.files.push_back(std::move(file));
  for (auto& [name, topic] : topics_) {
    topic.is_in_file = false;
  }
}

void SequentialWriter::end_file() {
  for (auto& [name, topic] : topics_) {
    put_into_file(topic);
  }
  storage_->update_metadata(metadata_);
  storage_.reset();
}

void SequentialWriter::close() {
  if (!std::exchange(is_open_, false)) {
    return;
  }
  kept_.clear();
  kept_bytes_ = 0;
  metadata_.message_count = 0;
  metadata_.topics_with_message_count.clear();
  for (const auto& [name, topic] : topics_) {
    metadata_.topics_with_message_count.push_back(topic.information);
    metadata_.message_count += topic.information.message_count;
  }
  end_file();
  topics_.clear();
  metadata_io_->write_metadata(folder_, metadata_);
  const fs::path folder(folder_);
  for (const std::string& path : metadata_.relative_file_paths) {
    ros2wasm::give_file((folder / path).generic_string());
  }
  ros2wasm::give_file((folder / rosbag2_storage::MetadataIo::metadata_filename).generic_string());
  call_back((folder / metadata_.relative_file_paths.back()).generic_string(), "");
}

void SequentialWriter::create_topic(const rosbag2_storage::TopicMetadata& topic_with_type) {
  create(topic_with_type, std::nullopt);
}

void SequentialWriter::create_topic(const rosbag2_storage::TopicMetadata& topic_with_type,
                                    const rosbag2_storage::MessageDefinition& message_definition) {
  create(topic_with_type, message_definition);
}

void SequentialWriter::create(const rosbag2_storage::TopicMetadata& topic,
                              std::optional<rosbag2_storage::MessageDefinition> definition) {
  if (topics_.count(topic.name) != 0) {
    return;
  }
  if (!is_open_) {
    throw std::runtime_error(kNotOpen);
  }
  topics_[topic.name] = {{topic, 0}, std::move(definition), false};
}

void SequentialWriter::remove_topic(const rosbag2_storage::TopicMetadata& topic_with_type) {
  if (!is_open_) {
    throw std::runtime_error("Bag is not open. Call open() before removing.");
  }
  const auto found = topics_.find(topic_with_type.name);
  if (found == topics_.end()) {
    throw std::runtime_error("Failed to remove the non-existing topic \"" + topic_with_type.name +
                             "\"!");
  }
  if (found->second.is_in_file) {
    storage_->remove_topic(topic_with_type);
  }
  topics_.erase(found);
}

void SequentialWriter::put_into_file(Topic& topic) {
  if (std::exchange(topic.is_in_file, true)) {
    return;
  }
  const rosbag2_storage::TopicMetadata& of = topic.information.topic_metadata;
  if (!topic.definition) {
    try {
      topic.definition = definitions_.get_full_text(of.type);
    } catch (const DefinitionNotFoundError& missing) {
      RCUTILS_LOG_WARN_NAMED(kLog, "The program has no definition of %s, so that the bag has none",
                             missing.what());
      topic.definition = rosbag2_storage::MessageDefinition::empty_message_definition_for(of.type);
    }
  }
  storage_->create_topic(of, *topic.definition);
}

void SequentialWriter::count(const rosbag2_storage::SerializedBagMessage& message) {
  rosbag2_storage::FileInformation& file = metadata_.files.back();
  const TimePoint time = at(message.recv_timestamp);
  metadata_.starting_time = std::min(metadata_.starting_time, time);
  file.starting_time = std::min(file.starting_time, time);
  const auto since = [&](TimePoint begin) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(time - begin);
  };
  metadata_.duration = std::max(metadata_.duration, since(metadata_.starting_time));
  file.duration = std::max(file.duration, since(file.starting_time));
  ++file.message_count;
}

bool SequentialWriter::must_split(rcutils_time_point_value_t time) const {
  const rosbag2_storage::FileInformation& file = metadata_.files.back();
  if (options_.max_bagfile_size != MAX_BAGFILE_SIZE_NO_SPLIT &&
      storage_->get_bagfile_size() >= options_.max_bagfile_size) {
    return true;
  }
  return options_.max_bagfile_duration != MAX_BAGFILE_DURATION_NO_SPLIT && file.message_count > 0 &&
         at(time) - file.starting_time > std::chrono::seconds(options_.max_bagfile_duration);
}

void SequentialWriter::write(std::shared_ptr<const rosbag2_storage::SerializedBagMessage> message) {
  if (!is_open_) {
    throw std::runtime_error(kNotOpen);
  }
  const rcutils_time_point_value_t time = message->recv_timestamp;
  if ((options_.start_time_ns >= 0 && time < options_.start_time_ns) ||
      (options_.end_time_ns >= 0 && time > options_.end_time_ns)) {
    return;
  }
  if (topics_.count(message->topic_name) == 0) {
    throw std::runtime_error("Failed to write on topic '" + message->topic_name +
                             "'. Call create_topic() before first write.");
  }
  if (!options_.snapshot_mode) {
    write_now(message);
    return;
  }
  kept_bytes_ += message->serialized_data->buffer_length;
  kept_.push_back(std::move(message));
  while (kept_bytes_ > options_.max_cache_size && kept_.size() > 1) {
    kept_bytes_ -= kept_.front()->serialized_data->buffer_length;
    kept_.pop_front();
  }
}

void SequentialWriter::write_now(const Message& message) {
  if (must_split(message->recv_timestamp)) {
    split_bagfile();
  }
  Topic& topic = topics_.at(message->topic_name);
  put_into_file(topic);
  storage_->write(message);
  count(*message);
  ++topic.information.message_count;
}

bool SequentialWriter::take_snapshot() {
  if (!options_.snapshot_mode) {
    RCUTILS_LOG_WARN_NAMED(kLog,
                           "SequentialWriter take_snaphot called when snapshot mode is disabled");
    return false;
  }
  for (const Message& message : kept_) {
    // Its topic may have been removed.
    if (topics_.count(message->topic_name) != 0) {
      write_now(message);
    }
  }
  kept_.clear();
  kept_bytes_ = 0;
  return true;
}

void SequentialWriter::split_bagfile() {
  if (!is_open_) {
    throw std::runtime_error(kNotOpen);
  }
  const std::string closed = storage_->get_relative_file_path();
  end_file();
  begin_file();
  storage_->update_metadata(metadata_);
  call_back(closed, storage_->get_relative_file_path());
}

void SequentialWriter::add_event_callbacks(const bag_events::WriterEventCallbacks& callbacks) {
  if (callbacks.write_split_callback) {
    callbacks_.push_back(callbacks.write_split_callback);
  }
}

void SequentialWriter::call_back(const std::string& closed, const std::string& opened) {
  bag_events::BagSplitInfo info{closed, opened};
  for (const auto& callback : callbacks_) {
    callback(info);
  }
}

}  // namespace writers
}  // namespace rosbag2_cpp
