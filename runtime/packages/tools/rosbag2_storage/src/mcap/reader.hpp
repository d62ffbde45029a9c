// Reads an MCAP file: by its index, or when it has none that holds, from front to back as far as it
// is whole. What it says of itself may be a lie: each length is looked at before memory is made for
// it.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "records.hpp"

namespace rosbag2_storage::mcap {

/// Where a message lies: its record or its chunk in the file, and its record in that chunk. In a
/// file's own order.
using Place = std::pair<uint64_t, uint64_t>;

struct ReadMessage {
  const Channel* channel = nullptr;
  uint64_t log_time = 0;
  uint64_t publish_time = 0;
  Place place;
  std::string data;
};

enum class Order { kFile, kTime, kTimeReversed };

struct ReadQuestion {
  Order order = Order::kFile;
  uint64_t first_time = 0;
  uint64_t last_time = UINT64_MAX;
  std::function<bool(const Channel&)> wants;
};

class Reader {
 public:
  /// Throws std::runtime_error for what is not an MCAP file, and where nothing of one can be read.
  explicit Reader(const std::string& path);
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  [[nodiscard]] const std::map<uint16_t, Schema>& schemas() const { return schemas_; }
  [[nodiscard]] const std::map<uint16_t, Channel>& channels() const { return channels_; }
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  [[nodiscard]] uint64_t size() const { return size_; }
  /// Messages lie in chunks, which are known: they can be given in order of their times.
  [[nodiscard]] bool can_sort() const { return !chunks_.empty() || statistics_.messages == 0; }
  /// Why not all of it can be read; empty: it is whole, as far as its index says.
  [[nodiscard]] const std::string& damage() const { return damage_; }
  /// The metadata records of that name, in the file's order; those that cannot be read are skipped.
  [[nodiscard]] std::vector<Metadata> metadata(const std::string& name);

  /// Sets the messages that next() returns from now on, beginning with the first of them.
  void begin(ReadQuestion question);
  /// Nothing: there are no more. Throws Damaged.
  [[nodiscard]] std::optional<ReadMessage> next();

 private:
  struct Record {
    Kind kind;
    uint64_t offset;   ///< of its head
    uint64_t content;  ///< where its content begins
    uint64_t length;   ///< of the content
  };
  /// A chunk's records, unpacked.
  struct Held {
    std::string records;
    size_t unread = 0;  ///< messages that wait in `ahead_`
  };
  /// A chunk that begins at that time, or a message of one that was opened.
  struct Ahead {
    uint64_t time;
    bool is_message;
    Place place;
    const ChunkPlace* chunk;
  };
  struct Later {
    bool reversed = false;
    bool operator()(const Ahead& a, const Ahead& b) const;
  };

  [[nodiscard]] std::string bytes_at(uint64_t offset, uint64_t length);
  /// Nothing: there is no whole record.
  [[nodiscard]] std::optional<Record> record_at(uint64_t offset);
  void read_summary();
  void scan();
  void count(const MessageRecord& message);
  void take_schema(std::string_view record);
  void take_channel(std::string_view record);
  /// Whether the record is one of these.
  bool take_description(Kind kind, std::string_view record);
  [[nodiscard]] ChunkHead head_at(const Record& record);
  [[nodiscard]] std::string records_of(const Record& chunk);
  void open(const ChunkPlace& chunk);
  [[nodiscard]] bool wants(const MessageRecord& message) const;
  [[nodiscard]] ReadMessage given(const MessageRecord& message, const Place& place) const;
  [[nodiscard]] std::optional<ReadMessage> next_by_time();
  [[nodiscard]] std::optional<ReadMessage> next_in_file();

  std::ifstream file_;
  uint64_t size_ = 0;
  std::map<uint16_t, Schema> schemas_;
  uint64_t schema_bytes_ = 0;
  std::map<uint16_t, Channel> channels_;
  std::vector<ChunkPlace> chunks_;
  std::vector<MetadataPlace> metadata_;
  Statistics statistics_;
  std::string damage_;

  ReadQuestion question_;
  std::priority_queue<Ahead, std::vector<Ahead>, Later> ahead_;
  std::map<uint64_t, Held> held_;  ///< by the chunk's place
  uint64_t held_bytes_ = 0;
  uint64_t at_ = 0;            ///< the next record, in the file's order
  std::string chunk_records_;  ///< of the chunk that is read in that order
  uint64_t chunk_offset_ = 0;
  size_t in_chunk_ = 0;
};

}  // namespace rosbag2_storage::mcap
