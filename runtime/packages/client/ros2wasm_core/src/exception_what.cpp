// The last words of a program: an exception that left it as text for the crash report, and on
// standard error what terminate() and abort() say.
#include <cxxabi.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <typeinfo>

extern "C" void* __cxa_begin_catch(void* exception) noexcept;
/// Supplied by the loader: ends the program and tells where it stood.
extern "C" [[noreturn]] __attribute__((import_module("env"), import_name("abort"))) void
ros2wasm_loader_abort();

namespace {

// The exception that was thrown last. A function that promises not to throw calls terminate()
// without saying which exception has reached it.
thread_local void* t_in_flight = nullptr;

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

// For the exception that is being handled; worded as the C++ runtime words it on a terminal.
std::string last_words() {
  std::string text = "terminate called after throwing an instance of '";
  try {
    throw;
  } catch (const std::exception& error) {
    text += type_name() + "'\n  what():  " + error.what();
  } catch (...) {
    text += type_name() + "'";
  }
  return text;
}

[[noreturn]] void say_and_abort() {
  bool thrown = abi::__cxa_current_exception_type() != nullptr;
  if (!thrown && std::uncaught_exceptions() > 0 && t_in_flight != nullptr) {
    __cxa_begin_catch(t_in_flight);
    thrown = true;
  }
  const std::string text = thrown ? last_words() : "terminate called without an active exception";
  std::fprintf(stderr, "%s\n", text.c_str());
  std::abort();
}

// Before main, because a constructor of a static object may already call terminate().
const std::terminate_handler g_default_handler = std::set_terminate(&say_and_abort);

}  // namespace

/// `exception`: the pointer that the wasm exception carries. Writes at most `capacity` bytes of
/// text; returns its whole length.
extern "C" __attribute__((used, visibility("default"))) uint32_t ros2wasm_exception_what(
    void* exception, char* out, uint32_t capacity) {
  __cxa_begin_catch(exception);
  const std::string text = last_words();
  for (uint32_t i = 0; i < capacity && i < text.size(); ++i) {
    out[i] = text[i];
  }
  return static_cast<uint32_t>(text.size());
}

extern "C" int __real__Unwind_RaiseException(void* exception);
extern "C" int __wrap__Unwind_RaiseException(void* exception) {
  t_in_flight = exception;
  return __real__Unwind_RaiseException(exception);
}

extern "C" [[noreturn]] void __wrap_abort() {
  ros2wasm_loader_abort();
}
