// Reads the outer structure of a WebAssembly module: sections, imports, exports. Pure; knows
// nothing of code.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

enum class WasmExternal { kFunction, kTable, kMemory, kGlobal, kTag };

struct WasmImport {
  std::string module;
  std::string name;
  WasmExternal kind = WasmExternal::kFunction;
  bool shared_memory = false;  ///< a memory that threads may share
};

struct WasmSection {
  std::uint8_t id = 0;       ///< 0 is a custom section
  std::string name;          ///< of a custom section
  std::size_t begin = 0;     ///< offset of the section's id byte
  std::size_t end = 0;       ///< offset after its last byte
  std::size_t contents = 0;  ///< offset of the contents (after the name of a custom section)
};

struct WasmModule {
  std::vector<WasmSection> sections;
  std::vector<WasmImport> imports;
};

/// Nothing when `bytes` is not a well-formed module (hostile input is safe).
[[nodiscard]] std::optional<WasmModule> read_wasm_module(std::string_view bytes);

/// True when the program was linked for threads: it imports a shared memory.
[[nodiscard]] bool imports_shared_memory(const WasmModule& module);

/// The version of one tool in the section "producers"; "clang" also matches "Debian clang". Empty
/// when the section does not name the tool.
[[nodiscard]] std::string producer_version(std::string_view bytes, std::string_view tool);

/// A program and, kept apart, the names of its functions for crash reports.
struct SplitProgram {
  std::string program;  ///< the module without custom sections that nothing needs at run time
  std::string names;    ///< a module that has the "name" section only; empty when there was none
};

/// Nothing when `bytes` is not a module.
[[nodiscard]] std::optional<SplitProgram> split_names(std::string_view bytes);

/// The module without what debuggers want (DWARF), which libraries of the compiler bring and the
/// optimizer would carry along. Nothing when `bytes` is not a module.
[[nodiscard]] std::optional<std::string> without_debug_data(std::string_view bytes);

}  // namespace ros2wasm
