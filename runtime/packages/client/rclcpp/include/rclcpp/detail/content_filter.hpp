// Decides by a message's bytes whether a subscription wants it. The language is that of DDS: fields
// (`header.stamp.sec`, `ranges[0]`), = <> != < <= > >= LIKE BETWEEN, AND OR NOT, %0 to %99.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rclcpp/subscription_content_filter_options.hpp"
#include "ros2wasm_typesupport/type_info.hpp"

namespace rclcpp {
namespace detail {

class ContentFilter {
 public:
  /// Throws std::invalid_argument that says what is wrong with the expression or its parameters.
  ContentFilter(const ros2wasm_typesupport::TypeInfo& type, ContentFilterOptions options);

  /// True for a message that meets the expression; false also when bytes or elements that are not
  /// there leave it open.
  [[nodiscard]] bool passes(const uint8_t* bytes, size_t size) const;
  [[nodiscard]] const ContentFilterOptions& options() const { return options_; }

  /// Nothing: unknown, and so is its opposite.
  using Truth = std::optional<bool>;
  /// A number or a text, of a message or of the expression.
  struct Value {
    enum class Kind : uint8_t { none, integer, real, text };
    Kind kind = Kind::none;
    bool negative = false;
    uint64_t magnitude = 0;
    double real = 0;
    std::string text;
  };
  /// From a message's type to one of its values: a field, and the element of it if it has some.
  struct Step {
    size_t field = 0;
    uint32_t element = 0;
  };
  struct Operand {
    /// Empty for a literal.
    std::vector<Step> path;
    /// The value of a literal. For a field only its kind is set.
    Value literal;
  };
  enum class Operator : uint8_t {
    equal,
    unequal,
    less,
    at_most,
    greater,
    at_least,
    like,
    both,
    either,
    negated
  };
  /// A comparison of operands, or a combination of earlier nodes.
  struct Node {
    Operator op = Operator::equal;
    Operand first;
    Operand second;
    size_t left = 0;
    size_t right = 0;
  };

 private:
  [[nodiscard]] Truth holds(size_t node, const uint8_t* bytes, size_t size) const;
  [[nodiscard]] Value value_of(const Operand& operand, const uint8_t* bytes, size_t size) const;

  const ros2wasm_typesupport::TypeInfo& type_;
  const ContentFilterOptions options_;
  /// Each after those that it combines; the last is the whole.
  std::vector<Node> nodes_;
};

}  // namespace detail
}  // namespace rclcpp
