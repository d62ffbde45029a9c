// Which files of this machine `serve` answers with: those in the site's own folder, those in
// earlier packs of the site beside it, and the objects in the store that it shares. Nothing that a
// site says of itself makes anything else readable.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// An open file or folder; closed with the last copy.
using Descriptor = std::shared_ptr<const int>;

struct ServedPlace {
  std::filesystem::path
      folder;         ///< the site's, real; may be replaced by another folder at any time
  Descriptor parent;  ///< of `folder`, held open: its name is looked up there, whatever becomes of
                      ///< the path
  std::string address;          ///< path of the site in addresses, with `/` at the end; empty: `/`
  std::filesystem::path store;  ///< empty when the site has none
  Descriptor store_folder = nullptr;                 ///< held open
  std::string store_address;                         ///< as `address`
  std::optional<Diagnostic> warning = std::nullopt;  ///< R2W0613: its store is not served
};

/// A site that shares a store is served below a path, so that the store has one too. The store is
/// part of the place only when it is one that ros2wasm made.
[[nodiscard]] ServedPlace served_place(const std::filesystem::path& site);

enum class Lookup { kFile, kFolder, kNothing };

struct Found {
  Lookup kind = Lookup::kNothing;
  Descriptor file;             ///< open to be read: what is sent is what was looked at
  std::filesystem::path path;  ///< real, in one of the place's folders
  bool is_page = false;  ///< the page of a site, of an earlier pack, of a course or of a lab in it
  Descriptor root;       ///< the folder in which it was found,
  std::string below;     ///< and its path there, as it was asked for
};

/// `path` is that of an address without its first `/`, decoded, and has no `..`. Links are
/// followed; one that leads out of its folder finds nothing, also when it is changed meanwhile.
[[nodiscard]] Found find_served(const ServedPlace& place, const std::string& path);

/// The file beside it whose name has this ending too. Links are not followed.
[[nodiscard]] Found form_beside(const Found& found, std::string_view ending);

}  // namespace ros2wasm
