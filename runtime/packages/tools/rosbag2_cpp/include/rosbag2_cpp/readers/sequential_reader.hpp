// Reads a bag: a folder with metadata.yaml, one file after the other, or a file by itself.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rosbag2_cpp/reader_interfaces/base_reader_interface.hpp"
#include "rosbag2_storage/metadata_io.hpp"
#include "rosbag2_storage/storage_factory.hpp"

namespace rosbag2_cpp {
namespace readers {

class SequentialReader : public reader_interfaces::BaseReaderInterface {
 public:
  explicit SequentialReader(
      std::unique_ptr<rosbag2_storage::StorageFactoryInterface> storage_factory =
          std::make_unique<rosbag2_storage::StorageFactory>(),
      std::unique_ptr<rosbag2_storage::MetadataIo> metadata_io =
          std::make_unique<rosbag2_storage::MetadataIo>());

  void open(const rosbag2_storage::StorageOptions& storage_options,
            const ConverterOptions& converter_options) override;
  void close() override;
  bool set_read_order(const rosbag2_storage::ReadOrder& order) override;
  bool has_next() override;
  std::shared_ptr<rosbag2_storage::SerializedBagMessage> read_next() override;
  const rosbag2_storage::BagMetadata& get_metadata() const override;
  std::vector<rosbag2_storage::TopicMetadata> get_all_topics_and_types() const override;
  void get_all_message_definitions(
      std::vector<rosbag2_storage::MessageDefinition>& definitions) override;
  void set_filter(const rosbag2_storage::StorageFilter& storage_filter) override;
  void reset_filter() override;
  void seek(const rcutils_time_point_value_t& timestamp) override;
  void add_event_callbacks(const bag_events::ReaderEventCallbacks& callbacks) override;

  virtual bool has_next_file() const;
  virtual bool has_prev_file() const;
  virtual std::string get_current_file() const;
  /// Its name without the ending.
  virtual std::string get_current_uri() const;

 private:
  void open_file(size_t index);
  void go_to_file(size_t index);

  std::unique_ptr<rosbag2_storage::StorageFactoryInterface> storage_factory_;
  std::unique_ptr<rosbag2_storage::MetadataIo> metadata_io_;
  rosbag2_storage::StorageOptions options_;
  std::shared_ptr<rosbag2_storage::storage_interfaces::ReadOnlyInterface> storage_;
  rosbag2_storage::BagMetadata metadata_;
  std::vector<std::string> files_;
  size_t file_ = 0;
  rosbag2_storage::ReadOrder order_;
  rosbag2_storage::StorageFilter filter_;
  rcutils_time_point_value_t seek_time_ = 0;
  std::vector<bag_events::BagSplitCallbackType> callbacks_;
};

}  // namespace readers
}  // namespace rosbag2_cpp
