// See wheel_name.hpp.
#include "workspace_schema/conda/wheel_name.hpp"

#include <algorithm>
#include <vector>

namespace ros2wasm {
namespace {

constexpr std::string_view kEnding = ".whl";
constexpr std::string_view kPureTags = "-none-any";

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(at); end != std::string_view::npos; end = text.find(at)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_part(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter_or_digit(c) || c == '_' || c == '.' || c == '+' || c == '!';
  });
}

}  // namespace

bool WheelName::is_pure() const {
  if (!tags.ends_with(kPureTags)) return false;
  const auto pythons = split(std::string_view(tags).substr(0, tags.size() - kPureTags.size()), '.');
  return std::find(pythons.begin(), pythons.end(), "py3") != pythons.end();
}

std::optional<WheelName> wheel_name(std::string_view file_name) {
  if (!file_name.ends_with(kEnding)) return std::nullopt;
  const auto parts = split(file_name.substr(0, file_name.size() - kEnding.size()), '-');
  if (parts.size() != 5 && parts.size() != 6) return std::nullopt;  // with a build number
  if (!std::all_of(parts.begin(), parts.end(), is_part)) return std::nullopt;
  const auto tags = parts.end() - 3;
  return WheelName{
      .project = std::string(parts[0]),
      .version = std::string(parts[1]),
      .tags = std::string(tags[0]) + "-" + std::string(tags[1]) + "-" + std::string(tags[2])};
}

std::string normal_project_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (is_letter_or_digit(c)) {
      result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!result.ends_with('-')) {
      result += '-';
    }
  }
  return result;
}

}  // namespace ros2wasm
