// Reads JSON text into values. Pure. The JSON library ends in json_reader.cpp; writing is in
// json_writer.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

class JsonValue {
 public:
  using Array = std::vector<JsonValue>;
  using Member = std::pair<std::string, JsonValue>;
  using Object =
      std::vector<Member>;  ///< in the order of the text; a repeated key keeps the last value
  using State = std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string,
                             Array, Object>;

  JsonValue() = default;
  explicit JsonValue(State state) : state_(std::move(state)) {}

  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::nullptr_t>(state_); }
  [[nodiscard]] bool is_object() const { return std::holds_alternative<Object>(state_); }
  [[nodiscard]] bool is_array() const { return std::holds_alternative<Array>(state_); }

  /// Each is nothing when the value is of another kind.
  [[nodiscard]] const std::string* string() const { return std::get_if<std::string>(&state_); }
  [[nodiscard]] std::optional<bool> boolean() const;
  [[nodiscard]] std::optional<std::int64_t> integer() const;  ///< also a double without fraction
  [[nodiscard]] std::optional<std::uint64_t> unsigned_integer() const;
  [[nodiscard]] std::optional<double> number() const;

  /// Empty when the value is of another kind.
  [[nodiscard]] const Array& items() const;
  [[nodiscard]] const Object& members() const;

  /// The member of an object; nullptr when absent or when this is not an object.
  [[nodiscard]] const JsonValue* find(std::string_view key) const;
  /// find() and string(); empty when either fails.
  [[nodiscard]] std::string text_of(std::string_view key) const;

  [[nodiscard]] State& state() { return state_; }

 private:
  State state_ = nullptr;
};

/// `code` and `file` go into the diagnostic, which has line and column. Nesting is limited to 200,
/// the number of values to 2,000,000.
[[nodiscard]] Outcome<JsonValue> parse_json(std::string_view text, const std::string& file,
                                            DiagnosticCode code);

}  // namespace ros2wasm
