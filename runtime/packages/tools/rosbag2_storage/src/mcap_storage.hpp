// A file of a bag as MCAP.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mcap/reader.hpp"
#include "mcap/writer.hpp"
#include "rosbag2_storage/storage_interfaces/read_write_interface.hpp"

namespace rosbag2_storage {

class McapStorage : public storage_interfaces::ReadWriteInterface {
 public:
  /// Throws std::runtime_error with the reason when it cannot be opened.
  void open(const StorageOptions& storage_options, storage_interfaces::IOFlag io_flag) override;

  BagMetadata get_metadata() override;
  std::string get_relative_file_path() const override { return path_; }
  uint64_t get_bagfile_size() const override;
  std::string get_storage_identifier() const override { return "mcap"; }

  bool set_read_order(const ReadOrder& read_order) override;
  bool has_next() override;
  std::shared_ptr<SerializedBagMessage> read_next() override;
  std::vector<TopicMetadata> get_all_topics_and_types() override;
  void get_all_message_definitions(std::vector<MessageDefinition>& definitions) override;
  void set_filter(const StorageFilter& storage_filter) override;
  void reset_filter() override;
  void seek(const rcutils_time_point_value_t& timestamp) override;

  void write(std::shared_ptr<const SerializedBagMessage> msg) override;
  void write(const std::vector<std::shared_ptr<const SerializedBagMessage>>& msgs) override;
  void update_metadata(const BagMetadata& bag_metadata) override;
  void create_topic(const TopicMetadata& topic,
                    const MessageDefinition& message_definition) override;
  void remove_topic(const TopicMetadata& topic) override;
  uint64_t get_minimum_split_file_size() const override;

 private:
  mcap::Reader& reader() const;
  mcap::Writer& writer() const;
  /// From the present place on.
  void begin();
  /// Was given before the present place was left?
  bool is_known(const mcap::ReadMessage& message) const;

  std::string path_;
  std::unique_ptr<mcap::Writer> writer_;
  std::map<std::string, uint16_t> schemas_;   ///< of types
  std::map<std::string, uint16_t> channels_;  ///< of topics that may be written

  std::unique_ptr<mcap::Reader> reader_;
  mcap::Order order_ = mcap::Order::kFile;
  StorageFilter filter_;
  rcutils_time_point_value_t time_ = 0;  ///< of the last message that was given, or sought
  std::optional<mcap::Place> place_;     ///< of that message
  std::optional<mcap::ReadMessage> next_;
};

}  // namespace rosbag2_storage
