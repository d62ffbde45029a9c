// The demands of a compiled file of a package on the programs that it is linked into. Pure; hostile
// input is safe.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// Why an object or an archive of objects (.o, .a) cannot be linked into the programs of a site,
/// which have threads and WebAssembly's exceptions; each reason once, as "it was compiled without
/// threads (-pthread)". Empty when it can.
[[nodiscard]] std::vector<std::string> object_abi_faults(std::string_view bytes);

/// Python's version in the name of a compiled module ("3.13" for
/// `x.cpython-313-wasm32-emscripten.so`); empty when the name has none, as that of an `abi3`
/// module.
[[nodiscard]] std::string python_version_of_module(std::string_view file_name);

}  // namespace ros2wasm
