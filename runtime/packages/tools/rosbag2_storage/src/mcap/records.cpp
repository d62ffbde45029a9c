// See records.hpp.
#include "records.hpp"

#include <array>

namespace rosbag2_storage::mcap {
namespace {

using Numbers = std::map<uint16_t, uint64_t>;

Numbers read_numbers(ByteReader& from) {
  Numbers found;
  for (ByteReader all = from.list(); !all.at_end();) {
    const auto key = all.number<uint16_t>();
    found[key] = all.number<uint64_t>();
  }
  return found;
}

std::string bytes_of_numbers(const Numbers& numbers) {
  ByteWriter all;
  for (const auto& [key, value] : numbers) {
    all.number(key).number(value);
  }
  return all.bytes;
}

}  // namespace

Schema read_schema(std::string_view record) {
  ByteReader from(record);
  Schema schema;
  schema.id = from.number<uint16_t>();
  schema.name = from.string();
  schema.encoding = from.string();
  schema.data = from.string();
  return schema;
}

Channel read_channel(std::string_view record) {
  ByteReader from(record);
  Channel channel;
  channel.id = from.number<uint16_t>();
  channel.schema = from.number<uint16_t>();
  channel.topic = from.string();
  channel.encoding = from.string();
  channel.metadata = from.texts();
  return channel;
}

MessageRecord read_message(std::string_view record) {
  constexpr size_t kHead = 22;
  ByteReader from(record);
  MessageRecord message;
  message.channel = from.number<uint16_t>();
  message.sequence = from.number<uint32_t>();
  message.log_time = from.number<uint64_t>();
  message.publish_time = from.number<uint64_t>();
  message.data = record.substr(kHead);
  return message;
}

ChunkHead read_chunk_head(ByteReader& record) {
  ChunkHead head;
  head.first_time = record.number<uint64_t>();
  head.last_time = record.number<uint64_t>();
  head.size = record.number<uint64_t>();
  head.crc = record.number<uint32_t>();
  head.compression = record.string();
  head.compressed_size = record.number<uint64_t>();
  return head;
}

ChunkPlace read_chunk_place(std::string_view record) {
  ByteReader from(record);
  ChunkPlace chunk;
  chunk.first_time = from.number<uint64_t>();
  chunk.last_time = from.number<uint64_t>();
  chunk.offset = from.number<uint64_t>();
  chunk.length = from.number<uint64_t>();
  chunk.message_indexes = read_numbers(from);
  chunk.message_indexes_length = from.number<uint64_t>();
  chunk.compression = from.string();
  chunk.compressed_size = from.number<uint64_t>();
  chunk.size = from.number<uint64_t>();
  return chunk;
}

Statistics read_statistics(std::string_view record) {
  ByteReader from(record);
  Statistics all;
  all.messages = from.number<uint64_t>();
  all.schemas = from.number<uint16_t>();
  all.channels = from.number<uint32_t>();
  all.attachments = from.number<uint32_t>();
  all.metadata = from.number<uint32_t>();
  all.chunks = from.number<uint32_t>();
  all.first_time = from.number<uint64_t>();
  all.last_time = from.number<uint64_t>();
  all.messages_of = read_numbers(from);
  return all;
}

Metadata read_metadata(std::string_view record) {
  ByteReader from(record);
  Metadata metadata;
  metadata.name = from.string();
  metadata.values = from.texts();
  return metadata;
}

MetadataPlace read_metadata_place(std::string_view record) {
  ByteReader from(record);
  MetadataPlace place;
  place.offset = from.number<uint64_t>();
  place.length = from.number<uint64_t>();
  place.name = from.string();
  return place;
}

std::string record(Kind kind, std::string_view content) {
  ByteWriter to;
  to.number(static_cast<uint8_t>(kind)).number(static_cast<uint64_t>(content.size()));
  to.bytes.append(content);
  return to.bytes;
}

std::string bytes_of(const Schema& schema) {
  ByteWriter to;
  to.number(schema.id).text(schema.name).text(schema.encoding).text(schema.data);
  return record(Kind::kSchema, to.bytes);
}

std::string bytes_of(const Channel& channel) {
  ByteWriter to;
  to.number(channel.id).number(channel.schema).text(channel.topic).text(channel.encoding);
  to.texts(channel.metadata);
  return record(Kind::kChannel, to.bytes);
}

std::string bytes_of(const MessageRecord& message) {
  ByteWriter to;
  to.number(message.channel).number(message.sequence);
  to.number(message.log_time).number(message.publish_time);
  to.bytes.append(message.data);
  return record(Kind::kMessage, to.bytes);
}

std::string bytes_of(const ChunkPlace& chunk) {
  ByteWriter to;
  to.number(chunk.first_time).number(chunk.last_time).number(chunk.offset).number(chunk.length);
  to.text(bytes_of_numbers(chunk.message_indexes)).number(chunk.message_indexes_length);
  to.text(chunk.compression).number(chunk.compressed_size).number(chunk.size);
  return record(Kind::kChunkIndex, to.bytes);
}

std::string bytes_of(const Statistics& all) {
  ByteWriter to;
  to.number(all.messages).number(all.schemas).number(all.channels).number(all.attachments);
  to.number(all.metadata).number(all.chunks).number(all.first_time).number(all.last_time);
  to.text(bytes_of_numbers(all.messages_of));
  return record(Kind::kStatistics, to.bytes);
}

std::string bytes_of(const Metadata& metadata) {
  ByteWriter to;
  to.text(metadata.name).texts(metadata.values);
  return record(Kind::kMetadata, to.bytes);
}

std::string bytes_of(const MetadataPlace& place) {
  ByteWriter to;
  to.number(place.offset).number(place.length).text(place.name);
  return record(Kind::kMetadataIndex, to.bytes);
}

uint32_t crc32(std::string_view bytes, uint32_t before) {
  static const std::array<uint32_t, 256> table = [] {
    std::array<uint32_t, 256> made{};
    for (uint32_t i = 0; i < made.size(); ++i) {
      uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) {
        value = (value & 1) != 0 ? 0xEDB88320u ^ (value >> 1) : value >> 1;
      }
      made[i] = value;
    }
    return made;
  }();
  uint32_t crc = ~before;
  for (const char one : bytes) {
    crc = table[(crc ^ static_cast<uint8_t>(one)) & 0xFF] ^ (crc >> 8);
  }
  return ~crc;
}

}  // namespace rosbag2_storage::mcap
