// How much an archive may unpack to, and the counting of it. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct ExtractLimits {
  std::uint64_t total_bytes = 8ULL << 30U;  ///< of all files together
  std::uint64_t members = 500'000;
  std::uint64_t ratio = 250;                      ///< unpacked to packed bytes ...
  std::uint64_t ratio_from_bytes = 64ULL << 20U;  ///< ... once this much was unpacked
};

/// The variable of the environment that holds limits for every command.
inline constexpr const char* kExtractLimitsVariable = "ROS2WASM_ARCHIVE_LIMITS";

/// "size=16G,members=1000000,ratio=500", each part at most once; what is not said keeps its
/// default, an empty text keeps all. Sizes are bytes, or end with K, M or G (1024 each). R2W0241.
[[nodiscard]] Outcome<ExtractLimits> read_extract_limits(std::string_view text);

/// The limits of the flag; when the flag is empty, those of the environment variable. R2W0241.
[[nodiscard]] Outcome<ExtractLimits> extract_limits_of(
    std::string_view flag, const std::map<std::string, std::string>& variables);

/// Counts what comes out of one archive. R2W0225 as soon as it is too much.
class ExtractMeter {
 public:
  /// `name` is for messages; both must live as long as the meter.
  ExtractMeter(const ExtractLimits& limits, const std::string& name, std::uint64_t packed_bytes)
      : limits_(limits), name_(name), packed_bytes_(packed_bytes) {}

  [[nodiscard]] Outcome<Done> member();
  [[nodiscard]] Outcome<Done> bytes(std::uint64_t count);
  [[nodiscard]] std::uint64_t total_bytes() const { return total_bytes_; }

 private:
  [[nodiscard]] Diagnostic too_much(const std::string& why) const;

  const ExtractLimits& limits_;
  const std::string& name_;
  std::uint64_t packed_bytes_;
  std::uint64_t members_ = 0;
  std::uint64_t total_bytes_ = 0;
};

}  // namespace ros2wasm
