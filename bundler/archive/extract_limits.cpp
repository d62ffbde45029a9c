// See extract_limits.hpp.
#include "bundler/archive/extract_limits.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

Diagnostic no_limits(const std::string& text, std::string why) {
  return Diagnostic{.code = "R2W0241",
                    .kind = FailureKind::kCommandLine,
                    .message = "`" + text + "` does not say how large an archive may be",
                    .why = {std::move(why)}};
}

/// A whole number from 1; with `units`, K, M or G may stand behind it.
std::optional<std::uint64_t> count_of(std::string_view text, bool units) {
  unsigned shift = 0;
  if (units && !text.empty()) {
    const std::size_t unit = std::string_view("KMG").find(text.back());
    if (unit != std::string_view::npos) {
      shift = 10U * (static_cast<unsigned>(unit) + 1U);
      text.remove_suffix(1);
    }
  }
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number == 0) return std::nullopt;
  if (number > std::numeric_limits<std::uint64_t>::max() >> shift) return std::nullopt;
  return number << shift;
}

}  // namespace

Outcome<ExtractLimits> read_extract_limits(std::string_view text) {
  static const std::vector<std::string> kKeys{"size", "members", "ratio"};
  ExtractLimits limits;
  std::set<std::string> seen;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string part(rest.substr(0, rest.find(',')));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string key = part.substr(0, equals);
    const std::string value = equals == part.size() ? "" : part.substr(equals + 1);
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
      Diagnostic error = no_limits(part, "the limits are: " + name_list(kKeys));
      if (const auto near = nearest(key, kKeys); near && count_of(value, *near == "size"))
        error.fix.push_back("write `" + *near + "=" + value + "`");
      return error;
    }
    if (!seen.insert(key).second) return no_limits(part, "`" + key + "` is there twice");
    const bool is_size = key == "size";
    const auto count = count_of(value, is_size);
    if (!count) {
      return no_limits(part, is_size ? "a size is a whole number of bytes from 1, or of K, M or G, "
                                       "such as `size=16G`"
                                     : "`" + key + "` is a whole number from 1");
    }
    if (is_size) limits.total_bytes = *count;
    if (key == "members") limits.members = *count;
    if (key == "ratio") limits.ratio = *count;
  }
  return limits;
}

Diagnostic ExtractMeter::too_much(const std::string& why) const {
  return Diagnostic{.code = "R2W0225",
                    .kind = FailureKind::kEnvironment,
                    .message = "the archive of `" + name_ + "` was refused",
                    .why = {why, "nothing of it was stored"}};
}

Outcome<ExtractLimits> extract_limits_of(std::string_view flag,
                                         const std::map<std::string, std::string>& variables) {
  const auto said = variables.find(kExtractLimitsVariable);
  return read_extract_limits(flag.empty() && said != variables.end() ? said->second : flag);
}

Outcome<Done> ExtractMeter::member() {
  if (++members_ <= limits_.members) return Done{};
  return too_much("it has more than " + std::to_string(limits_.members) +
                  " members; for one that you trust, say `--archive-limits members=N`");
}

Outcome<Done> ExtractMeter::bytes(std::uint64_t count) {
  total_bytes_ += count;
  if (total_bytes_ > limits_.total_bytes) {
    return too_much("it unpacks to more than " + std::to_string(limits_.total_bytes) +
                    " bytes; for one that you trust, say `--archive-limits size=N`");
  }
  if (total_bytes_ > limits_.ratio_from_bytes && total_bytes_ / limits_.ratio > packed_bytes_) {
    return too_much("it unpacks to more than " + std::to_string(limits_.ratio) +
                    " times its own size; for one that you trust, say `--archive-limits ratio=N`");
  }
  return Done{};
}

}  // namespace ros2wasm
