// See side_module.hpp. The section is described in WebAssembly's tool-conventions, DynamicLinking.
#include "bundler/archive/side_module.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "bundler/archive/wasm_cursor.hpp"
#include "bundler/archive/wasm_module.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kSection = "dylink.0";
constexpr std::string_view kOldSection = "dylink";
constexpr std::uint8_t kMemoryInfo = 1;
constexpr std::uint8_t kNeeded = 2;
constexpr std::uint8_t kMemorySection = 5;
constexpr std::uint8_t kExportSection = 7;
constexpr std::uint8_t kDataSection = 11;
constexpr std::uint64_t kMostMemory = 256ULL << 20U;
constexpr std::uint64_t kMostTable = 1ULL << 20U;
constexpr std::uint64_t kMostAlignment = 16;  // powers of 2
constexpr std::size_t kMostNeeded = 64;

/// The modules that the interpreter gives to side modules.
constexpr std::array<std::string_view, 4> kModules = {"GOT.func", "GOT.mem", "env",
                                                      "wasi_snapshot_preview1"};
/// JavaScript as text, which a site never runs: exports that hold some, functions that run it.
constexpr std::array<std::string_view, 2> kScriptExports = {"__em_js__", "__start_em_asm"};
constexpr std::string_view kScriptImport = "emscripten_run_script";

using Fault = std::optional<std::string>;

bool is_file_name(const std::string& name) {
  return !name.empty() && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c != '/'; });
}

Fault read_memory(WasmCursor& cursor, SideModule& result) {
  result.memory_bytes = cursor.leb();
  const std::uint64_t alignment = cursor.leb();
  const std::uint64_t table = cursor.leb();
  const std::uint64_t table_alignment = cursor.leb();
  if (!cursor.ok()) return "has a section `dylink.0` that ends too early";
  if (result.memory_bytes > kMostMemory)
    return "asks for " + std::to_string(result.memory_bytes) + " bytes of memory, more than " +
           std::to_string(kMostMemory);
  if (table > kMostTable || alignment > kMostAlignment || table_alignment > kMostAlignment)
    return "asks for a table or an alignment that no library has";
  return std::nullopt;
}

Fault read_needed(WasmCursor& cursor, SideModule& result) {
  const std::uint64_t count = cursor.leb();
  if (count > kMostNeeded) return "names " + std::to_string(count) + " libraries";
  for (std::uint64_t i = 0; i < count && cursor.ok(); ++i) {
    std::string name = cursor.text();
    if (cursor.ok() && !is_file_name(name)) return "needs a library whose name is not one";
    result.needed.push_back(std::move(name));
  }
  return cursor.ok() ? std::nullopt : Fault("has a section `dylink.0` that ends too early");
}

Fault read_dylink(std::string_view bytes, const WasmSection& section, SideModule& result) {
  WasmCursor cursor(bytes, section.contents, section.end);
  bool has_memory = false;
  while (!cursor.at_end()) {
    const std::uint8_t kind = cursor.byte();
    const std::uint64_t size = cursor.leb();
    const std::size_t begin = cursor.position();
    cursor.take(size);
    if (!cursor.ok()) break;
    WasmCursor part(bytes, begin, cursor.position());
    Fault fault;
    if (kind == kMemoryInfo) fault = read_memory(part, result);
    if (kind == kNeeded) fault = read_needed(part, result);
    if (fault) return fault;
    has_memory = has_memory || kind == kMemoryInfo;
    const bool was_read = kind == kMemoryInfo || kind == kNeeded;
    if (was_read && !part.at_end()) return "has a section `dylink.0` with more than it says";
  }
  if (!cursor.ok()) return "has a section `dylink.0` that ends too early";
  if (!has_memory) return "does not say how much memory it needs";
  return std::nullopt;
}

/// The end of a segment above the module's base; nothing when it lies elsewhere.
std::optional<std::uint64_t> segment_start(WasmCursor& cursor) {
  constexpr std::uint8_t kGlobal = 0x23;
  constexpr std::uint8_t kConstant = 0x41;
  constexpr std::uint8_t kAdd = 0x6A;
  constexpr std::uint8_t kEnd = 0x0B;
  bool is_relative = false;
  std::uint64_t offset = 0;
  for (std::uint8_t code = cursor.byte(); code != kEnd; code = cursor.byte()) {
    if (!cursor.ok()) return std::nullopt;
    if (code == kGlobal) {
      cursor.leb();
      is_relative = true;
    } else if (code == kConstant) {
      // A signed number, which is not negative here: a larger one is refused by its size.
      offset += cursor.leb();
    } else if (code != kAdd) {
      return std::nullopt;
    }
  }
  return is_relative ? std::optional(offset) : std::nullopt;
}

Fault check_data(std::string_view bytes, const WasmSection& section, const SideModule& module) {
  WasmCursor cursor(bytes, section.contents, section.end);
  for (std::uint64_t left = cursor.leb(); left > 0 && cursor.ok(); --left) {
    const std::uint64_t flags = cursor.leb();
    if (flags == 2) cursor.leb();  // a memory, of which there is one
    std::uint64_t start = 0;
    if (flags != 1) {
      const auto place = segment_start(cursor);
      if (!place) return "places data at an address of its own choice";
      start = *place;
    }
    const std::uint64_t size = cursor.leb();
    cursor.take(size);
    if (flags != 1 && (start > module.memory_bytes || size > module.memory_bytes - start))
      return "has more data than the memory that its section `dylink.0` asks for";
  }
  return cursor.ok() ? std::nullopt : Fault("has data that ends too early");
}

Fault check_exports(std::string_view bytes, const WasmSection& section) {
  WasmCursor cursor(bytes, section.contents, section.end);
  for (std::uint64_t left = cursor.leb(); left > 0 && cursor.ok(); --left) {
    const std::string name = cursor.text();
    cursor.byte();
    cursor.leb();
    const bool is_script =
        std::any_of(kScriptExports.begin(), kScriptExports.end(),
                    [&](std::string_view begin) { return name.starts_with(begin); });
    if (is_script) return "brings JavaScript as text (`" + name + "`), which a site never runs";
  }
  return cursor.ok() ? std::nullopt : Fault("has exports that end too early");
}

Fault check_imports(const WasmModule& module) {
  for (const WasmImport& import : module.imports) {
    if (std::find(kModules.begin(), kModules.end(), import.module) == kModules.end())
      return "imports `" + import.name + "` from `" + import.module +
             "`, which no interpreter of a site has";
    if (import.name.starts_with(kScriptImport))
      return "imports `" + import.name + "`, which runs JavaScript from text";
    if (import.shared_memory) return "is made for threads, which the interpreter does not have";
  }
  return std::nullopt;
}

}  // namespace

std::variant<SideModule, SideModuleFault> read_side_module(std::string_view bytes) {
  const auto module = read_wasm_module(bytes);
  if (!module) return SideModuleFault{"is not a whole WebAssembly module"};
  const WasmSection* first = module->sections.empty() ? nullptr : &module->sections.front();
  if (first == nullptr || first->id != 0 || first->name != kSection) {
    const bool is_old = first != nullptr && first->id == 0 && first->name == kOldSection;
    return SideModuleFault{is_old ? "was linked by an Emscripten older than 2.0.31"
                                  : "does not begin with the section `dylink.0` of side modules"};
  }
  SideModule result;
  if (auto fault = read_dylink(bytes, *first, result)) return SideModuleFault{*std::move(fault)};
  if (auto fault = check_imports(*module)) return SideModuleFault{*std::move(fault)};
  for (const WasmSection& section : module->sections) {
    Fault fault;
    if (section.id == kMemorySection) fault = "has a memory of its own";
    if (section.id == kExportSection) fault = check_exports(bytes, section);
    if (section.id == kDataSection) fault = check_data(bytes, section, result);
    if (fault) return SideModuleFault{*std::move(fault)};
  }
  return result;
}

}  // namespace ros2wasm
