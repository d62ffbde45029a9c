// Compiled modules of Python wheels: WebAssembly that is linked into a running interpreter. What
// their section `dylink.0` says is held against the rest of the file, since the loader believes it.
// Pure; hostile input is safe.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ros2wasm {

struct SideModule {
  std::uint64_t memory_bytes = 0;   ///< for its data, in the interpreter's memory
  std::vector<std::string> needed;  ///< file names of libraries that must be loaded before
};

/// Why a module is not taken, to be completed with its name before it: "has no section ...".
struct SideModuleFault {
  std::string why;
};

/// A fault when it is not a side module, is damaged, places data outside the memory that it asks
/// for, asks for more than 256 MiB, imports from elsewhere than the interpreter, or brings
/// JavaScript.
[[nodiscard]] std::variant<SideModule, SideModuleFault> read_side_module(std::string_view bytes);

}  // namespace ros2wasm
