// Features of an operating system that no browser has, by the symbol that an object refers to or
// the header that a source includes. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

struct BrowserLimit {
  std::string_view what;     ///< "sockets"
  std::string_view instead;  ///< what can be done
  bool only_fails = false;   ///< such a call has no effect, as on a system that refuses it, and
                             ///< programs are used to that; else the program is of no use
};

/// Null when a browser has it, or when nothing is known of it.
[[nodiscard]] const BrowserLimit* limit_of_symbol(std::string_view symbol);

/// `header` as it is included.
[[nodiscard]] const BrowserLimit* limit_of_header(std::string_view header);

/// The lines that a message adds about such a header; empty when it has no limit.
[[nodiscard]] std::vector<std::string> told_of_header(std::string_view header);

/// The symbols with a limit, without those that only a family of names tells: a C library may
/// define them nevertheless, so that no link misses them.
[[nodiscard]] std::vector<std::string_view> limited_symbols();

}  // namespace ros2wasm
