// See reader.hpp.
#include "reader.hpp"

#include <algorithm>
#include <stdexcept>

#include "lz4.hpp"

namespace rosbag2_storage::mcap {
namespace {

constexpr uint64_t kMostSummary = 64 << 20;
constexpr uint64_t kMostMetadata = 16 << 20;
constexpr uint64_t kMostSchemas = 16 << 20;
constexpr uint64_t kMostRecord = 128 << 20;
constexpr uint64_t kMostChunk = 128 << 20;
/// Upper bound for the unpacked chunks in memory; chunks whose times overlap are loaded together.
constexpr uint64_t kMostHeld = 256 << 20;
constexpr uint64_t kFooterLength = 20;
/// Bytes of a chunk's record before its records, with the longest name of a compression.
constexpr uint64_t kMostChunkHead = 8 + 8 + 8 + 4 + 4 + 32 + 8;

/// Calls `take` with each record of a chunk or a summary, and where it begins there.
template <typename Take>
void each_record(std::string_view records, Take take) {
  for (ByteReader from(records); !from.at_end();) {
    const auto kind = static_cast<Kind>(from.number<uint8_t>());
    const std::string_view content = from.take(from.number<uint64_t>());
    const auto at = static_cast<size_t>(content.data() - records.data()) - kRecordHead;
    take(kind, content, at);
  }
}

std::string unpacked(const ChunkHead& head, std::string packed) {
  if (head.size > kMostChunk) {
    throw Damaged("a chunk of " + std::to_string(head.size) + " bytes is too large");
  }
  if (head.compression == "lz4") {
    packed = unpack_lz4(packed, static_cast<size_t>(head.size));
  } else if (!head.compression.empty()) {
    throw Damaged("its chunks are compressed with " + head.compression.substr(0, 32) +
                  ", which is not read here: `ros2 bag convert` makes another bag of it");
  }
  if (packed.size() != head.size) {
    throw Damaged("a chunk has other bytes than it says");
  }
  if (head.crc != 0 && crc32(packed) != head.crc) {
    throw Damaged("a chunk is not as it was written");
  }
  return packed;
}

}  // namespace

bool Reader::Later::operator()(const Ahead& a, const Ahead& b) const {
  if (a.time != b.time) {
    return reversed ? a.time < b.time : a.time > b.time;
  }
  // A chunk is opened before messages of that time are given: it may have such, too.
  if (a.is_message != b.is_message) {
    return a.is_message;
  }
  return reversed ? a.place < b.place : a.place > b.place;
}

Reader::Reader(const std::string& path) : file_(path, std::ios::binary) {
  if (!file_.is_open()) {
    throw std::runtime_error("failed to open \"" + path + "\"");
  }
  file_.seekg(0, std::ios::end);
  const std::streamoff end = file_.tellg();
  size_ = end > 0 ? static_cast<uint64_t>(end) : 0;
  if (size_ < kMagic.size() || bytes_at(0, kMagic.size()) != kMagic) {
    throw std::runtime_error("invalid magic bytes: \"" + path + "\" is not an MCAP file");
  }
  try {
    read_summary();
  } catch (const Damaged& reason) {
    schemas_.clear();
    schema_bytes_ = 0;
    channels_.clear();
    chunks_.clear();
    metadata_.clear();
    statistics_ = {};
    scan();
    if (channels_.empty() && !damage_.empty()) {
      throw std::runtime_error(std::string(reason.what()) + "; " + damage_);
    }
  }
}

std::string Reader::bytes_at(uint64_t offset, uint64_t length) {
  if (offset > size_ || length > size_ - offset) {
    throw Damaged("it points behind its end");
  }
  if (length > kMostRecord) {
    throw Damaged("a part of " + std::to_string(length) + " bytes is too large");
  }
  std::string bytes(static_cast<size_t>(length), '\0');
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(offset));
  file_.read(bytes.data(), static_cast<std::streamsize>(length));
  if (static_cast<uint64_t>(file_.gcount()) != length) {
    throw Damaged("the file is shorter than it was");
  }
  return bytes;
}

std::optional<Reader::Record> Reader::record_at(uint64_t offset) {
  if (size_ < kRecordHead || offset > size_ - kRecordHead) {
    return std::nullopt;
  }
  const std::string head = bytes_at(offset, kRecordHead);
  ByteReader from(head);
  const auto kind = static_cast<Kind>(from.number<uint8_t>());
  const auto length = from.number<uint64_t>();
  const uint64_t content = offset + kRecordHead;
  if (length > size_ - content) {
    return std::nullopt;
  }
  return Record{kind, offset, content, length};
}

void Reader::take_schema(std::string_view record) {
  if (record.size() > kMostSchemas - schema_bytes_) {
    throw Damaged("its definitions of types are too large");
  }
  Schema schema = read_schema(record);
  const uint16_t id = schema.id;
  // Each chunk may say it again.
  if (schemas_.emplace(id, std::move(schema)).second) {
    schema_bytes_ += record.size();
  }
}

void Reader::take_channel(std::string_view record) {
  if (record.size() > kMostSchemas) {
    throw Damaged("what it says of a topic is too large");
  }
  Channel channel = read_channel(record);
  const uint16_t id = channel.id;
  channels_.emplace(id, std::move(channel));
}

bool Reader::take_description(Kind kind, std::string_view record) {
  if (kind == Kind::kSchema) {
    take_schema(record);
  } else if (kind == Kind::kChannel) {
    take_channel(record);
  } else {
    return false;
  }
  return true;
}

void Reader::read_summary() {
  const uint64_t end = kMagic.size() + kRecordHead + kFooterLength;
  if (size_ < kMagic.size() + end || bytes_at(size_ - kMagic.size(), kMagic.size()) != kMagic) {
    throw Damaged("it ends early");
  }
  const uint64_t footer = size_ - end;
  const std::string footer_bytes = bytes_at(footer, kRecordHead + kFooterLength);
  ByteReader from(footer_bytes);
  if (static_cast<Kind>(from.number<uint8_t>()) != Kind::kFooter ||
      from.number<uint64_t>() != kFooterLength) {
    throw Damaged("it has no footer");
  }
  const auto begin = from.number<uint64_t>();
  from.number<uint64_t>();
  const auto crc = from.number<uint32_t>();
  if (begin == 0) {
    throw Damaged("it has no index");
  }
  if (begin > footer || footer - begin > kMostSummary) {
    throw Damaged("its index lies elsewhere than it says");
  }
  const std::string summary = bytes_at(begin, footer - begin);
  const std::string_view checked =
      std::string_view(footer_bytes).substr(0, footer_bytes.size() - sizeof(crc));
  if (crc != 0 && crc32(checked, crc32(summary)) != crc) {
    throw Damaged("its index is not as it was written");
  }
  bool is_counted = false;
  each_record(summary, [&](Kind kind, std::string_view record, size_t) {
    switch (kind) {
      case Kind::kSchema:
      case Kind::kChannel:
        take_description(kind, record);
        break;
      case Kind::kStatistics:
        statistics_ = read_statistics(record);
        is_counted = true;
        break;
      case Kind::kChunkIndex:
        chunks_.push_back(read_chunk_place(record));
        break;
      case Kind::kMetadataIndex:
        metadata_.push_back(read_metadata_place(record));
        break;
      default:
        break;
    }
  });
  if (!is_counted) {
    throw Damaged("its index has no counts");
  }
  // Together they are no larger than the file: none is there twice.
  uint64_t left = size_;
  for (const ChunkPlace& chunk : chunks_) {
    if (chunk.first_time > chunk.last_time || chunk.length < kRecordHead || chunk.length > left) {
      throw Damaged("its index is not whole");
    }
    left -= chunk.length;
    for (const auto& [channel, place] : chunk.message_indexes) {
      if (channels_.count(channel) == 0) {
        throw Damaged("its index is not whole");
      }
    }
  }
  if (statistics_.messages > 0 && (statistics_.chunks != chunks_.size() || channels_.empty())) {
    throw Damaged("its index is not whole");
  }
}

void Reader::count(const MessageRecord& message) {
  const bool is_first = statistics_.messages == 0;
  const uint64_t time = message.log_time;
  ++statistics_.messages;
  ++statistics_.messages_of[message.channel];
  statistics_.first_time = is_first ? time : std::min(statistics_.first_time, time);
  statistics_.last_time = is_first ? time : std::max(statistics_.last_time, time);
}

ChunkHead Reader::head_at(const Record& record) {
  const std::string bytes = bytes_at(record.content, std::min(record.length, kMostChunkHead));
  ByteReader from(bytes);
  ChunkHead head = read_chunk_head(from);
  const uint64_t before = kMostChunkHead - 32 + head.compression.size();
  if (head.compressed_size > record.length - before) {
    throw Damaged("a chunk is shorter than it says");
  }
  return head;
}

std::string Reader::records_of(const Record& chunk) {
  const ChunkHead head = head_at(chunk);
  const uint64_t before = kMostChunkHead - 32 + head.compression.size();
  return unpacked(head, bytes_at(chunk.content + before, head.compressed_size));
}

/// From front to back, until the end or what cannot be.
void Reader::scan() {
  bool has_loose = false;
  const auto take = [&](Kind kind, std::string_view record, size_t) {
    if (!take_description(kind, record) && kind == Kind::kMessage) {
      count(read_message(record));
    }
  };
  try {
    uint64_t at = kMagic.size();
    for (;;) {
      const auto record = record_at(at);
      if (!record) {
        damage_ = "it ends early";
        break;
      }
      if (record->kind == Kind::kDataEnd || record->kind == Kind::kFooter) {
        break;
      }
      if (record->kind == Kind::kChunk) {
        const ChunkHead head = head_at(*record);
        each_record(records_of(*record), take);
        ChunkPlace place;
        place.first_time = head.first_time;
        place.last_time = head.last_time;
        place.offset = at;
        place.length = kRecordHead + record->length;
        chunks_.push_back(std::move(place));
      } else if (record->kind == Kind::kMetadata && record->length <= kMostMetadata) {
        const std::string bytes = bytes_at(record->content, record->length);
        metadata_.push_back({at, kRecordHead + record->length, read_metadata(bytes).name});
      } else if (record->kind == Kind::kSchema || record->kind == Kind::kChannel ||
                 record->kind == Kind::kMessage) {
        take(record->kind, bytes_at(record->content, record->length), 0);
        has_loose = has_loose || record->kind == Kind::kMessage;
      }
      at = record->content + record->length;
    }
  } catch (const Damaged& reason) {
    damage_ = reason.what();
  }
  // Those that lie in no chunk would be missing.
  if (has_loose) {
    chunks_.clear();
  }
}

std::vector<Metadata> Reader::metadata(const std::string& name) {
  std::vector<Metadata> found;
  // Together they are no larger than the file: none is there twice.
  uint64_t left = size_;
  for (const MetadataPlace& place : metadata_) {
    if (place.name != name) {
      continue;
    }
    try {
      const auto record = record_at(place.offset);
      if (record && record->kind == Kind::kMetadata &&
          record->length <= std::min(kMostMetadata, left)) {
        left -= record->length;
        found.push_back(read_metadata(bytes_at(record->content, record->length)));
      }
    } catch (const Damaged&) {
      // It says nothing then.
    }
  }
  return found;
}

void Reader::begin(ReadQuestion question) {
  question_ = std::move(question);
  held_.clear();
  held_bytes_ = 0;
  at_ = kMagic.size();
  chunk_records_.clear();
  in_chunk_ = 0;
  const bool reversed = question_.order == Order::kTimeReversed;
  std::vector<Ahead> first;
  if (question_.order != Order::kFile) {
    for (const ChunkPlace& chunk : chunks_) {
      if (chunk.last_time >= question_.first_time && chunk.first_time <= question_.last_time) {
        const uint64_t time = reversed ? chunk.last_time : chunk.first_time;
        first.push_back({time, false, {chunk.offset, 0}, &chunk});
      }
    }
  }
  ahead_ = decltype(ahead_)(Later{reversed}, std::move(first));
}

bool Reader::wants(const MessageRecord& message) const {
  const auto channel = channels_.find(message.channel);
  if (channel == channels_.end()) {
    throw Damaged("a message is of a topic that it does not tell of");
  }
  return message.log_time >= question_.first_time && message.log_time <= question_.last_time &&
         (!question_.wants || question_.wants(channel->second));
}

ReadMessage Reader::given(const MessageRecord& message, const Place& place) const {
  return {&channels_.at(message.channel), message.log_time, message.publish_time, place,
          std::string(message.data)};
}

std::optional<ReadMessage> Reader::next() {
  return question_.order == Order::kFile ? next_in_file() : next_by_time();
}

void Reader::open(const ChunkPlace& chunk) {
  const auto record = record_at(chunk.offset);
  if (!record || record->kind != Kind::kChunk || held_.count(chunk.offset) != 0) {
    throw Damaged("a chunk lies elsewhere than its index says");
  }
  if (head_at(*record).size > kMostHeld - std::min(kMostHeld, held_bytes_)) {
    throw Damaged("too many of its chunks overlap");
  }
  Held held{records_of(*record), 0};
  each_record(held.records, [&](Kind kind, std::string_view content, size_t at) {
    if (!take_description(kind, content) && kind == Kind::kMessage) {
      const MessageRecord message = read_message(content);
      if (wants(message)) {
        ahead_.push({message.log_time, true, {chunk.offset, at}, &chunk});
        ++held.unread;
      }
    }
  });
  if (held.unread > 0) {
    held_bytes_ += held.records.size();
    held_.insert_or_assign(chunk.offset, std::move(held));
  }
}

std::optional<ReadMessage> Reader::next_by_time() {
  while (!ahead_.empty()) {
    const Ahead ahead = ahead_.top();
    ahead_.pop();
    if (!ahead.is_message) {
      open(*ahead.chunk);
      continue;
    }
    const auto held = held_.find(ahead.chunk->offset);
    ByteReader from(
        std::string_view(held->second.records).substr(static_cast<size_t>(ahead.place.second) + 1));
    const MessageRecord message = read_message(from.take(from.number<uint64_t>()));
    ReadMessage found = given(message, ahead.place);
    if (--held->second.unread == 0) {
      held_bytes_ -= held->second.records.size();
      held_.erase(held);
    }
    return found;
  }
  return std::nullopt;
}

std::optional<ReadMessage> Reader::next_in_file() {
  for (;;) {
    while (in_chunk_ < chunk_records_.size()) {
      const size_t at = in_chunk_;
      ByteReader from(std::string_view(chunk_records_).substr(at));
      const auto kind = static_cast<Kind>(from.number<uint8_t>());
      const std::string_view content = from.take(from.number<uint64_t>());
      in_chunk_ = at + kRecordHead + content.size();
      if (!take_description(kind, content) && kind == Kind::kMessage) {
        const MessageRecord message = read_message(content);
        if (wants(message)) {
          return given(message, {chunk_offset_, at});
        }
      }
    }
    const auto record = record_at(at_);
    if (!record || record->kind == Kind::kDataEnd || record->kind == Kind::kFooter) {
      return std::nullopt;
    }
    const uint64_t offset = std::exchange(at_, record->content + record->length);
    if (record->kind == Kind::kChunk) {
      chunk_records_ = records_of(*record);
      chunk_offset_ = offset;
      in_chunk_ = 0;
    } else if (record->kind == Kind::kSchema || record->kind == Kind::kChannel) {
      take_description(record->kind, bytes_at(record->content, record->length));
    } else if (record->kind == Kind::kMessage) {
      const std::string bytes = bytes_at(record->content, record->length);
      const MessageRecord message = read_message(bytes);
      if (wants(message)) {
        return given(message, {offset, 0});
      }
    }
  }
}

}  // namespace rosbag2_storage::mcap
