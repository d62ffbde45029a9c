// Writes compact JSON text, keys in the order given. For output only; reading is elsewhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// `text` as a JSON string with its quotes. Invalid UTF-8 becomes U+FFFD.
[[nodiscard]] std::string json_quoted(std::string_view text);

class JsonWriter {
 public:
  JsonWriter& begin_object();
  JsonWriter& end_object();
  JsonWriter& begin_array();
  JsonWriter& end_array();
  JsonWriter& key(std::string_view name);
  JsonWriter& string(std::string_view text);
  JsonWriter& integer(std::int64_t number);
  JsonWriter& unsigned_integer(std::uint64_t number);
  /// NaN and infinities, which JSON has not, become null.
  JsonWriter& number(double number);
  /// A number whose digits the caller made.
  JsonWriter& raw_number(std::string_view digits);
  /// A whole value that another writer made.
  JsonWriter& raw_value(std::string_view json) { return raw_number(json); }
  JsonWriter& boolean(bool value);
  JsonWriter& null();

  // The common pairs.
  JsonWriter& field(std::string_view name, std::string_view text) { return key(name).string(text); }
  JsonWriter& field(std::string_view name, const char* text) { return key(name).string(text); }
  JsonWriter& field_integer(std::string_view name, std::int64_t value) {
    return key(name).integer(value);
  }
  JsonWriter& field_boolean(std::string_view name, bool value) { return key(name).boolean(value); }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void before_value();

  std::string text_;
  std::vector<bool> has_items_;  ///< one per open object or array
  bool after_key_ = false;
};

}  // namespace ros2wasm
