// Where the files of a site lie. Most sites have them beside site.json, under their paths. Sites
// that share a store have there, under its sha256, what does not belong to them alone; and a file
// that is too large for a host lies in parts. Pure; runtime/site/contract/site_places.ts is the
// same.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

struct SiteStore {
  std::string objects;  ///< relative to site.json, with `/` at the end; empty: there is none
  std::string scripts;  ///< folder there of the page's modules, which find each other by name
};

enum class Kept { kBeside, kObject, kScript };

struct FilePart {
  std::uint64_t size = 0;
  std::string sha256;
};

/// `../objects/`: upwards, and then into folders with plain names.
[[nodiscard]] bool is_store_address(std::string_view address);

/// Relative to site.json; of a file in parts more than one, in their order.
[[nodiscard]] std::vector<std::string> site_places(const std::string& path,
                                                   const std::string& sha256, Kept kept,
                                                   const std::vector<FilePart>& parts,
                                                   const SiteStore& store);

/// Beside the objects of a store: it proves that `pack` made the folder.
inline constexpr const char* kStoreMarker = "store.json";
/// The bytes of that file: the same whatever sites are in the store.
inline constexpr std::string_view kStoreMarkerText = "{\"generator\":\"ros2wasm\",\"store\":1}\n";

/// A name that site_places() gives to something directly in a store: 64 hex digits, which an ending
/// such as `.wasm`, `.part` or `.wasm.br` may follow.
[[nodiscard]] bool is_store_name(std::string_view name);

/// A place in a store, relative to it: an object, or a module in a folder of modules.
[[nodiscard]] bool is_store_path(std::string_view path);

/// As site.json says it; empty for what lies beside it.
[[nodiscard]] std::string_view word_of(Kept kept);

}  // namespace ros2wasm
