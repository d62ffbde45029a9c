// See thread_marker.hpp. Written by hand so that a link needs no further run of the compiler.
#include "bundler/build/thread_marker.hpp"

#include <cassert>

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

std::string thread_marker_object() {
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
  constexpr int kCallOperand = 12;  // offset of the five bytes in the code section
  constexpr int kWeak = 0x01;
  constexpr int kUndefinedWithName = 0x50;
  const std::string symbols = bytes({2}) + bytes({0, kUndefinedWithName, 0}) +
                              sized("ros2wasm_thread_create_required") + bytes({0, kWeak, 1}) +
                              sized("__wrap_pthread_create");
  constexpr int kSymbolTable = 8;
  const std::string linking = bytes({2}) + bytes({kSymbolTable}) + sized(symbols);
  constexpr int kCodeSectionIndex = 3;
  constexpr int kFunctionIndexLeb = 0;
  const std::string relocations = bytes({kCodeSectionIndex, 1, kFunctionIndexLeb, kCallOperand, 0});
  return std::string("\0asm\1\0\0\0", 8) + section(1, type) + section(2, imports) +
         section(3, functions) + section(10, code) + custom("linking", linking) +
         custom("reloc.CODE", relocations);
}

}  // namespace ros2wasm
