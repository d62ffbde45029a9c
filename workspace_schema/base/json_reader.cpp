// See json_reader.hpp. The JSON library is known here only; its exceptions end here.
#include "workspace_schema/base/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace ros2wasm {
namespace {

constexpr std::size_t kDeepest = 200;
/// A value takes up to 80 bytes of memory, and may be two of text: `0,`.
constexpr std::size_t kMostValues = 2'000'000;

/// Builds JsonValues as the library reports what it reads.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return put(JsonValue()); }
  bool boolean(bool value) override { return put(JsonValue(value)); }
  bool number_integer(number_integer_t value) override {
    return put(JsonValue(std::int64_t{value}));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return put(JsonValue(std::uint64_t{value}));
  }
  bool number_float(number_float_t value, const string_t&) override {
    return put(JsonValue(value));
  }
  bool string(string_t& value) override { return put(JsonValue(std::move(value))); }
  bool binary(binary_t&) override { return false; }  // JSON has none
  bool start_object(std::size_t) override { return open(JsonValue(JsonValue::Object{})); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(JsonValue(JsonValue::Array{})); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    keys_.back() = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& raised) override {
    error_at_ = position;
    error_ = raised.what();
    // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." -> the
    // last part
    if (const auto cut = error_.find(": "); cut != std::string::npos)
      error_ = error_.substr(cut + 2);
    return false;
  }

  JsonValue take() { return std::move(root_); }
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] std::size_t error_at() const { return error_at_; }

 private:
  bool put(JsonValue value) {
    if (++values_ > kMostValues) {
      error_ = "it has more than " + std::to_string(kMostValues) + " values";
      return false;
    }
    if (open_.empty()) {
      root_ = std::move(value);
      return true;
    }
    JsonValue::State& state = open_.back().state();
    if (auto* array = std::get_if<JsonValue::Array>(&state)) {
      array->push_back(std::move(value));
    } else {
      std::get<JsonValue::Object>(state).emplace_back(std::move(keys_.back()), std::move(value));
    }
    return true;
  }

  bool open(JsonValue container) {
    if (open_.size() == kDeepest) {
      error_ = "nested deeper than " + std::to_string(kDeepest) + " levels";
      return false;
    }
    open_.push_back(std::move(container));
    keys_.emplace_back();
    return true;
  }

  bool close() {
    JsonValue value = std::move(open_.back());
    // A list of a site's files has half a million small objects.
    if (auto* object = std::get_if<JsonValue::Object>(&value.state())) object->shrink_to_fit();
    open_.pop_back();
    keys_.pop_back();
    return put(std::move(value));
  }

  JsonValue root_;
  std::size_t values_ = 0;
  std::vector<JsonValue> open_;
  std::vector<std::string> keys_;  ///< the key that waits for its value, one per open container
  std::string error_;
  std::size_t error_at_ = 0;
};

SourceSpan place_of(std::string_view text, std::size_t offset, const std::string& file) {
  offset = std::min(offset == 0 ? 0 : offset - 1, text.size());
  SourceSpan span{.file = file, .line = 1, .column = 1, .length = 1, .line_text = {}};
  std::size_t line_start = 0;
  for (std::size_t i = 0; i < offset; ++i) {
    if (text[i] != '\n') continue;
    ++span.line;
    line_start = i + 1;
  }
  span.column = static_cast<std::uint32_t>(offset - line_start + 1);
  const std::string_view line = text.substr(line_start, text.find('\n', line_start) - line_start);
  if (line.size() <= 500) span.line_text = std::string(line);
  return span;
}

}  // namespace

std::optional<bool> JsonValue::boolean() const {
  const auto* value = std::get_if<bool>(&state_);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

std::optional<std::int64_t> JsonValue::integer() const {
  if (const auto* value = std::get_if<std::int64_t>(&state_)) return *value;
  if (const auto* value = std::get_if<std::uint64_t>(&state_)) {
    if (*value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
      return static_cast<std::int64_t>(*value);
    }
  }
  if (const auto* value = std::get_if<double>(&state_)) {
    if (std::abs(*value) < 9e15 && std::trunc(*value) == *value)
      return static_cast<std::int64_t>(*value);
  }
  return std::nullopt;
}

std::optional<std::uint64_t> JsonValue::unsigned_integer() const {
  if (const auto* value = std::get_if<std::uint64_t>(&state_)) return *value;
  const auto signed_value = integer();
  if (!signed_value || *signed_value < 0) return std::nullopt;
  return static_cast<std::uint64_t>(*signed_value);
}

std::optional<double> JsonValue::number() const {
  if (const auto* value = std::get_if<double>(&state_)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&state_)) return static_cast<double>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&state_)) return static_cast<double>(*value);
  return std::nullopt;
}

const JsonValue::Array& JsonValue::items() const {
  static const Array kNone;
  const auto* array = std::get_if<Array>(&state_);
  return array == nullptr ? kNone : *array;
}

const JsonValue::Object& JsonValue::members() const {
  static const Object kNone;
  const auto* object = std::get_if<Object>(&state_);
  return object == nullptr ? kNone : *object;
}

const JsonValue* JsonValue::find(std::string_view key) const {
  const Object& object = members();
  const auto found = std::find_if(object.rbegin(), object.rend(),
                                  [key](const Member& member) { return member.first == key; });
  return found == object.rend() ? nullptr : &found->second;
}

std::string JsonValue::text_of(std::string_view key) const {
  const JsonValue* value = find(key);
  const std::string* text = value == nullptr ? nullptr : value->string();
  return text == nullptr ? std::string() : *text;
}

Outcome<JsonValue> parse_json(std::string_view text, const std::string& file, DiagnosticCode code) {
  Builder builder;
  bool read = false;
  std::string failure;
  try {
    read = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  } catch (const std::exception& raised) {
    failure = raised.what();
  }
  if (read) return builder.take();
  if (failure.empty()) failure = builder.error();
  Diagnostic error{
      .code = code, .message = "`" + file + "` is not valid JSON", .why = {std::move(failure)}};
  // A limit has no place.
  if (builder.error_at() != 0) {
    error.span = place_of(text, builder.error_at(), file);
    error.label = "here";
  }
  return error;
}

}  // namespace ros2wasm
