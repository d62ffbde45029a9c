// The error state of each thread, behind rcutils/error_handling.h.
#include "rcutils/error_handling.h"

#include <cstdio>
#include <cstring>

namespace {

struct ThreadError {
  bool is_set = false;
  rcutils_error_state_t state{};
  rcutils_error_string_t text{};
};

ThreadError& current() {
  static thread_local ThreadError error;
  return error;
}

void copy_limited(char* out, size_t capacity, const char* text) {
  std::snprintf(out, capacity, "%s", text == nullptr ? "" : text);
}

}  // namespace

extern "C" {

rcutils_ret_t rcutils_initialize_error_handling_thread_local_storage(rcutils_allocator_t) {
  current() = ThreadError();
  return RCUTILS_RET_OK;
}

void rcutils_set_error_state(const char* error_string, const char* file, size_t line_number) {
  ThreadError& error = current();
  error.is_set = true;
  copy_limited(error.state.message, sizeof(error.state.message), error_string);
  copy_limited(error.state.file, sizeof(error.state.file), file);
  error.state.line_number = line_number;
}

bool rcutils_error_is_set(void) {
  return current().is_set;
}

const rcutils_error_state_t* rcutils_get_error_state(void) {
  return current().is_set ? &current().state : nullptr;
}

rcutils_error_string_t rcutils_get_error_string(void) {
  ThreadError& error = current();
  if (!error.is_set) {
    copy_limited(error.text.str, sizeof(error.text.str), "error not set");
  } else {
    std::snprintf(error.text.str, sizeof(error.text.str), "%s, at %s:%llu", error.state.message,
                  error.state.file, static_cast<unsigned long long>(error.state.line_number));
  }
  return error.text;
}

void rcutils_reset_error(void) {
  current() = ThreadError();
}

}  // extern "C"
