// See byte_size.hpp.
#include "workspace_schema/base/byte_size.hpp"

#include <algorithm>
#include <array>

namespace ros2wasm {
namespace {

struct SizeUnit {
  std::string_view name;
  std::uint64_t bytes;
};

constexpr std::array<SizeUnit, 7> kSizeUnits{{{"B", 1},
                                              {"kB", 1'000},
                                              {"MB", 1'000'000},
                                              {"GB", 1'000'000'000},
                                              {"KiB", 1ULL << 10U},
                                              {"MiB", 1ULL << 20U},
                                              {"GiB", 1ULL << 30U}}};
constexpr std::size_t kMostDigits = 6;  // before the point: no product below leaves 64 bits
constexpr std::size_t kMostDecimals = 3;

bool is_decimal(char c) {
  return c >= '0' && c <= '9';
}

std::size_t digits_of(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_decimal) -
                                  text.begin());
}

/// "12.5 MB" -> "12.5" and "MB".
std::pair<std::string_view, std::string_view> split(std::string_view text) {
  std::size_t end = digits_of(text);
  if (end < text.size() && text[end] == '.') end += 1 + digits_of(text.substr(end + 1));
  const std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  if (text.starts_with(' ')) text.remove_prefix(1);
  return {number, text};
}

std::optional<std::uint64_t> thousandths(std::string_view number) {
  const std::size_t whole = digits_of(number);
  if (whole == 0 || whole > kMostDigits) return std::nullopt;
  const bool has_point = whole < number.size();
  const std::string_view decimals = has_point ? number.substr(whole + 1) : std::string_view();
  if (decimals.size() > kMostDecimals || (has_point && decimals.empty())) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : number.substr(0, whole)) value = value * 10 + static_cast<unsigned>(c - '0');
  for (std::size_t i = 0; i < kMostDecimals; ++i) {
    value = value * 10 + (i < decimals.size() ? static_cast<unsigned>(decimals[i] - '0') : 0);
  }
  return value;
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

}  // namespace

std::optional<std::uint64_t> parse_byte_size(std::string_view text) {
  const auto [number, name] = split(text);
  const auto unit = std::find_if(kSizeUnits.begin(), kSizeUnits.end(),
                                 [&name = name](const SizeUnit& one) { return one.name == name; });
  const auto value = thousandths(number);
  if (unit == kSizeUnits.end() || !value) return std::nullopt;
  return *value * unit->bytes / 1000;
}

std::optional<std::string> meant_byte_size(std::string_view text) {
  const auto [number, name] = split(text);
  const std::string asked = lowered(name);
  if (!thousandths(number) || asked.empty()) return std::nullopt;
  for (const SizeUnit& unit : kSizeUnits) {
    const std::string known = lowered(unit.name);
    if (asked == known || (known.size() > 1 && asked == known.substr(0, known.size() - 1)))
      return std::string(number) + " " + std::string(unit.name);
  }
  return std::nullopt;
}

std::string byte_size_text(std::uint64_t bytes) {
  SizeUnit unit = kSizeUnits[0];
  for (std::size_t i = 1; i < 4; ++i) {
    if (bytes >= kSizeUnits.at(i).bytes) unit = kSizeUnits.at(i);
  }
  std::string text = std::to_string(bytes / unit.bytes);
  if (unit.bytes > 1) {
    const std::uint64_t hundredths = bytes % unit.bytes / (unit.bytes / 100);
    text += "." + std::string(hundredths < 10 ? "0" : "") + std::to_string(hundredths);
  }
  return text + " " + std::string(unit.name);
}

}  // namespace ros2wasm
