// Finds the Node.js that runs sites without a browser, and Pyodide for setup.py.
#pragma once

#include <compare>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Major and minor.
struct NodeJsVersion {
  int major = 0;
  int minor = 0;
  auto operator<=>(const NodeJsVersion&) const = default;
};

/// The oldest with all that is needed: WebAssembly exceptions, module workers, growable shared
/// memory, `--permission`.
constexpr NodeJsVersion kOldestNodeJs{.major = 22, .minor = 13};

/// "v26.10.0\n" -> 26, 10; nothing when it is not a version.
[[nodiscard]] std::optional<NodeJsVersion> node_js_version(std::string_view version_text);

/// The Node.js that npm pinned for this installation, else `node` of PATH when it is new enough.
/// R2W0620 there is none, or only an older one.
[[nodiscard]] Outcome<std::filesystem::path> find_node_js(const std::filesystem::path& executable,
                                                          std::string_view path_variable,
                                                          const Cancellation& cancellation);

}  // namespace ros2wasm
