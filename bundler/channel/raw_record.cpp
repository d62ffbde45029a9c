// See raw_record.hpp.
#include "bundler/channel/raw_record.hpp"

#include <algorithm>

namespace ros2wasm {
namespace {

/// In the order of RecordMember.
constexpr std::array<std::string_view, 14> kMembers{
    "build",  "build_number", "constrains",     "depends", "license",
    "md5",    "name",         "noarch",         "sha256",  "size",
    "subdir", "timestamp",    "track_features", "version"};

}  // namespace

std::optional<RecordMember> record_member(std::string_view name) {
  const auto found = std::find_if(kMembers.begin(), kMembers.end(), [name](std::string_view one) {
    // Nearly all comparisons end with the first letter, which saves the call.
    return one.size() == name.size() && one.front() == name.front() && one == name;
  });
  if (found == kMembers.end()) return std::nullopt;
  return static_cast<RecordMember>(found - kMembers.begin());
}

std::string_view name_of(RecordMember member) {
  return kMembers.at(static_cast<std::size_t>(member));
}

RawMember raw_member(const JsonValue& value) {
  if (const std::string* text = value.string()) return std::string_view(*text);
  if (!value.is_array()) return value;
  Texts texts;
  for (const JsonValue& item : value.items()) {
    const std::string* text = item.string();
    if (text == nullptr) return value;
    texts.push_back(*text);
  }
  return texts;
}

std::string_view RawRecord::text_of(RecordMember member) const {
  const RawMember& raw = (*this)[member];
  if (const auto* text = std::get_if<std::string_view>(&raw)) return *text;
  const auto* value = std::get_if<JsonValue>(&raw);
  const std::string* text = value == nullptr ? nullptr : value->string();
  return text == nullptr ? std::string_view() : std::string_view(*text);
}

RawRecord raw_record(const JsonValue& json) {
  RawRecord record;
  for (const auto& [key, value] : json.members()) {
    if (const auto member = record_member(key)) record[*member] = raw_member(value);
  }
  return record;
}

}  // namespace ros2wasm
