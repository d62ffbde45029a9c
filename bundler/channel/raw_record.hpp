// The members of a record as its index writes them, before they are looked at: texts are views of
// the index, because most records are read and never chosen. Pure.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {

/// The members that a PackageRecord is made from; all others can be passed over.
enum class RecordMember : unsigned char {
  kBuild,
  kBuildNumber,
  kConstrains,
  kDepends,
  kLicense,
  kMd5,
  kName,
  kNoarch,
  kSha256,
  kSize,
  kSubdir,
  kTimestamp,
  kTrackFeatures,
  kVersion,
};

/// Nothing when no part of a record is made from the member of this name.
[[nodiscard]] std::optional<RecordMember> record_member(std::string_view name);
[[nodiscard]] std::string_view name_of(RecordMember member);

using Texts = std::vector<std::string_view>;

/// A hash that is not written as text.
struct HashBytes {
  std::string_view bytes;
};

/// Not there, a text, a list of nothing but texts, a hash as bytes, or anything else.
using RawMember = std::variant<std::monostate, std::string_view, Texts, HashBytes, JsonValue>;

/// As an array of JSON is; views are valid as long as the items.
[[nodiscard]] RawMember raw_member(const JsonValue& value);

/// Valid as long as what it was read from.
class RawRecord {
 public:
  [[nodiscard]] RawMember& operator[](RecordMember member) { return members_[at(member)]; }
  [[nodiscard]] const RawMember& operator[](RecordMember member) const {
    return members_[at(member)];
  }
  /// Empty when it is something else, or not there.
  [[nodiscard]] std::string_view text_of(RecordMember member) const;

 private:
  static std::size_t at(RecordMember member) { return static_cast<std::size_t>(member); }

  std::array<RawMember, 14> members_;
};

/// The members of an object that are in RecordMember.
[[nodiscard]] RawRecord raw_record(const JsonValue& json);

}  // namespace ros2wasm
