// Finds where the records of a repodata.json lie, without parsing them. Pure. The text comes in
// pieces, so that a large index need not be in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// One member of `packages` or `packages.conda`: `"x-1.0-0.conda": {...}`.
struct FoundRecord {
  std::string_view name;     ///< as the record says it; empty when it says none
  std::string_view text;     ///< key and value; both views are valid while it is reported
  std::uint64_t offset = 0;  ///< in the whole text, of the key's first quote
  bool conda = false;        ///< in `packages.conda`
};

class RepodataScanner {
 public:
  explicit RepodataScanner(std::function<void(const FoundRecord&)> found)
      : found_(std::move(found)) {}

  /// Describes a fault of the text, or nothing.
  [[nodiscard]] std::optional<std::string> feed(std::string_view piece);
  /// To be called once, after the last piece.
  [[nodiscard]] std::optional<std::string> finish();

  /// The values of these keys as JSON text; empty when they are not there.
  [[nodiscard]] const std::string& info() const { return info_; }
  [[nodiscard]] const std::string& removed() const { return removed_; }

 private:
  enum class Place { kBegin, kFirstKey, kKey, kComma, kFirstRecord, kRecord, kRecordComma, kEnd };
  enum class Step { kDone, kMore, kFault };

  Step step();
  Step member();
  Step record();
  Step expect(char first, Place then_first, char second, Place then_second);

  std::function<void(const FoundRecord&)> found_;
  Place place_ = Place::kBegin;
  bool conda_ = false;
  std::string kept_;          ///< bytes that wait for the rest of what they begin
  std::string_view text_;     ///< bytes that are looked at
  std::size_t at_ = 0;        ///< in text_
  std::uint64_t passed_ = 0;  ///< bytes before text_
  std::string info_;
  std::string removed_;
};

}  // namespace ros2wasm
