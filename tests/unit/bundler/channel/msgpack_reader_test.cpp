// MessagePack, every form of every value, whole and cut off.
#include "bundler/channel/msgpack_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ros2wasm {
namespace {

using namespace std::string_literals;

/// The value as JSON text, as far as these tests need it.
std::string shown(const JsonValue& value) {
  if (value.is_null()) return "null";
  if (const auto flag = value.boolean()) return *flag ? "true" : "false";
  if (const std::string* text = value.string()) return "\"" + *text + "\"";
  std::string out;
  if (value.is_array()) {
    for (const JsonValue& item : value.items()) out += (out.empty() ? "" : ",") + shown(item);
    return "[" + out + "]";
  }
  if (value.is_object()) {
    for (const auto& [key, member] : value.members())
      out += (out.empty() ? "" : ",") + key + ":" + shown(member);
    return "{" + out + "}";
  }
  if (const auto number = value.integer()) return std::to_string(*number);
  if (const auto number = value.unsigned_integer()) return std::to_string(*number);
  return std::to_string(value.number().value());
}

/// Reads bytes that must be exactly one value; nothing otherwise.
std::optional<JsonValue> one_value(std::string_view bytes) {
  MsgpackReader reader(bytes);
  auto value = reader.value();
  MsgpackReader skipping(bytes);
  const auto skipped = skipping.skipped();
  EXPECT_EQ(value.has_value(), skipped.has_value());
  if (value) {
    EXPECT_EQ(reader.at_end(), skipped->size() == bytes.size());
  }
  return reader.at_end() ? std::move(value) : std::nullopt;
}

struct Row {
  std::string bytes;
  std::string value;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows{
      {"\x00"s, "0"},
      {"\x7f"s, "127"},
      {"\xff"s, "-1"},
      {"\xe0"s, "-32"},
      {"\xcc\xff"s, "255"},
      {"\xcd\x01\x00"s, "256"},
      {"\xce\xff\xff\xff\xff"s, "4294967295"},
      {"\xcf\xff\xff\xff\xff\xff\xff\xff\xff"s, "18446744073709551615"},
      {"\xd0\x80"s, "-128"},
      {"\xd1\x80\x00"s, "-32768"},
      {"\xd2\x80\x00\x00\x00"s, "-2147483648"},
      {"\xd3\x00\x00\x00\x00\x00\x00\x01\x00"s, "256"},
      {"\xd3\xff\xff\xff\xff\xff\xff\xff\xfe"s, "-2"},
      {"\xca\x3f\xc0\x00\x00"s, "1.500000"},
      {"\xcb\xbf\xf8\x00\x00\x00\x00\x00\x00"s, "-1.500000"},
      {"\xc0"s, "null"},
      {"\xc2"s, "false"},
      {"\xc3"s, "true"},
      {"\xa0"s, "\"\""},
      {"\xa2hi"s, "\"hi\""},
      {"\xd9\x02hi"s, "\"hi\""},
      {"\xda\x00\x02hi"s, "\"hi\""},
      {"\xdb\x00\x00\x00\x02hi"s, "\"hi\""},
      {"\xc4\x02\x0f\xa0"s, "\"0fa0\""},
      {"\xc5\x00\x02\x0f\xa0"s, "\"0fa0\""},
      {"\xc6\x00\x00\x00\x02\x0f\xa0"s, "\"0fa0\""},
      {"\xc7\x02\x05\x0f\xa0"s, "\"0fa0\""},
      {"\xc8\x00\x01\x05\x0f"s, "\"0f\""},
      {"\xc9\x00\x00\x00\x01\x05\x0f"s, "\"0f\""},
      {"\xd4\x05\x0f"s, "\"0f\""},
      {"\xd5\x05\x0f\xa0"s, "\"0fa0\""},
      {"\xd8\x05"s + std::string(16, '\1'), "\"01010101010101010101010101010101\""},
      {"\x90"s, "[]"},
      {"\x92\x01\xa1x"s, "[1,\"x\"]"},
      {"\xdc\x00\x02\x01\x02"s, "[1,2]"},
      {"\xdd\x00\x00\x00\x01\xc0"s, "[null]"},
      {"\x80"s, "{}"},
      {"\x82\xa1\x61\x01\xa1\x62\xc4\x01\x0f"s, "{a:1,b:\"0f\"}"},
      {"\xde\x00\x01\xa1\x61\x91\x80"s, "{a:[{}]}"},
      {"\xdf\x00\x00\x00\x01\xd9\x01\x61\x01"s, "{a:1}"},
  };
  return kRows;
}

TEST(MsgpackReader, EveryForm) {
  for (const Row& row : rows()) {
    const auto value = one_value(row.bytes);
    ASSERT_TRUE(value) << row.value;
    EXPECT_EQ(shown(*value), row.value);
  }
}

TEST(MsgpackReader, NothingIsReadOfWhatIsCutOffOrGoesOn) {
  for (const Row& row : rows()) {
    for (std::size_t size = 0; size < row.bytes.size(); ++size)
      EXPECT_FALSE(one_value(row.bytes.substr(0, size))) << row.value << " " << size;
    EXPECT_FALSE(one_value(row.bytes + "\x01")) << row.value;
  }
  for (const std::string& bad : {"\xc1"s, "\x81\x01\x01"s, "\xdb\xff\xff\xff\xff"s,
                                 "\xdd\xff\xff\xff\xff"s, "\xdf\xff\xff\xff\xff\xa1"s})
    EXPECT_FALSE(MsgpackReader(bad).value());
}

TEST(MsgpackReader, DeepValuesArePassedOverButNotMade) {
  const std::string deep = std::string(100'000, '\x91') + "\x01";
  EXPECT_FALSE(MsgpackReader(deep).value());
  EXPECT_EQ(MsgpackReader(deep + "more").skipped(), deep);
}

TEST(MsgpackReader, NoMoreThanAMillionValuesAreMade) {
  const std::string most = "\xdd\x00\x0f\x42\x3f"s + std::string(999'999, '\xc0');
  EXPECT_TRUE(MsgpackReader(most).value());
  const std::string more = "\xdd\x00\x0f\x42\x40"s + std::string(1'000'000, '\xc0');
  EXPECT_FALSE(MsgpackReader(more).value());
  EXPECT_EQ(MsgpackReader(more).skipped(), more);
  const std::string both = most + "\x01";
  MsgpackReader reader(both);
  EXPECT_TRUE(reader.value());
  EXPECT_FALSE(reader.value());
}

TEST(MsgpackReader, WhatIsThereInsteadIsNotTaken) {
  EXPECT_FALSE(MsgpackReader("\x81\x01\x01").array());
  EXPECT_FALSE(MsgpackReader("\x91\x01").map());
  EXPECT_FALSE(MsgpackReader("\xc4\x01y").key());
  EXPECT_FALSE(MsgpackReader("\x01").content());
  const std::string bytes = "\x82\xa1\x61\x92\x01\x02\xa1\x62\xc4\x01y";
  MsgpackReader reader(bytes);
  EXPECT_EQ(reader.map(), 2U);
  EXPECT_EQ(reader.key(), "a");
  EXPECT_EQ(reader.array(), 2U);
  EXPECT_EQ(reader.skipped(), "\x01");
  EXPECT_EQ(reader.skipped(), "\x02");
  EXPECT_EQ(reader.key(), "b");
  EXPECT_EQ(reader.content(), "y");
  EXPECT_TRUE(reader.at_end());
}

}  // namespace
}  // namespace ros2wasm
