// workspace.yaml -> Manifest: every mistake at once, each with its place and, where one is proven,
// a way out. Pure; nothing here looks at the disk, so whether files and executables exist is
// checked elsewhere.
#pragma once

#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// A manifest of a site says what runs (`launch`); packages alone, for a channel, need none.
enum class ManifestUse { kSite, kPackages };

/// `file` is how the person named it; it appears in messages. Warnings are in `Manifest::warnings`.
/// R2W0101 not YAML, R2W0102 unknown key, R2W0103 wrong type or value, R2W0104 bad name, R2W0105
/// duplicate key, R2W0106 a required key is missing, R2W0107 schema, R2W0108 distro, R2W0109
/// parameters.
[[nodiscard]] Outcome<Manifest> read_manifest(std::string_view text, const std::string& file,
                                              ManifestUse use = ManifestUse::kSite);

}  // namespace ros2wasm
