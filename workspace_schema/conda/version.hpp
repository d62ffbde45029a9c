// A conda version: parsed, ordered and matched as conda's VersionOrder does (CEP 33).
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// One run of digits or of other characters. Order: `*` < `dev` < `_` < letters < numbers < `post`.
struct VersionAtom {
  enum class Kind : unsigned char { kText, kNumber, kPost };
  Kind kind = Kind::kNumber;
  /// kNumber: decimal digits without leading zeros ("0" for zero), of any length. kText: lower
  /// case, with "dev" as "DEV" so that it sorts first. kPost: empty.
  std::string text = "0";

  std::strong_ordering operator<=>(const VersionAtom& other) const;
  bool operator==(const VersionAtom& other) const = default;
};

using VersionSegment = std::vector<VersionAtom>;

class Version {
 public:
  /// R2W0304 with the reason.
  [[nodiscard]] static Outcome<Version> parse(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }  ///< as given, trimmed
  /// Epoch first, then the segments: what conda calls `VersionOrder.version`.
  [[nodiscard]] const std::vector<VersionSegment>& segments() const { return segments_; }
  [[nodiscard]] const std::vector<VersionSegment>& local() const { return local_; }

  /// 1.2 == 1.2.0; letter case does not count.
  std::strong_ordering operator<=>(const Version& other) const;
  bool operator==(const Version& other) const { return (*this <=> other) == 0; }

  /// Fuzzy equality: does this version begin with `prefix`? 1.8.3 and 1.8alpha begin with 1.8.
  [[nodiscard]] bool starts_with(const Version& prefix) const;

 private:
  static constexpr std::size_t kPlainNumbers = 5;  ///< the epoch is one of them
  void note_plain();

  std::string text_;
  std::vector<VersionSegment> segments_;
  std::vector<VersionSegment> local_;
  /// Most versions are a few small numbers and are compared by these alone.
  bool plain_ = false;
  std::array<std::uint32_t, kPlainNumbers> numbers_{};
};

/// Conda's nested list as JSON, of Version::segments() or local(): `[[0],[1],[2,"rc",1]]`, with
/// `post` (conda's infinity) as 1e999, which JSON readers take for infinity.
[[nodiscard]] std::string version_json(const std::vector<VersionSegment>& segments);

}  // namespace ros2wasm
