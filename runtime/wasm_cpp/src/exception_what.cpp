// Turns an exception that left the program into text for the crash report.
#include <cxxabi.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <typeinfo>

extern "C" void* __cxa_begin_catch(void* exception) noexcept;

namespace {

std::string type_name() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  if (type == nullptr) {
    return "unknown";
  }
  int status = 0;
  char* readable = abi::__cxa_demangle(type->name(), nullptr, nullptr, &status);
  std::string name = status == 0 ? readable : type->name();
  std::free(readable);
  return name;
}

}  // namespace

/// `exception`: the pointer that the wasm exception carries. Writes at most `capacity` bytes of
/// text, as the C++ runtime words it on a terminal; returns its whole length.
extern "C" __attribute__((used, visibility("default"))) uint32_t ros2wasm_exception_what(
    void* exception, char* out, uint32_t capacity) {
  std::string text = "terminate called after throwing an instance of '";
  __cxa_begin_catch(exception);
  try {
    throw;
  } catch (const std::exception& error) {
    text += type_name() + "'\n  what():  " + error.what();
  } catch (...) {
    text += type_name() + "'";
  }
  for (uint32_t i = 0; i < capacity && i < text.size(); ++i) {
    out[i] = text[i];
  }
  return static_cast<uint32_t>(text.size());
}
