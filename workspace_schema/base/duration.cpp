// See duration.hpp.
#include "workspace_schema/base/duration.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace ros2wasm {
namespace {

struct DurationUnit {
  std::string_view name;
  double milliseconds;
};

constexpr auto kDurationUnits = std::to_array<DurationUnit>({
    {"ms", 1},
    {"s", 1000},
    {"m", 60'000},
    {"h", 3'600'000},
});
constexpr double kLongestMs = 7.0 * 24 * 3'600'000;

Diagnostic bad_duration(std::string_view text, std::string why, const std::string& fix = {}) {
  Diagnostic error{.code = "R2W0621",
                   .kind = FailureKind::kCommandLine,
                   .message = "`" + std::string(text) + "` is not a duration",
                   .why = {std::move(why)}};
  if (!fix.empty()) error.fix.push_back("write `" + fix + "`");
  return error;
}

/// Digits with at most one point among them: no sign, no exponent, no `inf`.
std::optional<double> plain_number(std::string_view text) {
  const bool plain = std::all_of(text.begin(), text.end(),
                                 [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
  if (!plain || text.empty() || text.front() == '.' || text.back() == '.') return std::nullopt;
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

Outcome<std::chrono::milliseconds> parse_duration(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
  const auto number = plain_number(text.substr(0, digits));
  const std::string_view unit_text = text.substr(digits);
  if (!number)
    return bad_duration(text, "a duration is a number and its unit: ms, s, m or h", "5s");
  const auto unit = std::find_if(kDurationUnits.begin(), kDurationUnits.end(),
                                 [&](const DurationUnit& each) { return each.name == unit_text; });
  if (unit_text.empty())
    return bad_duration(text, "the unit is missing: ms, s, m or h", std::string(text) + "s");
  if (unit == kDurationUnits.end()) {
    return bad_duration(text,
                        "there is no unit `" + std::string(unit_text) + "`: write ms, s, m or h");
  }
  const double milliseconds = *number * unit->milliseconds;
  if (milliseconds < 1) return bad_duration(text, "it is shorter than one millisecond");
  if (milliseconds > kLongestMs) return bad_duration(text, "it is longer than a week");
  return std::chrono::milliseconds(std::llround(milliseconds));
}

}  // namespace ros2wasm
