// Texts as values. This file needs no ROS.
#include "hardware_interface/lexical_casts.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "hardware_interface/helpers.hpp"

namespace hardware_interface {
namespace {

double finite_number(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  if (stream.fail() || !stream.eof() || !std::isfinite(value)) {
    throw std::invalid_argument("Failed converting string '" + text + "' to a real number");
  }
  return value;
}

}  // namespace

double stod(const std::string& s) {
  return finite_number(s);
}

float stof(const std::string& s) {
  const auto value = static_cast<float>(finite_number(s));
  if (!std::isfinite(value)) {
    throw std::invalid_argument("Failed converting string '" + s + "' to a real number");
  }
  return value;
}

std::string to_lower_case(const std::string& string) {
  std::string lower = string;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return lower;
}

bool parse_bool(const std::string& bool_string) {
  const std::string lower = to_lower_case(bool_string);
  if (lower != "true" && lower != "false") {
    throw std::invalid_argument("Input string : '" + bool_string +
                                "' is not a valid boolean value. Expected 'true' or 'false'.");
  }
  return lower == "true";
}

std::vector<std::string> parse_string_array(const std::string& string_array_string) {
  return parse_array<std::string>(string_array_string);
}

namespace detail {

std::int64_t whole_number(const std::string& s) {
  std::size_t end = 0;
  const std::int64_t value = std::stoll(s, &end);
  if (end != s.size()) {
    throw std::invalid_argument("Invalid characters in string");
  }
  return value;
}

std::vector<std::string> array_items(const std::string& array_string) {
  const std::string text = array_string;
  const bool is_flat = text.size() >= 2 && text.front() == '[' && text.back() == ']' &&
                       text.find_first_of("[]", 1) == text.size() - 1;
  if (!is_flat) {
    throw std::invalid_argument(
        "String must be a flat array: starts with '[' and ends with ']', no nested arrays");
  }
  const std::string inside = text.substr(1, text.size() - 2);
  std::vector<std::string> items;
  if (ros2_control::strip(inside).empty()) {
    return items;
  }
  for (std::size_t start = 0; start <= inside.size();) {
    const std::size_t comma = std::min(inside.find(',', start), inside.size());
    const std::string item = ros2_control::strip(inside.substr(start, comma - start));
    if (item.empty() || item.find_first_of(" \t\n") != std::string::npos) {
      throw std::invalid_argument(
          "String must be a flat array with comma-separated values and no spaces between them");
    }
    items.push_back(item);
    start = comma + 1;
  }
  return items;
}

}  // namespace detail
}  // namespace hardware_interface
