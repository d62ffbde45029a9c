// The link line that CMake writes, and the two link commands made from it. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/archive/wasm_module.hpp"

namespace ros2wasm {

/// How a program is linked: alone, or with threads in a shared memory. Objects are the same for
/// both.
enum class LinkKind { kSingle, kThreads };

struct LinkLine {
  std::string compiler;  ///< emcc or em++
  std::string output;    ///< what follows -o
  std::vector<std::string>
      arguments;  ///< objects, libraries and options, without what a site has no use for
  std::string thread_support;  ///< source of what the loader asks of programs with threads
};

/// `command` is the compiler and its arguments, response files already expanded.
[[nodiscard]] LinkLine parse_link_line(const std::vector<std::string>& command);

/// The arguments of one response file (quotes and backslashes as GNU tools have them).
[[nodiscard]] std::vector<std::string> split_response_file(std::string_view text);

/// Where single_link_object() must lie for kSingle: `<stem>` with this added.
inline constexpr const char* kSingleLinkObjectSuffix = ".single_link.o";

/// The compiler's whole command for one kind. kSingle writes `<stem>.wasm`, kThreads also
/// JavaScript, which nobody needs.
[[nodiscard]] std::vector<std::string> link_command(const LinkLine& line, LinkKind kind,
                                                    const std::string& stem);

/// The findings about the imports of a singly linked program.
struct ImportFindings {
  bool needs_threads = false;
  std::vector<std::string>
      undefined;  ///< symbols nobody defines (as the linker writes them), sorted
};

[[nodiscard]] ImportFindings classify_imports(const WasmModule& module);

/// `foo::bar(int)` for `_ZN3foo3barEi`; other names unchanged.
[[nodiscard]] std::string demangled(const std::string& symbol);

}  // namespace ros2wasm
