// See wasm_module.hpp. The format is that of the WebAssembly core specification, section 5.5.
#include "bundler/archive/wasm_module.hpp"

#include <algorithm>

#include "bundler/archive/wasm_cursor.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kHeader("\0asm\1\0\0\0", 8);
constexpr std::uint8_t kCustomSection = 0;
constexpr std::uint8_t kImportSection = 2;

/// Limits of a table or memory; true when they carry the shared flag.
bool skip_limits(WasmCursor& cursor) {
  const std::uint8_t flags = cursor.byte();
  cursor.leb();
  if ((flags & 1U) != 0) cursor.leb();
  return (flags & 2U) != 0;
}

WasmImport read_import(WasmCursor& cursor) {
  WasmImport result;
  result.module = cursor.text();
  result.name = cursor.text();
  switch (cursor.byte()) {
    case 0:
      result.kind = WasmExternal::kFunction;
      cursor.leb();
      break;
    case 1:
      result.kind = WasmExternal::kTable;
      cursor.byte();
      skip_limits(cursor);
      break;
    case 2:
      result.kind = WasmExternal::kMemory;
      result.shared_memory = skip_limits(cursor);
      break;
    case 3:
      result.kind = WasmExternal::kGlobal;
      cursor.byte();
      cursor.byte();
      break;
    case 4:
      result.kind = WasmExternal::kTag;
      cursor.byte();
      cursor.leb();
      break;
    default:
      cursor.take(~std::uint64_t{0});  // no such kind: fail
  }
  return result;
}

void append_leb(std::string& to, std::uint64_t value) {
  do {
    auto next = static_cast<std::uint8_t>(value & 0x7FU);
    value >>= 7U;
    if (value != 0) next |= 0x80U;
    to.push_back(static_cast<char>(next));
  } while (value != 0);
}

}  // namespace

std::optional<WasmModule> read_wasm_module(std::string_view bytes) {
  if (!bytes.starts_with(kHeader)) return std::nullopt;
  WasmModule result;
  WasmCursor cursor(bytes, kHeader.size(), bytes.size());
  while (!cursor.at_end()) {
    WasmSection section{.begin = cursor.position()};
    section.id = cursor.byte();
    const std::uint64_t size = cursor.leb();
    section.contents = cursor.position();
    cursor.take(size);
    if (!cursor.ok()) return std::nullopt;
    section.end = cursor.position();
    WasmCursor inside(bytes, section.contents, section.end);
    if (section.id == kCustomSection) {
      section.name = inside.text();
      section.contents = inside.position();
    } else if (section.id == kImportSection) {
      for (std::uint64_t left = inside.leb(); left > 0 && inside.ok(); --left) {
        result.imports.push_back(read_import(inside));
      }
    }
    if (!inside.ok()) return std::nullopt;
    result.sections.push_back(std::move(section));
  }
  if (!cursor.ok()) return std::nullopt;
  return result;
}

bool imports_shared_memory(const WasmModule& module) {
  return std::any_of(module.imports.begin(), module.imports.end(),
                     [](const WasmImport& import) { return import.shared_memory; });
}

std::string producer_version(std::string_view bytes, std::string_view tool) {
  const auto module = read_wasm_module(bytes);
  if (!module) return {};
  for (const WasmSection& section : module->sections) {
    if (section.id != kCustomSection || section.name != "producers") continue;
    WasmCursor cursor(bytes, section.contents, section.end);
    for (std::uint64_t fields = cursor.leb(); fields > 0 && cursor.ok(); --fields) {
      cursor.text();  // "language", "processed-by" or "sdk"
      for (std::uint64_t values = cursor.leb(); values > 0 && cursor.ok(); --values) {
        const std::string name = cursor.text();
        std::string version = cursor.text();
        if (name.ends_with(tool) && cursor.ok()) return version;
      }
    }
  }
  return {};
}

std::optional<SplitProgram> split_names(std::string_view bytes) {
  const auto module = read_wasm_module(bytes);
  if (!module) return std::nullopt;
  SplitProgram result{.program = std::string(kHeader), .names = {}};
  result.program.reserve(bytes.size());
  for (const WasmSection& section : module->sections) {
    const auto whole = bytes.substr(section.begin, section.end - section.begin);
    if (section.id != kCustomSection) {
      result.program.append(whole);
    } else if (section.name == "name") {
      std::string contents;
      append_leb(contents, section.name.size());
      contents += section.name;
      contents += bytes.substr(section.contents, section.end - section.contents);
      result.names = std::string(kHeader);
      result.names.push_back('\0');
      append_leb(result.names, contents.size());
      result.names += contents;
    }
    // Other custom sections (producers, target_features, debug data) have no use at run time.
  }
  return result;
}

std::optional<std::string> without_debug_data(std::string_view bytes) {
  const auto module = read_wasm_module(bytes);
  if (!module) return std::nullopt;
  std::string result(kHeader);
  result.reserve(bytes.size());
  for (const WasmSection& section : module->sections) {
    if (section.id == kCustomSection && section.name.starts_with(".debug_")) continue;
    result.append(bytes.substr(section.begin, section.end - section.begin));
  }
  return result;
}

}  // namespace ros2wasm
