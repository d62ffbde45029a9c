// Reads MessagePack from its beginning to its end and makes values of no more than what is asked
// for: the lists and shards of large channels are mostly passed over. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {

/// Every function takes one thing off the front; nothing when something else is there, or when the
/// bytes end before it. What follows then means nothing. Views are valid as long as the bytes.
class MsgpackReader {
 public:
  explicit MsgpackReader(std::string_view bytes) : rest_(bytes) {}

  /// The head of a map: how many pairs of a key and a value follow.
  [[nodiscard]] std::optional<std::uint32_t> map();
  /// The head of an array: how many values follow.
  [[nodiscard]] std::optional<std::uint32_t> array();
  /// A text.
  [[nodiscard]] std::optional<std::string_view> key();
  /// A text or bytes.
  [[nodiscard]] std::optional<std::string_view> content();
  /// Any value, as the bytes that it is made of.
  [[nodiscard]] std::optional<std::string_view> skipped();
  /// Any value, as parse_json() gives them: bytes become texts of lower-case hex, keys are texts.
  /// Nothing also when it is nested deeper than 200 levels, or when the values made so far are more
  /// than a million.
  [[nodiscard]] std::optional<JsonValue> value();

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  enum class Kind {
    kNull,
    kBool,
    kSigned,
    kUnsigned,
    kFloat,
    kDouble,
    kText,
    kBytes,
    kArray,
    kMap
  };
  struct Token;

  std::string_view short_text();
  std::optional<Token> token();
  std::optional<std::uint64_t> number(unsigned size_bytes);
  std::optional<Token> counted(Kind kind, unsigned size_bytes);
  std::optional<Token> sized(Kind kind, std::optional<std::uint64_t> size);
  std::optional<Token> extension(std::optional<std::uint64_t> size);
  bool read(int levels, JsonValue& into);
  bool items(std::uint64_t count, int levels, JsonValue::Array& into);
  bool members(std::uint64_t count, int levels, JsonValue::Object& into);

  std::string_view rest_;
  std::uint32_t made_ = 0;  ///< values, of all calls of value()
};

}  // namespace ros2wasm
