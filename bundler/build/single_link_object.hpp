// The object file that every single link begins with. It defines `__wrap_pthread_create`, which
// only calls the import `ros2wasm.thread_create_required`: a program that has that import after the
// link starts threads, and is linked again for them. For linkers that need it, it also gives
// thread-local variables their base.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

inline constexpr std::string_view kThreadMarkerImport = "thread_create_required";

/// The value of `__tls_base` in a single link. Up to LLVM 19, wasm-ld gives thread-local variables
/// absolute addresses there and still adds the base to them: they overlap other data unless the
/// base is zero.
enum class TlsBase { kOfLinker, kZero };

/// A relocatable WebAssembly object (tool conventions, linking version 2). The function is weak.
[[nodiscard]] std::string single_link_object(TlsBase tls_base);

/// The base that the linker of the compiler of `object` needs; kZero when the object does not name
/// its compiler.
[[nodiscard]] TlsBase tls_base_for(std::string_view object);

}  // namespace ros2wasm
