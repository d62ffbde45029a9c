// Finds the Node.js that runs sites without a browser.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "workspace_schema/cancellation.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// The oldest major version with all that the runtime needs (WebAssembly exceptions, module
/// workers, growable shared memory).
constexpr int kOldestNodeJs = 22;

/// "v26.10.0\n" -> 26; nothing when it is no version.
[[nodiscard]] std::optional<int> node_js_major(std::string_view version_text);

/// The Node.js that npm pinned for this installation, else `node` of PATH when it is new enough.
/// R2W0620 there is none, or only an older one.
[[nodiscard]] Outcome<std::filesystem::path> find_node_js(const std::filesystem::path& executable,
                                                          std::string_view path_variable,
                                                          const Cancellation& cancellation);

}  // namespace ros2wasm
