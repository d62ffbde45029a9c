// MCAP files for nodes: what is written is read, in every order; what was cut, changed or lies
// gives what is whole of it, or an error.

// Guarantee, hostile input: a bag that a node reads and that was cut, changed or made to lie gives
// what is whole of it or an exception, within bounded memory

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "lz4.hpp"
#include "reader.hpp"
#include "writer.hpp"

namespace rosbag2_storage::mcap {
namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

class McapTest : public ::testing::Test {
 protected:
  ~McapTest() override { fs::remove(path_); }

  std::string path() const { return path_.string(); }

  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void write_bytes(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
  }

  /// Messages 0 to `count` - 1, of /even and /odd; pairs are written the later one first.
  void write_file(int count, const WriterOptions& options) const {
    Writer writer(path(), options);
    const uint16_t schema = writer.add_schema({0, "std_msgs/msg/String", "ros2msg", "string data"});
    const uint16_t channels[] = {
        writer.add_channel({0, schema, "/even", "cdr", {{"topic_type_hash", "RIHS01_0"}}}),
        writer.add_channel({0, schema, "/odd", "cdr", {}})};
    writer.add_channel({0, schema, "/never", "cdr", {}});
    for (int i = 0; i < count; ++i) {
      const int number = i ^ 1;
      const std::string data = "message " + std::to_string(number);
      const auto time = static_cast<uint64_t>(1000 + number);
      writer.write(MessageRecord{channels[number % 2], 0, time, time, data});
    }
    writer.write(Metadata{"rosbag2", {{"key", "value"}}});
  }

  static Texts read_all(Reader& reader, ReadQuestion question) {
    Texts found;
    reader.begin(std::move(question));
    while (const auto message = reader.next()) {
      found.push_back(message->data);
    }
    return found;
  }

  /// The texts in the file, sorted by time when the file allows it.
  Texts read_file() const {
    Reader reader(path());
    ReadQuestion question;
    question.order = reader.can_sort() ? Order::kTime : Order::kFile;
    return read_all(reader, std::move(question));
  }

 private:
  fs::path path_ = fs::temp_directory_path() /
                   ("ros2wasm-mcap-" + std::to_string(std::random_device{}()) + ".mcap");
};

constexpr WriterOptions kSmallChunks{200, true};
constexpr WriterOptions kLoose{0, false};

TEST_F(McapTest, IsReadInEveryOrder) {
  write_file(20, kSmallChunks);
  Reader reader(path());
  EXPECT_EQ(reader.damage(), "");
  EXPECT_TRUE(reader.can_sort());
  EXPECT_EQ(reader.statistics().messages, 20u);
  EXPECT_EQ(reader.statistics().first_time, 1000u);
  EXPECT_EQ(reader.statistics().last_time, 1019u);
  EXPECT_GT(reader.statistics().chunks, 3u);
  ASSERT_EQ(reader.channels().size(), 3u);
  EXPECT_EQ(reader.channels().at(1).metadata.at("topic_type_hash"), "RIHS01_0");
  EXPECT_EQ(reader.statistics().messages_of.at(2), 10u);
  ASSERT_EQ(reader.metadata("rosbag2").size(), 1u);
  EXPECT_EQ(reader.metadata("rosbag2")[0].values.at("key"), "value");
  EXPECT_TRUE(reader.metadata("other").empty());

  ReadQuestion question;
  Texts all = read_all(reader, question);
  ASSERT_EQ(all.size(), 20u);
  EXPECT_EQ((Texts{all[0], all[1], all[2]}), (Texts{"message 1", "message 0", "message 3"}));
  question.order = Order::kTime;
  all = read_all(reader, question);
  ASSERT_EQ(all.size(), 20u);
  for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], "message " + std::to_string(i));
  question.order = Order::kTimeReversed;
  question.last_time = 1004;
  EXPECT_EQ(read_all(reader, question),
            (Texts{"message 4", "message 3", "message 2", "message 1", "message 0"}));
  question.order = Order::kTime;
  question.first_time = 1002;
  question.wants = [](const Channel& channel) { return channel.topic == "/even"; };
  EXPECT_EQ(read_all(reader, question), (Texts{"message 2", "message 4"}));
}

TEST_F(McapTest, IsReadWithoutAnIndex) {
  write_file(20, kLoose);
  Reader loose(path());
  EXPECT_FALSE(loose.can_sort());
  EXPECT_EQ(loose.statistics().messages, 20u);
  EXPECT_EQ(read_all(loose, {}).size(), 20u);
  write_file(20, kSmallChunks);
  std::string whole = bytes();
  // Without what a writer writes last.
  write_bytes(whole.substr(0, whole.size() - 60));
  Reader cut(path());
  EXPECT_EQ(read_file().size(), 20u);
  EXPECT_EQ(cut.channels().size(), 2u);
  ASSERT_EQ(cut.metadata("rosbag2").size(), 1u);
}

TEST_F(McapTest, AnEmptyOneHasNothing) {
  write_file(0, {});
  Reader reader(path());
  EXPECT_EQ(reader.damage(), "");
  EXPECT_EQ(reader.channels().size(), 3u);
  EXPECT_TRUE(read_file().empty());
}

TEST_F(McapTest, WhatIsNoFileIsRefused) {
  EXPECT_THROW(Reader("/nowhere/a.mcap"), std::runtime_error);
  for (const char* text : {"", "anything", "#ROSBAG V2.0", "SQLite format 3"}) {
    write_bytes(text);
    EXPECT_THROW(Reader{path()}, std::runtime_error) << text;
  }
  EXPECT_THROW(Writer("/nowhere/a.mcap", {}), std::runtime_error);
}

TEST_F(McapTest, CutAnywhereItGivesWhatIsWhole) {
  write_file(60, kSmallChunks);
  const std::string whole = bytes();
  size_t most = 0;
  for (size_t length = 0; length < whole.size(); length += 13) {
    write_bytes(whole.substr(0, length));
    try {
      const size_t count = read_file().size();
      EXPECT_GE(count, most);
      most = std::max(most, count);
    } catch (const std::runtime_error&) {
      EXPECT_EQ(most, 0u) << "cut at " << length;
    }
  }
  EXPECT_EQ(most, 60u);
}

TEST_F(McapTest, ChangedAnywhereItGivesMessagesOrAnError) {
  std::mt19937 random(7);
  for (const WriterOptions& options : {kSmallChunks, kLoose}) {
    write_file(40, options);
    const std::string whole = bytes();
    for (int round = 0; round < 400; ++round) {
      std::string changed = whole;
      const auto changes = 1 + random() % 4;
      for (size_t i = 0; i < changes; ++i) {
        changed[random() % changed.size()] = static_cast<char>(random() % 4 == 0 ? 0xFF : random());
      }
      write_bytes(changed);
      try {
        EXPECT_LE(read_file().size(), 40u);
      } catch (const std::runtime_error&) {
        // As well.
      }
    }
  }
}

/// A file with one chunk that says so of itself.
std::string file_with_chunk(const ChunkHead& head, const std::string& packed) {
  ByteWriter chunk;
  chunk.number(head.first_time).number(head.last_time).number(head.size).number(head.crc);
  chunk.text(head.compression).number(head.compressed_size);
  return std::string(kMagic) + record(Kind::kHeader, ByteWriter().text("").text("").bytes) +
         bytes_of(Schema{1, "a", "", ""}) + bytes_of(Channel{1, 1, "/a", "cdr", {}}) +
         record(Kind::kChunk, chunk.bytes + packed);
}

TEST_F(McapTest, AChunkThatLiesIsAnError) {
  const std::string inside = bytes_of(MessageRecord{1, 0, 5, 5, "x"});
  const auto damage = [&](const ChunkHead& head, const std::string& packed) {
    write_bytes(file_with_chunk(head, packed));
    return Reader(path()).damage();
  };
  const uint64_t size = inside.size();
  EXPECT_EQ(damage({5, 5, size, crc32(inside), "", size}, inside), "it ends early");
  EXPECT_EQ(read_file(), Texts{"x"});
  EXPECT_EQ(damage({5, 5, size, 1, "", size}, inside), "a chunk is not as it was written");
  EXPECT_EQ(damage({5, 5, size + 1, 0, "", size}, inside), "a chunk has other bytes than it says");
  EXPECT_EQ(damage({5, 5, size, 0, "", size + 1}, inside), "a chunk is shorter than it says");
  EXPECT_EQ(damage({5, 5, uint64_t{1} << 60, 0, "", size}, inside),
            "a chunk of 1152921504606846976 bytes is too large");
  EXPECT_EQ(damage({5, 5, uint64_t{100} << 20, 0, "lz4", size}, inside),
            "LZ4 data are too short for what they say");
  EXPECT_NE(damage({5, 5, size, 0, "zstd", size}, inside).find("compressed with zstd"),
            std::string::npos);
  EXPECT_EQ(damage({5, 5, size, 0, std::string(40, 'z'), size}, inside),
            "a record is shorter than it says");
  const std::string stranger = bytes_of(MessageRecord{9, 0, 5, 5, "x"});
  EXPECT_EQ(damage({5, 5, size, 0, "", size}, stranger), "it ends early");
  EXPECT_THROW(read_file(), Damaged);
}

TEST_F(McapTest, AnIndexThatLiesIsNotBelieved) {
  write_file(40, kSmallChunks);
  const std::string whole = bytes();
  // The footer says where the index begins; with no checksum it may say anything.
  const size_t footer = whole.size() - kMagic.size() - 20;
  for (const uint64_t begin : {uint64_t{0}, uint64_t{1}, uint64_t{8}, uint64_t{100}, UINT64_MAX}) {
    std::string changed = whole;
    changed.replace(footer, 20, ByteWriter().number(begin).number(begin).number(uint32_t{0}).bytes);
    write_bytes(changed);
    EXPECT_EQ(read_file().size(), 40u) << begin;
  }
}

TEST_F(McapTest, ChunksOverEachOtherAreSorted) {
  Writer writer(path(), {100, true});
  const uint16_t channel =
      writer.add_channel({0, writer.add_schema({0, "a", "", ""}), "/a", "", {}});
  for (int i = 0; i < 50; ++i) {
    const std::string data = std::to_string(i);
    writer.write(MessageRecord{channel, 0, static_cast<uint64_t>((i * 7) % 50), 0, data});
  }
  writer.close();
  Reader reader(path());
  ReadQuestion question;
  question.order = Order::kTime;
  reader.begin(question);
  for (uint64_t time = 0; time < 50; ++time) {
    const auto message = reader.next();
    ASSERT_TRUE(message);
    EXPECT_EQ(message->log_time, time);
  }
  EXPECT_FALSE(reader.next());
}

std::string from_hex(const std::string& hex) {
  std::string bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

TEST(Lz4, IsUnpackedAndChecked) {
  const std::string fox = "the quick brown fox jumps over the lazy dog";
  const std::string words = fox + ", " + fox + ". " + std::string(80, 'a');
  // Made by lz4 1.9.4: lz4 -BD --content-size
  const std::string frame = from_hex(
      "04224d186440a740000000f01074686520717569636b2062726f776e20666f78206a756d7073206f766572201f00"
      "916c617a7920646f672c0e000f2d00143f2e2061010037506161616161000000006dab4372");
  EXPECT_EQ(unpack_lz4(frame, words.size()), words);
  EXPECT_THROW((void)unpack_lz4(frame, words.size() - 1), Damaged);
  EXPECT_THROW((void)unpack_lz4(frame, words.size() + 1), Damaged);
  for (size_t length = 1; length < frame.size() - 4; ++length)
    EXPECT_THROW((void)unpack_lz4(frame.substr(0, length), words.size()), Damaged) << length;
  std::mt19937 random(3);
  for (int round = 0; round < 5000; ++round) {
    std::string changed = frame;
    changed[random() % changed.size()] = static_cast<char>(random());
    try {
      EXPECT_EQ(unpack_lz4(changed, words.size()).size(), words.size());
    } catch (const Damaged&) {
      // As well.
    }
  }
}

}  // namespace
}  // namespace rosbag2_storage::mcap
