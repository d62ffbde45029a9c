// See repodata_record.hpp.
#include "bundler/channel/repodata_record.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/conda/record_rules.hpp"

namespace ros2wasm {
namespace {

/// In a list of dependencies; real packages have a few hundred at most.
constexpr std::size_t kMostSpecs = 10'000;

/// A text that stands alone counts as one of a list.
template <typename Take>
void each_text(const RawMember& member, const Take& take) {
  if (const auto* text = std::get_if<std::string_view>(&member)) take(*text);
  if (const auto* texts = std::get_if<Texts>(&member)) {
    for (const std::string_view text : *texts) take(text);
  }
  if (const auto* value = std::get_if<JsonValue>(&member)) {
    for (const JsonValue& item : value->items()) {
      if (const std::string* text = item.string()) take(*text);
    }
  }
}

/// "a b", "a,b", " a " or a list.
std::vector<std::string> feature_list(const RawMember& member) {
  std::vector<std::string> features;
  each_text(member, [&](std::string_view text) {
    std::string word;
    for (const char c : text) {
      if (c != ' ' && c != ',') {
        word += c;
      } else if (!word.empty()) {
        features.push_back(std::exchange(word, {}));
      }
    }
    if (!word.empty()) features.push_back(word);
  });
  std::sort(features.begin(), features.end());
  return features;
}

bool is_absent(const RawMember& member) {
  const auto* value = std::get_if<JsonValue>(&member);
  return std::holds_alternative<std::monostate>(member) || (value != nullptr && value->is_null());
}

/// A reason when a spec of the list cannot be read.
std::optional<std::string> read_specs(const RawRecord& raw, RecordMember member, SpecTable& table,
                                      std::vector<std::string>& specs) {
  if (is_absent(raw[member])) return std::nullopt;
  const auto quoted = [member] { return "`" + std::string(name_of(member)) + "`"; };
  const auto* texts = std::get_if<Texts>(&raw[member]);
  if (texts == nullptr) {
    const auto* value = std::get_if<JsonValue>(&raw[member]);
    return quoted() + (value != nullptr && value->is_array() ? " holds something that is not text"
                                                             : " is not a list");
  }
  if (texts->size() > kMostSpecs)
    return quoted() + " has more than " + std::to_string(kMostSpecs) + " items";
  specs.reserve(texts->size());
  for (const std::string_view text : *texts) {
    if (std::find(specs.begin(), specs.end(), text) != specs.end()) continue;
    specs.emplace_back(text);
    if (!table.checks()) continue;
    const auto& spec = table.parsed(specs.back());
    if (!spec) return quoted() + ": " + spec.errors().front().message;
  }
  return std::nullopt;
}

std::optional<std::string> read_noarch(const RawRecord& raw, NoarchKind& noarch) {
  const RawMember& member = raw[RecordMember::kNoarch];
  if (is_absent(member)) return std::nullopt;
  const auto* value = std::get_if<JsonValue>(&member);
  if (const auto flag = value == nullptr ? std::nullopt : value->boolean()) {
    noarch = *flag ? NoarchKind::kGeneric : NoarchKind::kNo;
    return std::nullopt;
  }
  const auto* word = std::get_if<std::string_view>(&member);
  if (word == nullptr || (!word->empty() && *word != "generic" && *word != "python")) {
    return "`noarch` is neither true, `generic` nor `python`";
  }
  if (!word->empty()) noarch = *word == "python" ? NoarchKind::kPython : NoarchKind::kGeneric;
  return std::nullopt;
}

/// Maps a hexadecimal digit to itself in lower case, any other character to zero.
constexpr auto kHexDigits = [] {
  std::array<char, 256> digits{};
  for (const char c : std::string_view("0123456789abcdef"))
    digits.at(static_cast<unsigned char>(c)) = c;
  for (const char c : std::string_view("ABCDEF"))
    digits.at(static_cast<unsigned char>(c)) = static_cast<char>(c - 'A' + 'a');
  return digits;
}();

/// False when the hash is there and does not have this many hexadecimal digits.
bool read_hash(const RawRecord& raw, RecordMember member, std::size_t digits, std::string& hash) {
  if (const auto* known = std::get_if<HashBytes>(&raw[member])) {
    hash = hex_text(known->bytes);
    return hash.empty() || hash.size() == digits;
  }
  const std::string_view text = raw.text_of(member);
  if (text.empty()) return true;
  if (text.size() != digits) return false;
  hash.resize(digits);
  bool all = true;
  for (std::size_t i = 0; i < digits; ++i) {
    hash[i] = kHexDigits[static_cast<unsigned char>(text[i])];
    all = all && hash[i] != 0;
  }
  return all;
}

/// Old channels have seconds, newer ones milliseconds; no package is older than conda or from the
/// year 4000.
std::int64_t timestamp_ms(std::int64_t value) {
  constexpr std::int64_t kLargestSeconds = 64'060'588'799;
  if (value < 0) return 0;
  return value <= kLargestSeconds ? value * 1000 : value;
}

std::optional<std::string> read_hashes(const RawRecord& raw, PackageRecord& record) {
  if (!read_hash(raw, RecordMember::kSha256, 64, record.sha256))
    return "`sha256` is not 64 hexadecimal digits";
  if (!read_hash(raw, RecordMember::kMd5, 32, record.md5))
    return "`md5` is not 32 hexadecimal digits";
  return std::nullopt;
}

/// A reason when it is there and no number.
std::optional<std::string> read_number(const RawRecord& raw, RecordMember member,
                                       std::uint64_t& number) {
  if (is_absent(raw[member])) return std::nullopt;
  const auto* json = std::get_if<JsonValue>(&raw[member]);
  const auto value = json == nullptr ? std::nullopt : json->unsigned_integer();
  if (!value) return "`" + std::string(name_of(member)) + "` is not a number";
  number = *value;
  return std::nullopt;
}

std::int64_t read_time(const RawMember& member) {
  const auto* json = std::get_if<JsonValue>(&member);
  return json == nullptr ? 0 : timestamp_ms(json->integer().value_or(0));
}

}  // namespace

std::variant<PackageRecord, std::string> parse_record(const RawRecord& raw,
                                                      const std::string& file_name,
                                                      const RecordPlace& place, SpecTable& specs) {
  PackageRecord record{.name = ascii_lower(raw.text_of(RecordMember::kName)),
                       .version = std::string(raw.text_of(RecordMember::kVersion)),
                       .build = std::string(raw.text_of(RecordMember::kBuild)),
                       .subdir = place.subdir,
                       .channel = place.channel,
                       .file_name = file_name,
                       .url = {},
                       .license = std::string(raw.text_of(RecordMember::kLicense))};
  record.url.reserve(place.base_url.size() + 1 + file_name.size());
  record.url.append(place.base_url).append("/").append(file_name);
  if (const auto own = raw.text_of(RecordMember::kSubdir); own != record.subdir && is_subdir(own))
    record.subdir = own;
  if (auto fault = record_fault(record, Strictness::kReading)) return *fault;
  if (const auto& fault = specs.version_fault(record.version)) return *fault;
  if (auto fault = read_hashes(raw, record)) return *fault;
  if (auto fault = read_number(raw, RecordMember::kBuildNumber, record.build_number)) return *fault;
  if (auto fault = read_number(raw, RecordMember::kSize, record.size)) return *fault;
  record.timestamp_ms = read_time(raw[RecordMember::kTimestamp]);
  if (auto fault = read_noarch(raw, record.noarch)) return *fault;
  if (auto fault = read_specs(raw, RecordMember::kDepends, specs, record.depends)) return *fault;
  if (auto fault = read_specs(raw, RecordMember::kConstrains, specs, record.constrains))
    return *fault;
  record.track_features = feature_list(raw[RecordMember::kTrackFeatures]);
  return record;
}

}  // namespace ros2wasm
