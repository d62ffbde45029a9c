// See sequential_reader.hpp.
#include "rosbag2_cpp/readers/sequential_reader.hpp"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "formats.hpp"
#include "rcpputils/asserts.hpp"
#include "rcutils/logging_macros.h"

namespace rosbag2_cpp {
namespace readers {
namespace {

namespace fs = std::filesystem;

constexpr char kLog[] = "rosbag2_cpp";
constexpr char kNotOpen[] = "Bag is not open. Call open() before reading.";

std::vector<std::string> files_of(const std::string& folder,
                                  const rosbag2_storage::BagMetadata& metadata) {
  // Older bags name their folder, too.
  const fs::path base = metadata.version < 4 ? fs::path(folder).parent_path() : fs::path(folder);
  std::vector<std::string> files;
  for (const std::string& path : metadata.relative_file_paths) {
    files.push_back(fs::path(path).is_absolute() ? path : (base / path).generic_string());
  }
  return files;
}

}  // namespace

SequentialReader::SequentialReader(
    std::unique_ptr<rosbag2_storage::StorageFactoryInterface> storage_factory,
    std::unique_ptr<rosbag2_storage::MetadataIo> metadata_io)
    : storage_factory_(std::move(storage_factory)), metadata_io_(std::move(metadata_io)) {}

void SequentialReader::close() {
  storage_.reset();
}

void SequentialReader::open(const rosbag2_storage::StorageOptions& storage_options,
                            const ConverterOptions& converter_options) {
  options_ = storage_options;
  seek_time_ = 0;
  if (metadata_io_->metadata_file_exists(storage_options.uri)) {
    metadata_ = metadata_io_->read_metadata(storage_options.uri);
    if (options_.storage_id.empty()) {
      options_.storage_id = metadata_.storage_identifier;
    }
    if (!metadata_.compression_format.empty()) {
      throw std::runtime_error("bags that are compressed by file or message (" +
                               metadata_.compression_format +
                               ") are not read in a site: `ros2 bag convert` makes another one");
    }
    files_ = files_of(storage_options.uri, metadata_);
    if (files_.empty()) {
      RCUTILS_LOG_WARN_NAMED(kLog, "No file paths were found in metadata.");
      return;
    }
    open_file(0);
  } else {
    storage_ = storage_factory_->open_read_only(options_);
    if (!storage_) {
      throw std::runtime_error("No storage could be initialized from the inputs.");
    }
    if (!set_read_order(order_)) {
      RCUTILS_LOG_WARN_NAMED(kLog,
                             "Could not set read order on open(), falling back to file order");
      if (!set_read_order({rosbag2_storage::ReadOrder::File, false})) {
        throw std::runtime_error("Could not set read order on open()");
      }
    }
    metadata_ = storage_->get_metadata();
    files_ = metadata_.relative_file_paths;
    file_ = 0;
  }
  const auto& topics = metadata_.topics_with_message_count;
  if (topics.empty()) {
    RCUTILS_LOG_WARN_NAMED(kLog, "No topics were listed in metadata.");
    return;
  }
  const std::string& format = topics.front().topic_metadata.serialization_format;
  for (const auto& topic : topics) {
    if (topic.topic_metadata.serialization_format != format) {
      throw std::runtime_error(
          "Topics with different rmw serialization format have been found. All topics must have "
          "the same serialization format.");
    }
  }
  const std::string& wanted = converter_options.output_serialization_format;
  if (!wanted.empty() && wanted != format) {
    need_converter(format);
    need_converter(wanted);
  }
}

void SequentialReader::open_file(size_t index) {
  file_ = index;
  rosbag2_storage::StorageOptions options = options_;
  options.uri = files_[index];
  storage_ = storage_factory_->open_read_only(options);
  if (!storage_) {
    throw std::runtime_error("No storage could be initialized. Abort");
  }
  storage_->set_read_order(order_);
  storage_->seek(seek_time_);
  storage_->set_filter(filter_);
}

void SequentialReader::go_to_file(size_t index) {
  bag_events::BagSplitInfo info{get_current_file(), files_[index]};
  open_file(index);
  for (const auto& callback : callbacks_) {
    callback(info);
  }
}

bool SequentialReader::set_read_order(const rosbag2_storage::ReadOrder& order) {
  if (!storage_) {
    throw std::runtime_error("read order can only be set after open()");
  }
  order_ = order;
  return storage_->set_read_order(order_);
}

bool SequentialReader::has_next() {
  if (!storage_) {
    throw std::runtime_error(kNotOpen);
  }
  while (!storage_->has_next()) {
    if (order_.reverse ? !has_prev_file() : !has_next_file()) {
      return false;
    }
    go_to_file(order_.reverse ? file_ - 1 : file_ + 1);
  }
  return true;
}

std::shared_ptr<rosbag2_storage::SerializedBagMessage> SequentialReader::read_next() {
  if (!has_next()) {
    throw std::runtime_error("Bag is at end. No next message.");
  }
  return storage_->read_next();
}

const rosbag2_storage::BagMetadata& SequentialReader::get_metadata() const {
  rcpputils::check_true(storage_ != nullptr, kNotOpen);
  return metadata_;
}

std::vector<rosbag2_storage::TopicMetadata> SequentialReader::get_all_topics_and_types() const {
  rcpputils::check_true(storage_ != nullptr, kNotOpen);
  std::vector<rosbag2_storage::TopicMetadata> topics;
  for (const auto& topic : metadata_.topics_with_message_count) {
    topics.push_back(topic.topic_metadata);
  }
  return topics;
}

void SequentialReader::get_all_message_definitions(
    std::vector<rosbag2_storage::MessageDefinition>& definitions) {
  rcpputils::check_true(storage_ != nullptr, kNotOpen);
  storage_->get_all_message_definitions(definitions);
}

void SequentialReader::set_filter(const rosbag2_storage::StorageFilter& storage_filter) {
  filter_ = storage_filter;
  if (!storage_) {
    throw std::runtime_error("Bag is not open. Call open() before setting filter.");
  }
  storage_->set_filter(filter_);
}

void SequentialReader::reset_filter() {
  set_filter({});
}

void SequentialReader::seek(const rcutils_time_point_value_t& timestamp) {
  seek_time_ = timestamp;
  if (!storage_) {
    throw std::runtime_error("Bag is not open. Call open() before seeking time.");
  }
  const auto ns = [](auto time) { return time.time_since_epoch().count(); };
  const auto begins = [&] { return ns(storage_->get_metadata().starting_time); };
  const auto ends = [&] {
    const auto metadata = storage_->get_metadata();
    return ns(metadata.starting_time + metadata.duration);
  };
  // One way only: files may overlap.
  if (timestamp < begins() && has_prev_file()) {
    while (timestamp < begins() && has_prev_file()) {
      go_to_file(file_ - 1);
    }
  } else {
    while (timestamp > ends() && has_next_file()) {
      go_to_file(file_ + 1);
    }
  }
  storage_->seek(timestamp);
}

void SequentialReader::add_event_callbacks(const bag_events::ReaderEventCallbacks& callbacks) {
  if (callbacks.read_split_callback) {
    callbacks_.push_back(callbacks.read_split_callback);
  }
}

bool SequentialReader::has_next_file() const {
  return file_ + 1 < files_.size();
}

bool SequentialReader::has_prev_file() const {
  return file_ > 0;
}

std::string SequentialReader::get_current_file() const {
  return files_.at(file_);
}

std::string SequentialReader::get_current_uri() const {
  return fs::path(get_current_file()).stem().generic_string();
}

}  // namespace readers
}  // namespace rosbag2_cpp
