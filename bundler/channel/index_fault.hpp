// Is a file the index that its name says? Looked at when it has come over the network, where a
// login page or a broken proxy may answer in a server's place. An edge: it reads the file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// R2W0202 when the file cannot be unpacked to its end or is not of its form; nothing when it is
/// well. `url` says the form and is for messages.
[[nodiscard]] std::optional<Diagnostic> index_fault(const std::filesystem::path& file,
                                                    const std::string& url);

}  // namespace ros2wasm
