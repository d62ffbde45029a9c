// See writer.hpp.
#include "writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rosbag2_storage::mcap {
namespace {

constexpr uint16_t kMostIds = UINT16_MAX;

/// Was it out? It is from now on.
bool note(std::vector<bool>& out, uint16_t id) {
  if (out.size() <= id) {
    out.resize(id + 1u);
  }
  const bool before = out[id];
  out[id] = true;
  return before;
}

template <typename T>
uint16_t add(std::map<uint16_t, T>& all, T one) {
  if (all.size() >= kMostIds) {
    throw std::runtime_error("an MCAP file has no room for more topics");
  }
  // 0 is not a schema.
  one.id = static_cast<uint16_t>(all.size() + 1);
  const uint16_t id = one.id;
  all.emplace(id, std::move(one));
  return id;
}

}  // namespace

Writer::Writer(const std::string& path, const WriterOptions& options)
    : file_(path, std::ios::binary | std::ios::trunc), options_(options) {
  if (!file_.is_open()) {
    throw std::runtime_error("failed to open \"" + path + "\" for writing");
  }
  ByteWriter header;
  header.text("ros2").text("ros2wasm");
  out(kMagic);
  out(record(Kind::kHeader, header.bytes));
}

Writer::~Writer() {
  try {
    close();
  } catch (const std::exception&) {
    // A caller that needs the error calls close() itself.
  }
}

void Writer::out(std::string_view bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_) {
    throw std::runtime_error("there is no room for more of the file");
  }
  written_ += bytes.size();
}

uint16_t Writer::add_schema(Schema schema) {
  return add(schemas_, std::move(schema));
}

uint16_t Writer::add_channel(Channel channel) {
  return add(channels_, std::move(channel));
}

void Writer::introduce(Channel& channel, std::string& to) {
  if (note(is_out_[1], channel.id)) {
    return;
  }
  const auto schema = schemas_.find(channel.schema);
  if (schema != schemas_.end() && !note(is_out_[0], channel.schema)) {
    to += bytes_of(schema->second);
  }
  to += bytes_of(channel);
}

void Writer::write(const MessageRecord& message) {
  Channel& channel = channels_.at(message.channel);
  const bool is_first = statistics_.messages == 0;
  if (!options_.chunks) {
    std::string bytes;
    introduce(channel, bytes);
    out(bytes + bytes_of(message));
  } else {
    introduce(channel, chunk_);
    const bool begins = places_.empty();
    first_time_ = begins ? message.log_time : std::min(first_time_, message.log_time);
    last_time_ = begins ? message.log_time : std::max(last_time_, message.log_time);
    places_[message.channel].push_back({message.log_time, chunk_.size()});
    chunk_ += bytes_of(message);
  }
  ++statistics_.messages;
  ++statistics_.messages_of[message.channel];
  const uint64_t time = message.log_time;
  statistics_.first_time = is_first ? time : std::min(statistics_.first_time, time);
  statistics_.last_time = is_first ? time : std::max(statistics_.last_time, time);
  if (chunk_.size() >= options_.chunk_size) {
    end_chunk();
  }
}

void Writer::end_chunk() {
  if (chunk_.empty()) {
    return;
  }
  ChunkPlace place;
  place.first_time = first_time_;
  place.last_time = last_time_;
  place.offset = written_;
  place.size = place.compressed_size = chunk_.size();
  ByteWriter head;
  head.number(place.first_time).number(place.last_time).number(place.size);
  head.number(crc32(chunk_)).text(place.compression).number(place.compressed_size);
  ByteWriter record_head;
  record_head.number(static_cast<uint8_t>(Kind::kChunk));
  record_head.number(static_cast<uint64_t>(head.bytes.size() + chunk_.size()));
  out(record_head.bytes);
  out(head.bytes);
  out(chunk_);
  place.length = written_ - place.offset;
  const uint64_t indexes = written_;
  for (const auto& [channel, messages] : places_) {
    ByteWriter list;
    for (const Place& one : messages) {
      list.number(one.time).number(one.offset);
    }
    ByteWriter index;
    index.number(channel).text(list.bytes);
    place.message_indexes[channel] = written_;
    out(record(Kind::kMessageIndex, index.bytes));
  }
  place.message_indexes_length = written_ - indexes;
  chunks_.push_back(std::move(place));
  ++statistics_.chunks;
  chunk_.clear();
  places_.clear();
}

void Writer::write(const Metadata& metadata) {
  const std::string bytes = bytes_of(metadata);
  metadata_.push_back({written_, bytes.size(), metadata.name});
  ++statistics_.metadata;
  out(bytes);
}

void Writer::close() {
  if (!is_open_) {
    return;
  }
  is_open_ = false;
  end_chunk();
  out(record(Kind::kDataEnd, ByteWriter().number(uint32_t{0}).bytes));
  write_summary();
  out(kMagic);
  file_.close();
  if (!file_) {
    throw std::runtime_error("there is no room for more of the file");
  }
}

void Writer::write_summary() {
  statistics_.schemas = static_cast<uint16_t>(schemas_.size());
  statistics_.channels = static_cast<uint32_t>(channels_.size());
  const uint64_t begin = written_;
  std::string summary;
  std::string offsets;
  const auto group = [&](Kind kind, const std::string& records) {
    if (records.empty()) {
      return;
    }
    ByteWriter offset;
    offset.number(static_cast<uint8_t>(kind)).number(begin + summary.size());
    offset.number(static_cast<uint64_t>(records.size()));
    offsets += record(Kind::kSummaryOffset, offset.bytes);
    summary += records;
  };
  std::string records;
  for (const auto& [id, schema] : schemas_) {
    records += bytes_of(schema);
  }
  group(Kind::kSchema, std::exchange(records, {}));
  for (const auto& [id, channel] : channels_) {
    records += bytes_of(channel);
  }
  group(Kind::kChannel, std::exchange(records, {}));
  group(Kind::kStatistics, bytes_of(statistics_));
  for (const ChunkPlace& chunk : chunks_) {
    records += bytes_of(chunk);
  }
  group(Kind::kChunkIndex, std::exchange(records, {}));
  for (const MetadataPlace& place : metadata_) {
    records += bytes_of(place);
  }
  group(Kind::kMetadataIndex, records);
  // The checksum is of all from the summary to the footer's places of it.
  ByteWriter footer;
  footer.number(static_cast<uint8_t>(Kind::kFooter)).number(uint64_t{20});
  footer.number(begin).number(begin + summary.size());
  footer.number(crc32(footer.bytes, crc32(offsets, crc32(summary))));
  out(summary);
  out(offsets);
  out(footer.bytes);
}

}  // namespace rosbag2_storage::mcap
