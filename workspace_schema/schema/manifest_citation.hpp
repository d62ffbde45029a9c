// Reads who made a workspace and how it is cited: `authors` and `citation` of the manifest.
#pragma once

#include <optional>

#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// An item of `authors`: a name, `name <mail>`, or a mapping with `name`.
[[nodiscard]] std::optional<Author> read_author(Binder& binder, const YamlNode& node);

/// `citation`, with its required `date_released`. `root` is the manifest: who is cited must be
/// named there.
[[nodiscard]] std::optional<Citation> read_citation(Binder& binder, const YamlNode& node,
                                                    const YamlNode& root);

}  // namespace ros2wasm
