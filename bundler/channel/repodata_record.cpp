// See repodata_record.hpp.
#include "bundler/channel/repodata_record.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "workspace_schema/record_rules.hpp"
#include "workspace_schema/text_pattern.hpp"

namespace ros2wasm {
namespace {

constexpr std::array<std::string_view, 14> kMembers{
    "build",  "build_number", "constrains",     "depends", "license",
    "md5",    "name",         "noarch",         "sha256",  "size",
    "subdir", "timestamp",    "track_features", "version"};

/// "a b", "a,b", " a " or a list.
std::vector<std::string> feature_list(const JsonValue* value) {
  std::vector<std::string> features;
  if (value == nullptr) return features;
  const auto split = [&](std::string_view text) {
    std::string word;
    for (const char c : text) {
      if (c != ' ' && c != ',') {
        word += c;
      } else if (!word.empty()) {
        features.push_back(std::exchange(word, {}));
      }
    }
    if (!word.empty()) features.push_back(word);
  };
  if (const std::string* text = value->string()) split(*text);
  for (const JsonValue& item : value->items()) {
    if (const std::string* text = item.string()) split(*text);
  }
  std::sort(features.begin(), features.end());
  return features;
}

/// A reason when a spec of the list cannot be read.
std::optional<std::string> read_specs(const JsonValue& json, std::string_view key, SpecTable& table,
                                      std::vector<std::string>& specs) {
  const JsonValue* list = json.find(key);
  if (list == nullptr || list->is_null()) return std::nullopt;
  if (!list->is_array()) return "`" + std::string(key) + "` is not a list";
  specs.reserve(list->items().size());
  for (const JsonValue& item : list->items()) {
    const std::string* text = item.string();
    if (text == nullptr) return "`" + std::string(key) + "` holds something that is not text";
    if (table.checks()) {
      const auto& spec = table.parsed(*text);
      if (!spec) return "`" + std::string(key) + "`: " + spec.errors().front().message;
    }
    if (std::find(specs.begin(), specs.end(), *text) == specs.end()) specs.push_back(*text);
  }
  return std::nullopt;
}

std::optional<std::string> read_noarch(const JsonValue* value, NoarchKind& noarch) {
  if (value == nullptr || value->is_null()) return std::nullopt;
  if (const auto flag = value->boolean()) {
    noarch = *flag ? NoarchKind::kGeneric : NoarchKind::kNo;
    return std::nullopt;
  }
  const std::string* word = value->string();
  if (word == nullptr || (!word->empty() && *word != "generic" && *word != "python")) {
    return "`noarch` is neither true, `generic` nor `python`";
  }
  if (!word->empty()) noarch = *word == "python" ? NoarchKind::kPython : NoarchKind::kGeneric;
  return std::nullopt;
}

bool is_hex(const std::string& text, std::size_t digits) {
  return text.size() == digits && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

/// Old channels have seconds, newer ones milliseconds; no package is older than conda or from the
/// year 4000.
std::int64_t timestamp_ms(std::int64_t value) {
  constexpr std::int64_t kLargestSeconds = 64'060'588'799;
  if (value < 0) return 0;
  return value <= kLargestSeconds ? value * 1000 : value;
}

std::optional<std::string> read_hashes(const JsonValue& json, PackageRecord& record) {
  record.sha256 = ascii_lower(json.text_of("sha256"));
  record.md5 = ascii_lower(json.text_of("md5"));
  if (!record.sha256.empty() && !is_hex(record.sha256, 64))
    return "`sha256` is not 64 hexadecimal digits";
  if (!record.md5.empty() && !is_hex(record.md5, 32)) return "`md5` is not 32 hexadecimal digits";
  return std::nullopt;
}

std::optional<std::string> read_numbers(const JsonValue& json, PackageRecord& record) {
  if (const JsonValue* number = json.find("build_number");
      number != nullptr && !number->is_null()) {
    const auto value = number->unsigned_integer();
    if (!value) return "`build_number` is not a number";
    record.build_number = *value;
  }
  if (const JsonValue* size = json.find("size"); size != nullptr && !size->is_null()) {
    const auto value = size->unsigned_integer();
    if (!value) return "`size` is not a number";
    record.size = *value;
  }
  if (const JsonValue* time = json.find("timestamp"); time != nullptr) {
    record.timestamp_ms = timestamp_ms(time->integer().value_or(0));
  }
  return std::nullopt;
}

}  // namespace

bool is_record_member(std::string_view name) {
  return std::find(kMembers.begin(), kMembers.end(), name) != kMembers.end();
}

std::variant<PackageRecord, std::string> parse_record(const JsonValue& json,
                                                      const std::string& file_name,
                                                      const RecordPlace& place, SpecTable& specs) {
  if (!json.is_object()) return "it is not a JSON object";
  PackageRecord record{.name = ascii_lower(json.text_of("name")),
                       .version = json.text_of("version"),
                       .build = json.text_of("build"),
                       .subdir = place.subdir,
                       .channel = place.channel,
                       .file_name = file_name,
                       .url = place.base_url + "/" + file_name,
                       .license = json.text_of("license")};
  if (const std::string own = json.text_of("subdir"); is_subdir(own)) record.subdir = own;
  if (auto fault = record_fault(record, Strictness::kReading)) return *fault;
  if (const auto& fault = specs.version_fault(record.version)) return *fault;
  if (auto fault = read_hashes(json, record)) return *fault;
  if (auto fault = read_numbers(json, record)) return *fault;
  if (auto fault = read_noarch(json.find("noarch"), record.noarch)) return *fault;
  if (auto fault = read_specs(json, "depends", specs, record.depends)) return *fault;
  if (auto fault = read_specs(json, "constrains", specs, record.constrains)) return *fault;
  record.track_features = feature_list(json.find("track_features"));
  return record;
}

}  // namespace ros2wasm
