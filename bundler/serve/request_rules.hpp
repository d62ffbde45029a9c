// The meaning of the parts of a request: path, host, conditions, ranges. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// The path below the site that a request target asks for: decoded, without leading slash and
/// query; empty for the root, with a `/` at the end when the target had one. Nothing when it is no
/// such path: bad escapes, `.` and `..` segments, empty segments, encoded slashes, backslashes,
/// control characters.
[[nodiscard]] std::optional<std::string> site_path_of(std::string_view target);

/// Whether a `Host` header names this machine: `localhost`, a name below it, or an address. A page
/// of another site that has its own name point here (DNS rebinding) does not pass.
[[nodiscard]] bool is_local_host(std::string_view host_header);

/// Whether a server that listens on `host` is reached from this machine alone: `localhost` in any
/// case, or an address of the machine itself in any of its spellings.
[[nodiscard]] bool is_loopback(const std::string& host);

/// Whether `if_none_match` (a list of entity tags, or `*`) has this one.
[[nodiscard]] bool matches_etag(std::string_view if_none_match, std::string_view etag);

struct ByteRange {
  std::uint64_t first = 0;
  std::uint64_t length = 0;
};
enum class RangeAnswer { kWhole, kPart, kUnsatisfiable };
struct RangeResult {
  RangeAnswer answer = RangeAnswer::kWhole;
  ByteRange range;  ///< of kPart
};

/// The part of `size` bytes that a `Range` header requests. Several ranges and other units get the
/// whole, as RFC 9110 allows.
[[nodiscard]] RangeResult range_of(std::string_view header, std::uint64_t size);

}  // namespace ros2wasm
