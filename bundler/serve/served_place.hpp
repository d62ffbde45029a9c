// Which files of this machine `serve` answers with: those in the site's own folder, those in
// earlier packs of the site beside it, and the objects in the store that it shares. Nothing that a
// site says of itself makes anything else readable.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

struct ServedPlace {
  std::filesystem::path folder;  ///< the site's; may be replaced by another folder at any time
  std::string address;           ///< path of the site in addresses, with `/` at the end; empty: `/`
  std::filesystem::path store;   ///< empty when the site has none
  std::string store_address;     ///< as `address`
  std::optional<Diagnostic> warning = std::nullopt;  ///< R2W0613: its store is not served
};

/// A site that shares a store is served below a path, so that the store has one too. The store is
/// part of the place only when it is one that ros2wasm made.
[[nodiscard]] ServedPlace served_place(const std::filesystem::path& site);

enum class Lookup { kFile, kFolder, kNothing };

struct Found {
  Lookup kind = Lookup::kNothing;
  std::filesystem::path path;  ///< real, in one of the place's folders
};

/// `path` is that of an address without its first `/`, decoded, and has no `..`. Links are
/// followed; one that leads out of its folder finds nothing.
[[nodiscard]] Found find_served(const ServedPlace& place, const std::string& path);

}  // namespace ros2wasm
