// Allocators, byte and character arrays, strings, command line, environment and time: the small
// functions of rcutils that client code calls.
#include <cctype>
#include <cinttypes>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "rcutils/allocator.h"
#include "rcutils/cmdline_parser.h"
#include "rcutils/env.h"
#include "rcutils/error_handling.h"
#include "rcutils/find.h"
#include "rcutils/format_string.h"
#include "rcutils/process.h"
#include "rcutils/snprintf.h"
#include "rcutils/strcasecmp.h"
#include "rcutils/strdup.h"
#include "rcutils/time.h"
#include "rcutils/types/char_array.h"
#include "rcutils/types/uint8_array.h"

namespace {

void* allocate(size_t size, void*) {
  return std::malloc(size);
}
void deallocate(void* pointer, void*) {
  std::free(pointer);
}
void* reallocate(void* pointer, size_t size, void*) {
  return std::realloc(pointer, size);
}
void* zero_allocate(size_t count, size_t size, void*) {
  return std::calloc(count, size);
}

rcutils_ret_t out_of_memory() {
  RCUTILS_SET_ERROR_MSG("failed to allocate memory");
  return RCUTILS_RET_BAD_ALLOC;
}

rcutils_ret_t read_clock(clockid_t clock, rcutils_time_point_value_t* now) {
  if (now == nullptr) {
    RCUTILS_SET_ERROR_MSG("now argument is null");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  timespec time{};
  if (clock_gettime(clock, &time) != 0) {
    return RCUTILS_RET_ERROR;
  }
  *now = static_cast<int64_t>(time.tv_sec) * 1000000000 + time.tv_nsec;
  return RCUTILS_RET_OK;
}

template <typename Element, typename Array>
rcutils_ret_t resize_array(Array* array, Element** buffer, size_t size) {
  if (array == nullptr || size == 0) {
    RCUTILS_SET_ERROR_MSG("array is null or its new size is 0");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  if (size == array->buffer_capacity) {
    return RCUTILS_RET_OK;
  }
  void* grown = array->allocator.reallocate(*buffer, size, array->allocator.state);
  if (grown == nullptr) {
    return out_of_memory();
  }
  *buffer = static_cast<Element*>(grown);
  array->buffer_capacity = size;
  if (array->buffer_length > size) {
    array->buffer_length = size;
  }
  return RCUTILS_RET_OK;
}

}  // namespace

extern "C" {

rcutils_allocator_t rcutils_get_zero_initialized_allocator(void) {
  return {};
}

rcutils_allocator_t rcutils_get_default_allocator(void) {
  return {allocate, deallocate, reallocate, zero_allocate, nullptr};
}

bool rcutils_allocator_is_valid(const rcutils_allocator_t* allocator) {
  return allocator != nullptr && allocator->allocate != nullptr &&
         allocator->deallocate != nullptr && allocator->zero_allocate != nullptr &&
         allocator->reallocate != nullptr;
}

void* rcutils_reallocf(void* pointer, size_t size, rcutils_allocator_t* allocator) {
  if (!rcutils_allocator_is_valid(allocator)) {
    return nullptr;
  }
  void* grown = allocator->reallocate(pointer, size, allocator->state);
  if (grown == nullptr) {
    allocator->deallocate(pointer, allocator->state);
  }
  return grown;
}

rcutils_uint8_array_t rcutils_get_zero_initialized_uint8_array(void) {
  return {};
}

rcutils_ret_t rcutils_uint8_array_init(rcutils_uint8_array_t* array, size_t capacity,
                                       const rcutils_allocator_t* allocator) {
  if (array == nullptr || !rcutils_allocator_is_valid(allocator)) {
    RCUTILS_SET_ERROR_MSG("array or allocator is invalid");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  *array = {};
  array->allocator = *allocator;
  if (capacity == 0) {
    return RCUTILS_RET_OK;
  }
  array->buffer = static_cast<uint8_t*>(allocator->allocate(capacity, allocator->state));
  if (array->buffer == nullptr) {
    return out_of_memory();
  }
  array->buffer_capacity = capacity;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_uint8_array_fini(rcutils_uint8_array_t* array) {
  if (array == nullptr) {
    RCUTILS_SET_ERROR_MSG("array is null");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  if (array->buffer != nullptr) {
    array->allocator.deallocate(array->buffer, array->allocator.state);
  }
  array->buffer = nullptr;
  array->buffer_length = 0;
  array->buffer_capacity = 0;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_uint8_array_resize(rcutils_uint8_array_t* array, size_t size) {
  return resize_array(array, &array->buffer, size);
}

rcutils_char_array_t rcutils_get_zero_initialized_char_array(void) {
  return {};
}

rcutils_ret_t rcutils_char_array_init(rcutils_char_array_t* array, size_t capacity,
                                      const rcutils_allocator_t* allocator) {
  if (array == nullptr || !rcutils_allocator_is_valid(allocator)) {
    RCUTILS_SET_ERROR_MSG("array or allocator is invalid");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  *array = {};
  array->owns_buffer = true;
  array->allocator = *allocator;
  if (capacity == 0) {
    return RCUTILS_RET_OK;
  }
  array->buffer = static_cast<char*>(allocator->zero_allocate(capacity, 1, allocator->state));
  if (array->buffer == nullptr) {
    return out_of_memory();
  }
  array->buffer_capacity = capacity;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_char_array_fini(rcutils_char_array_t* array) {
  if (array == nullptr) {
    RCUTILS_SET_ERROR_MSG("array is null");
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  if (array->owns_buffer && array->buffer != nullptr) {
    array->allocator.deallocate(array->buffer, array->allocator.state);
  }
  array->buffer = nullptr;
  array->buffer_length = 0;
  array->buffer_capacity = 0;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_char_array_resize(rcutils_char_array_t* array, size_t size) {
  if (array != nullptr && !array->owns_buffer) {
    char* owned = static_cast<char*>(array->allocator.allocate(size, array->allocator.state));
    if (owned == nullptr) {
      return out_of_memory();
    }
    std::memcpy(owned, array->buffer, size < array->buffer_length ? size : array->buffer_length);
    array->buffer = owned;
    array->buffer_capacity = size;
    array->owns_buffer = true;
    return RCUTILS_RET_OK;
  }
  return resize_array(array, &array->buffer, size);
}

rcutils_ret_t rcutils_char_array_expand_as_needed(rcutils_char_array_t* array, size_t size) {
  return size <= array->buffer_capacity ? RCUTILS_RET_OK : rcutils_char_array_resize(array, size);
}

rcutils_ret_t rcutils_char_array_strncat(rcutils_char_array_t* array, const char* text,
                                         size_t count) {
  const size_t old = array->buffer_length == 0 ? 0 : array->buffer_length - 1;
  const rcutils_ret_t result = rcutils_char_array_expand_as_needed(array, old + count + 1);
  if (result != RCUTILS_RET_OK) {
    return result;
  }
  std::memcpy(array->buffer + old, text, count);
  array->buffer[old + count] = '\0';
  array->buffer_length = old + count + 1;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_char_array_strcat(rcutils_char_array_t* array, const char* text) {
  return rcutils_char_array_strncat(array, text, std::strlen(text));
}

rcutils_ret_t rcutils_char_array_memcpy(rcutils_char_array_t* array, const char* text,
                                        size_t count) {
  const rcutils_ret_t result = rcutils_char_array_expand_as_needed(array, count);
  if (result != RCUTILS_RET_OK) {
    return result;
  }
  std::memcpy(array->buffer, text, count);
  array->buffer_length = count;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_char_array_strcpy(rcutils_char_array_t* array, const char* text) {
  return rcutils_char_array_memcpy(array, text, std::strlen(text) + 1);
}

bool rcutils_cli_option_exist(char** begin, char** end, const char* option) {
  for (char** at = begin; at != end; ++at) {
    if (std::strcmp(*at, option) == 0) {
      return true;
    }
  }
  return false;
}

char* rcutils_cli_get_option(char** begin, char** end, const char* option) {
  for (char** at = begin; at != end; ++at) {
    if (std::strcmp(*at, option) == 0) {
      return at + 1 != end ? at[1] : nullptr;
    }
  }
  return nullptr;
}

const char* rcutils_get_env(const char* name, const char** value) {
  if (name == nullptr) {
    return "argument env_name is null";
  }
  if (value == nullptr) {
    return "argument env_value is null";
  }
  const char* found = std::getenv(name);
  *value = found == nullptr ? "" : found;
  return nullptr;
}

bool rcutils_set_env(const char* name, const char* value) {
  if (name == nullptr) {
    RCUTILS_SET_ERROR_MSG("env_name is null");
    return false;
  }
  return (value == nullptr ? unsetenv(name) : setenv(name, value, 1)) == 0;
}

const char* rcutils_get_home_dir(void) {
  return std::getenv("HOME");
}

int rcutils_get_pid(void) {
  return 1;
}

rcutils_ret_t rcutils_system_time_now(rcutils_time_point_value_t* now) {
  return read_clock(CLOCK_REALTIME, now);
}

rcutils_ret_t rcutils_steady_time_now(rcutils_time_point_value_t* now) {
  return read_clock(CLOCK_MONOTONIC, now);
}

rcutils_ret_t rcutils_time_point_value_as_nanoseconds_string(const rcutils_time_point_value_t* time,
                                                             char* text, size_t size) {
  if (time == nullptr || text == nullptr) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  std::snprintf(text, size, "%s%.19" PRId64, *time < 0 ? "-" : "", *time < 0 ? -*time : *time);
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_time_point_value_as_seconds_string(const rcutils_time_point_value_t* time,
                                                         char* text, size_t size) {
  if (time == nullptr || text == nullptr) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  const int64_t positive = *time < 0 ? -*time : *time;
  std::snprintf(text, size, "%s%.10" PRId64 ".%.9" PRId64, *time < 0 ? "-" : "",
                positive / 1000000000, positive % 1000000000);
  return RCUTILS_RET_OK;
}

char* rcutils_strndup(const char* text, size_t count, rcutils_allocator_t allocator) {
  if (text == nullptr) {
    return nullptr;
  }
  char* copy = static_cast<char*>(allocator.allocate(count + 1, allocator.state));
  if (copy != nullptr) {
    std::memcpy(copy, text, count);
    copy[count] = '\0';
  }
  return copy;
}

char* rcutils_strdup(const char* text, rcutils_allocator_t allocator) {
  return text == nullptr ? nullptr : rcutils_strndup(text, std::strlen(text), allocator);
}

int rcutils_strcasecmp(const char* left, const char* right, int* result) {
  if (left == nullptr || right == nullptr || result == nullptr) {
    return -1;
  }
  *result = strcasecmp(left, right);
  return 0;
}

int rcutils_strncasecmp(const char* left, const char* right, size_t count, int* result) {
  if (left == nullptr || right == nullptr || result == nullptr) {
    return -1;
  }
  *result = strncasecmp(left, right, count);
  return 0;
}

int rcutils_vsnprintf(char* buffer, size_t size, const char* format, va_list args) {
  return std::vsnprintf(buffer, size, format, args);
}

int rcutils_snprintf(char* buffer, size_t size, const char* format, ...) {
  va_list args;
  va_start(args, format);
  const int length = std::vsnprintf(buffer, size, format, args);
  va_end(args);
  return length;
}

char* rcutils_format_string_limit(rcutils_allocator_t allocator, size_t limit, const char* format,
                                  ...) {
  va_list args;
  va_start(args, format);
  char* text = static_cast<char*>(allocator.allocate(limit, allocator.state));
  if (text != nullptr) {
    std::vsnprintf(text, limit, format, args);
  }
  va_end(args);
  return text;
}

#ifdef ROS2WASM_LP64_FORMAT_HPP_
char* rcutils_lp64_format_string(rcutils_allocator_t allocator, size_t limit, const char* format,
                                 const ros2wasm::lp64::Slot* slots, int count) {
  char* text = static_cast<char*>(allocator.allocate(limit, allocator.state));
  if (text != nullptr) {
    ros2wasm_lp64_snprintf(text, limit, format, slots, count);
  }
  return text;
}
#endif

size_t rcutils_findn(const char* text, char delimiter, size_t length) {
  const void* found = text == nullptr ? nullptr : std::memchr(text, delimiter, length);
  return found == nullptr ? SIZE_MAX : static_cast<size_t>(static_cast<const char*>(found) - text);
}

size_t rcutils_find(const char* text, char delimiter) {
  return text == nullptr ? SIZE_MAX : rcutils_findn(text, delimiter, std::strlen(text));
}

size_t rcutils_find_lastn(const char* text, char delimiter, size_t length) {
  for (size_t i = text == nullptr ? 0 : length; i > 0; --i) {
    if (text[i - 1] == delimiter) {
      return i - 1;
    }
  }
  return SIZE_MAX;
}

size_t rcutils_find_last(const char* text, char delimiter) {
  return text == nullptr ? SIZE_MAX : rcutils_find_lastn(text, delimiter, std::strlen(text));
}

}  // extern "C"
