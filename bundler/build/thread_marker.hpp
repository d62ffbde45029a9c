// The object file that is linked into every program first: it defines `__wrap_pthread_create`,
// which only calls the import `ros2wasm.thread_create_required`. A program that has that import
// after the link starts threads, and is linked again for them.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

inline constexpr std::string_view kThreadMarkerImport = "thread_create_required";

/// A relocatable WebAssembly object (tool conventions, linking version 2). The definition is weak.
[[nodiscard]] std::string thread_marker_object();

}  // namespace ros2wasm
