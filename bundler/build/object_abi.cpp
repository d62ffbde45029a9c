// See object_abi.hpp.
#include "bundler/build/object_abi.hpp"

#include <algorithm>

#include "bundler/archive/wasm_cursor.hpp"
#include "bundler/archive/wasm_module.hpp"
#include "bundler/build/wasm_object.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kOtherMachine = "it is not compiled for WebAssembly";
constexpr std::string_view kWithoutThreads =
    "it was compiled without threads (-pthread), which programs of a site have";
constexpr std::string_view kScriptExceptions =
    "it throws exceptions through JavaScript (-fexceptions), not as WebAssembly does "
    "(-fwasm-exceptions)";
/// Signs in the section `target_features`.
constexpr std::uint8_t kDisallowed = '-';

/// A mark of the compiler that it has replaced atomic operations and thread-local variables by
/// plain ones.
bool disallows_threads(std::string_view bytes, const WasmSection& section) {
  WasmCursor cursor(bytes, section.contents, section.end);
  for (std::uint64_t left = cursor.leb(); left > 0 && cursor.ok(); --left) {
    const std::uint8_t sign = cursor.byte();
    const std::string feature = cursor.text();
    if (sign == kDisallowed && (feature == "shared-mem" || feature == "atomics")) return true;
  }
  return false;
}

void add(std::string_view fault, std::vector<std::string>& faults) {
  if (std::find(faults.begin(), faults.end(), fault) == faults.end()) faults.emplace_back(fault);
}

/// A call through JavaScript that catches what is thrown: its name ends with the letters of its
/// types ("invoke_vii").
bool is_invoke(const WasmImport& import) {
  constexpr std::string_view kBegin = "invoke_";
  if (import.module != "env" || !import.name.starts_with(kBegin)) return false;
  return import.name.size() > kBegin.size() &&
         import.name.find_first_not_of("vijfdep", kBegin.size()) == std::string::npos;
}

void add_faults(std::string_view object, std::vector<std::string>& faults) {
  const auto module = read_wasm_module(object);
  if (!module) {
    // LLVM's bitcode, and objects of other machines; the other files of an archive are not code.
    if (object.starts_with("\x7f"
                           "ELF") ||
        object.starts_with("\xcf\xfa\xed\xfe") || object.starts_with("BC\xc0\xde"))
      add(kOtherMachine, faults);
    return;
  }
  for (const WasmSection& section : module->sections)
    if (section.name == "target_features" && disallows_threads(object, section))
      add(kWithoutThreads, faults);
  for (const WasmImport& import : module->imports)
    if (is_invoke(import)) add(kScriptExceptions, faults);
}

}  // namespace

std::vector<std::string> object_abi_faults(std::string_view bytes) {
  std::vector<std::string> faults;
  const auto members = archive_members(bytes);
  if (!members) {
    add_faults(bytes, faults);
    return faults;
  }
  for (const std::string_view member : *members) add_faults(member, faults);
  return faults;
}

std::string python_version_of_module(std::string_view file_name) {
  constexpr std::string_view kTag = ".cpython-";
  const std::size_t at = file_name.find(kTag);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = file_name.substr(at + kTag.size());
  const std::string_view digits = rest.substr(0, rest.find_first_not_of("0123456789"));
  if (digits.size() < 2 || digits.size() > 4) return {};
  return std::string(digits.substr(0, 1)) + "." + std::string(digits.substr(1));
}

}  // namespace ros2wasm
