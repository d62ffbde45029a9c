// Turns an exception that left the program into text for the crash report.
#include <cxxabi.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <typeinfo>

extern "C" void* __cxa_begin_catch(void* exception) noexcept;

namespace {

// "std::runtime_error" of "St13runtime_error", "a::B" of "N1a1BE"; other names stay as they are.
// (The runtime's own demangler would weigh more than a node's program.)
std::string readable(const char* mangled) {
  std::string name;
  const char* at = mangled;
  const bool nested = *at == 'N';
  at += nested ? 1 : 0;
  if (at[0] == 'S' && at[1] == 't') {
    name = "std";
    at += 2;
  }
  while (*at >= '0' && *at <= '9') {
    char* text = nullptr;
    const unsigned long length = std::strtoul(at, &text, 10);
    if (length > std::strlen(text)) {
      return mangled;
    }
    name += (name.empty() ? "" : "::") + std::string(text, length);
    at = text + length;
  }
  const bool complete = nested ? at[0] == 'E' && at[1] == '\0' : at[0] == '\0';
  return complete ? name : mangled;
}

std::string type_name() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  return type == nullptr ? "unknown" : readable(type->name());
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
