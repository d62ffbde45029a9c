// Reads what objects and archives of objects define, and makes definitions weak. The forms: ar as
// GNU writes it; "linking" sections of the WebAssembly tool conventions, version 2. Pure; hostile
// input is safe.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

struct ObjectSymbol {
  std::string name;
  std::size_t flags = 0;   ///< offset of the first byte of its flags
  bool is_hidden = false;  ///< natively nobody outside its library sees it
};

/// The strong definitions that other objects see. Nothing when `object` is not a WebAssembly
/// object.
[[nodiscard]] std::optional<std::vector<ObjectSymbol>> strong_definitions(std::string_view object);

/// Those of each member of an archive, with offsets in the archive. Members that are no objects
/// define nothing. Nothing when `archive` is not an archive, or a damaged one.
[[nodiscard]] std::optional<std::vector<ObjectSymbol>> archive_definitions(
    std::string_view archive);

/// The members of an archive. Nothing when `archive` is not an archive, or a damaged one.
[[nodiscard]] std::optional<std::vector<std::string_view>> archive_members(
    std::string_view archive);

/// `bytes` is an object or an archive, `symbol` one of its strong definitions.
void make_weak(std::string& bytes, const ObjectSymbol& symbol);

/// The archive has the member that stands for "natively a shared library"
/// (modules/add_library.cmake of the toolchain): an object with nothing in it.
[[nodiscard]] bool is_natively_shared(std::string_view archive);

}  // namespace ros2wasm
