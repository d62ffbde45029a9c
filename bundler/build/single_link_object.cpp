// See single_link_object.hpp. Written by hand so that a link needs no further run of the compiler.
#include "bundler/build/single_link_object.hpp"

#include <cassert>
#include <charconv>

#include "bundler/archive/wasm_module.hpp"

namespace ros2wasm {
namespace {

/// Everything here is shorter than 128 bytes, so that each length is one byte.
std::string sized(std::string_view contents) {
  assert(contents.size() < 128);
  return std::string(1, static_cast<char>(contents.size())).append(contents);
}

std::string bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result.push_back(static_cast<char>(value));
  return result;
}

std::string section(int id, const std::string& contents) {
  return bytes({id}) + sized(contents);
}

std::string custom(std::string_view name, const std::string& contents) {
  return section(0, sized(name) + contents);
}

}  // namespace

std::string single_link_object(TlsBase tls_base) {
  const bool zero = tls_base == TlsBase::kZero;
  constexpr int kI32 = 0x7f;
  const std::string type = bytes({1, 0x60, 4, kI32, kI32, kI32, kI32, 1, kI32});
  const std::string imports = bytes({2}) + sized("env") + sized("__linear_memory") +
                              bytes({2, 0, 0}) +  // memory, no maximum, no pages
                              sized("ros2wasm") + sized(kThreadMarkerImport) + bytes({0, 0});
  const std::string functions = bytes({1, 0});
  // local.get 0..3; call 0 (five bytes, for the linker to fill in); end
  const std::string body =
      bytes({0, 0x20, 0, 0x20, 1, 0x20, 2, 0x20, 3, 0x10, 0x80, 0x80, 0x80, 0x80, 0, 0x0b});
  const std::string code = bytes({1}) + sized(body);
  const std::string global = bytes({1, kI32, 1, 0x41, 0, 0x0b});  // mutable, i32.const 0
  constexpr int kCallOperand = 12;  // offset of the five bytes in the code section
  constexpr int kWeak = 0x01;
  constexpr int kGlobal = 2;
  constexpr int kUndefinedWithName = 0x50;
  const std::string symbols = bytes({zero ? 3 : 2}) + bytes({0, kUndefinedWithName, 0}) +
                              sized("ros2wasm_thread_create_required") + bytes({0, kWeak, 1}) +
                              sized("__wrap_pthread_create") +
                              (zero ? bytes({kGlobal, 0, 0}) + sized("__tls_base") : "");
  constexpr int kSymbolTable = 8;
  const std::string linking = bytes({2}) + bytes({kSymbolTable}) + sized(symbols);
  const int code_section_index = zero ? 4 : 3;
  constexpr int kFunctionIndexLeb = 0;
  const std::string relocations =
      bytes({code_section_index, 1, kFunctionIndexLeb, kCallOperand, 0});
  return std::string("\0asm\1\0\0\0", 8) + section(1, type) + section(2, imports) +
         section(3, functions) + (zero ? section(6, global) : "") + section(10, code) +
         custom("linking", linking) + custom("reloc.CODE", relocations);
}

TlsBase tls_base_for(std::string_view object) {
  constexpr int kFirstRight = 20;
  const std::string version = producer_version(object, "clang");
  int major = 0;
  std::from_chars(version.data(), version.data() + version.size(), major);
  return major < kFirstRight ? TlsBase::kZero : TlsBase::kOfLinker;
}

}  // namespace ros2wasm
