// Texts of descriptions as values. All of the text must belong to the value, and the locale has no
// say. This file needs no ROS.
#pragma once

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace hardware_interface {

/// Throw std::invalid_argument for a text that is not a finite number.
double stod(const std::string& s);
float stof(const std::string& s);

namespace detail {
/// Throw std::invalid_argument for a text that is not a whole number, std::out_of_range beyond
/// 64 bits.
std::int64_t whole_number(const std::string& s);
std::vector<std::string> array_items(const std::string& array_string);
}  // namespace detail

template <typename T>
T stoi_generic(const std::string& s) {
  static_assert(std::is_integral_v<T> && std::is_signed_v<T>, "T must be a signed integral type");
  const std::int64_t value = detail::whole_number(s);
  if (value < std::numeric_limits<T>::min() || value > std::numeric_limits<T>::max()) {
    throw std::out_of_range("value not in range of target type");
  }
  return static_cast<T>(value);
}
inline int8_t stoi8(const std::string& s) {
  return stoi_generic<int8_t>(s);
}
inline int16_t stoi16(const std::string& s) {
  return stoi_generic<int16_t>(s);
}
inline int32_t stoi32(const std::string& s) {
  return stoi_generic<int32_t>(s);
}

template <typename T>
T stoui_generic(const std::string& s) {
  static_assert(std::is_integral_v<T> && std::is_unsigned_v<T>,
                "T must be an unsigned integral type");
  const std::int64_t value = detail::whole_number(s);
  if (value < 0 || static_cast<std::uint64_t>(value) > std::numeric_limits<T>::max()) {
    throw std::out_of_range("value not in range of target type");
  }
  return static_cast<T>(value);
}
inline uint8_t stoui8(const std::string& s) {
  return stoui_generic<uint8_t>(s);
}
inline uint16_t stoui16(const std::string& s) {
  return stoui_generic<uint16_t>(s);
}
inline uint32_t stoui32(const std::string& s) {
  return stoui_generic<uint32_t>(s);
}

std::string to_lower_case(const std::string& string);
/// "true" or "false" in any case; throws std::invalid_argument for anything else.
bool parse_bool(const std::string& bool_string);

/// The items of "[a, b]". Throws std::invalid_argument for another shape, or an item of another
/// type.
template <typename T>
std::vector<T> parse_array(const std::string& array_string) {
  std::vector<T> result;
  for (const std::string& item : detail::array_items(array_string)) {
    if constexpr (std::is_same_v<T, std::string>) {
      result.push_back(item);
    } else if constexpr (std::is_same_v<T, bool>) {
      result.push_back(parse_bool(item));
    } else {
      static_assert(std::is_arithmetic_v<T>, "an array has texts, truth values or numbers");
      try {
        result.push_back(static_cast<T>(hardware_interface::stod(item)));
      } catch (const std::exception&) {
        throw std::invalid_argument("Failed converting string to floating point or integer: " +
                                    item);
      }
    }
  }
  return result;
}

std::vector<std::string> parse_string_array(const std::string& string_array_string);

}  // namespace hardware_interface
