// The records of MCAP files, of version 0 of the format, as values. See https://mcap.dev/spec.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bytes.hpp"

namespace rosbag2_storage::mcap {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
/// Kind and length, before each record.
inline constexpr uint64_t kRecordHead = 9;

enum class Kind : uint8_t {
  kHeader = 1,
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kMessageIndex = 7,
  kChunkIndex = 8,
  kStatistics = 11,
  kMetadata = 12,
  kMetadataIndex = 13,
  kSummaryOffset = 14,
  kDataEnd = 15
};

struct Schema {
  uint16_t id = 0;
  std::string name;
  std::string encoding;
  std::string data;
};

struct Channel {
  uint16_t id = 0;
  uint16_t schema = 0;
  std::string topic;
  std::string encoding;
  Texts metadata;
};

/// `data` lies where the record does.
struct MessageRecord {
  uint16_t channel = 0;
  uint32_t sequence = 0;
  uint64_t log_time = 0;
  uint64_t publish_time = 0;
  std::string_view data;
};

/// The values of a chunk's head, and the place of its record in the file.
struct ChunkPlace {
  uint64_t first_time = 0;
  uint64_t last_time = 0;
  uint64_t offset = 0;
  uint64_t length = 0;
  std::map<uint16_t, uint64_t> message_indexes;
  uint64_t message_indexes_length = 0;
  std::string compression;
  uint64_t compressed_size = 0;
  uint64_t size = 0;
};

struct ChunkHead {
  uint64_t first_time = 0;
  uint64_t last_time = 0;
  uint64_t size = 0;
  uint32_t crc = 0;
  std::string compression;
  uint64_t compressed_size = 0;
};

struct Statistics {
  uint64_t messages = 0;
  uint16_t schemas = 0;
  uint32_t channels = 0;
  uint32_t attachments = 0;
  uint32_t metadata = 0;
  uint32_t chunks = 0;
  uint64_t first_time = 0;
  uint64_t last_time = 0;
  std::map<uint16_t, uint64_t> messages_of;
};

struct Metadata {
  std::string name;
  Texts values;
};

struct MetadataPlace {
  uint64_t offset = 0;
  uint64_t length = 0;
  std::string name;
};

/// Behind its head. Throw Damaged.
[[nodiscard]] Schema read_schema(std::string_view record);
[[nodiscard]] Channel read_channel(std::string_view record);
[[nodiscard]] MessageRecord read_message(std::string_view record);
/// Reads the head from a chunk's whole record, or from the first bytes of it.
[[nodiscard]] ChunkHead read_chunk_head(ByteReader& record);
[[nodiscard]] ChunkPlace read_chunk_place(std::string_view record);
[[nodiscard]] Statistics read_statistics(std::string_view record);
[[nodiscard]] Metadata read_metadata(std::string_view record);
[[nodiscard]] MetadataPlace read_metadata_place(std::string_view record);

/// With their heads.
[[nodiscard]] std::string record(Kind kind, std::string_view content);
[[nodiscard]] std::string bytes_of(const Schema& schema);
[[nodiscard]] std::string bytes_of(const Channel& channel);
[[nodiscard]] std::string bytes_of(const MessageRecord& message);
[[nodiscard]] std::string bytes_of(const ChunkPlace& chunk);
[[nodiscard]] std::string bytes_of(const Statistics& statistics);
[[nodiscard]] std::string bytes_of(const Metadata& metadata);
[[nodiscard]] std::string bytes_of(const MetadataPlace& place);

/// The CRC of IEEE 802.3, as in zlib. `before`: the CRC of the bytes before these.
[[nodiscard]] uint32_t crc32(std::string_view bytes, uint32_t before = 0);

}  // namespace rosbag2_storage::mcap
