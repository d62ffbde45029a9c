// Writes a bag: a folder with metadata.yaml and one file after the other. What it has written is
// handed to whoever runs the site when it is closed.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rosbag2_cpp/message_definitions/local_message_definition_source.hpp"
#include "rosbag2_cpp/writer_interfaces/base_writer_interface.hpp"
#include "rosbag2_storage/metadata_io.hpp"
#include "rosbag2_storage/storage_factory.hpp"

namespace rosbag2_cpp {
namespace writers {

class SequentialWriter : public writer_interfaces::BaseWriterInterface {
 public:
  explicit SequentialWriter(
      std::unique_ptr<rosbag2_storage::StorageFactoryInterface> storage_factory =
          std::make_unique<rosbag2_storage::StorageFactory>(),
      std::unique_ptr<rosbag2_storage::MetadataIo> metadata_io =
          std::make_unique<rosbag2_storage::MetadataIo>());
  /// Closes.
  ~SequentialWriter() override;

  void open(const rosbag2_storage::StorageOptions& storage_options,
            const ConverterOptions& converter_options) override;
  void close() override;
  void create_topic(const rosbag2_storage::TopicMetadata& topic_with_type) override;
  void create_topic(const rosbag2_storage::TopicMetadata& topic_with_type,
                    const rosbag2_storage::MessageDefinition& message_definition) override;
  void remove_topic(const rosbag2_storage::TopicMetadata& topic_with_type) override;
  void write(std::shared_ptr<const rosbag2_storage::SerializedBagMessage> message) override;
  bool take_snapshot() override;
  void split_bagfile() override;
  void add_event_callbacks(const bag_events::WriterEventCallbacks& callbacks) override;

 private:
  using Message = std::shared_ptr<const rosbag2_storage::SerializedBagMessage>;

  struct Topic {
    rosbag2_storage::TopicInformation information;
    /// Nothing: what the program knows of the type when the topic is first written.
    std::optional<rosbag2_storage::MessageDefinition> definition;
    bool is_in_file = false;
  };

  void create(const rosbag2_storage::TopicMetadata& topic,
              std::optional<rosbag2_storage::MessageDefinition> definition);
  void begin_file();
  /// It has all topics then.
  void end_file();
  void put_into_file(Topic& topic);
  void count(const rosbag2_storage::SerializedBagMessage& message);
  void write_now(const Message& message);
  bool must_split(rcutils_time_point_value_t time) const;
  void call_back(const std::string& closed, const std::string& opened);

  std::unique_ptr<rosbag2_storage::StorageFactoryInterface> storage_factory_;
  std::unique_ptr<rosbag2_storage::MetadataIo> metadata_io_;
  LocalMessageDefinitionSource definitions_;
  bool is_open_ = false;
  std::string folder_;
  rosbag2_storage::StorageOptions options_;
  std::shared_ptr<rosbag2_storage::storage_interfaces::ReadWriteInterface> storage_;
  std::map<std::string, Topic> topics_;
  rosbag2_storage::BagMetadata metadata_;
  bool has_messages_ = false;
  /// For a snapshot, the oldest first.
  std::deque<Message> kept_;
  uint64_t kept_bytes_ = 0;
  std::vector<bag_events::BagSplitCallbackType> callbacks_;
};

}  // namespace writers
}  // namespace rosbag2_cpp
