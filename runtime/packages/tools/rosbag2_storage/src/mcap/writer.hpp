// Writes an MCAP file of the profile "ros2": in chunks with an index, not compressed. The file is
// whole when close() has returned; cut before, its chunks can be read.
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "records.hpp"

namespace rosbag2_storage::mcap {

struct WriterOptions {
  /// Bytes of a chunk that goes out; its last message may go over.
  uint64_t chunk_size = 768 * 1024;
  /// Else messages lie in the file one by one, without an index of their times.
  bool chunks = true;
};

class Writer {
 public:
  /// Throws std::runtime_error when there can be no such file.
  Writer(const std::string& path, const WriterOptions& options);
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  /// Closes; errors are not reported then.
  ~Writer();

  /// Give its id. They go out with their first message, and at the end.
  uint16_t add_schema(Schema schema);
  uint16_t add_channel(Channel channel);
  /// The message's channel must have been added. Throws std::runtime_error when it cannot be
  /// written.
  void write(const MessageRecord& message);
  void write(const Metadata& metadata);
  void close();
  /// Bytes that were written, plus those that wait in the chunk.
  [[nodiscard]] uint64_t size() const { return written_ + chunk_.size(); }

 private:
  struct Place {
    uint64_t time;
    uint64_t offset;
  };

  void out(std::string_view bytes);
  void end_chunk();
  /// Adds the channel and its schema, before the channel's first message.
  void introduce(Channel& channel, std::string& to);
  void write_summary();

  std::ofstream file_;
  WriterOptions options_;
  bool is_open_ = true;
  uint64_t written_ = 0;
  std::map<uint16_t, Schema> schemas_;
  std::map<uint16_t, Channel> channels_;
  std::vector<bool> is_out_[2];  ///< schemas and channels, by id
  std::string chunk_;
  std::map<uint16_t, std::vector<Place>> places_;  ///< in the chunk
  uint64_t first_time_ = 0;                        ///< of the chunk
  uint64_t last_time_ = 0;
  std::vector<ChunkPlace> chunks_;
  std::vector<MetadataPlace> metadata_;
  Statistics statistics_;
};

}  // namespace rosbag2_storage::mcap
