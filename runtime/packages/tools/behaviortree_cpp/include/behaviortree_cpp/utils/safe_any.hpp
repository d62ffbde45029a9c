// A value of any type. Numbers are read as other numbers, and texts as whatever reads texts.
#pragma once

#include <any>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>

#include "behaviortree_cpp/exceptions.h"
#include "behaviortree_cpp/utils/demangle_util.h"
#include "behaviortree_cpp/utils/expected.hpp"

namespace BT {

class Any {
 public:
  Any() = default;
  template <typename T, typename = std::enable_if_t<!std::is_same_v<std::decay_t<T>, Any>>>
  explicit Any(T&& value) {
    using Plain = std::decay_t<T>;
    if constexpr (std::is_convertible_v<Plain, std::string>) {
      value_ = std::string(std::forward<T>(value));
    } else if constexpr (std::is_constructible_v<std::string, Plain> &&
                         !std::is_arithmetic_v<Plain>) {
      value_ = std::string(value);
    } else {
      value_ = std::forward<T>(value);
    }
  }

  [[nodiscard]] bool empty() const { return !value_.has_value(); }
  [[nodiscard]] bool isString() const { return value_.type() == typeid(std::string); }
  [[nodiscard]] bool isNumber() const { return number<double>().has_value(); }
  [[nodiscard]] std::type_index type() const { return value_.type(); }

  /// As it is, or as another number, or as a text. Throws RuntimeError.
  template <typename T>
  [[nodiscard]] T cast() const {
    auto found = tryCast<T>();
    if (!found) throw RuntimeError(found.error());
    return std::move(found).value();
  }
  template <typename T>
  [[nodiscard]] nonstd::expected<T, std::string> tryCast() const {
    if (const T* same = std::any_cast<T>(&value_)) return *same;
    if constexpr (std::is_arithmetic_v<T>) {
      if (const auto found = number<T>()) return *found;
    } else if constexpr (std::is_enum_v<T>) {
      if (const auto found = number<std::underlying_type_t<T>>()) return static_cast<T>(*found);
    } else if constexpr (std::is_same_v<T, std::string>) {
      if (const auto found = number<long long>(); found && is_whole())
        return std::to_string(*found);
      if (const auto found = number<double>()) return std::to_string(*found);
    }
    return nonstd::make_unexpected(empty() ? std::string("Any::cast failed because it is empty")
                                           : "[Any::convert]: no known safe conversion between [" +
                                                 demangle(type()) + "] and [" +
                                                 demangle(typeid(T)) + "]");
  }

 private:
  template <typename T>
  [[nodiscard]] std::optional<T> number() const {
    std::optional<T> found;
    const auto look = [&](auto like) {
      if (const auto* one = std::any_cast<decltype(like)>(&value_)) found = static_cast<T>(*one);
    };
    look(int());
    look(double());
    look(bool());
    look(float());
    look(char());
    look((signed char)0);
    look((unsigned char)0);
    look((short)0);
    look((unsigned short)0);
    look(0U);
    look(0L);
    look(0UL);
    look(0LL);
    look(0ULL);
    return found;
  }
  [[nodiscard]] bool is_whole() const {
    return type() != typeid(double) && type() != typeid(float);
  }

  std::any value_;
};

}  // namespace BT
