// Splitting, replacing, sorting, arrays of strings, and the name of the program.
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "rcutils/error_handling.h"
#include "rcutils/process.h"
#include "rcutils/qsort.h"
#include "rcutils/repl_str.h"
#include "rcutils/split.h"
#include "rcutils/strdup.h"
#include "rcutils/strerror.h"
#include "rcutils/types/string_array.h"

extern "C" char* program_invocation_name;

namespace {

rcutils_ret_t refuse(const char* reason, rcutils_ret_t code) {
  rcutils_set_error_state(reason, __FILE__, __LINE__);
  return code;
}

rcutils_ret_t fill(const std::vector<std::string_view>& parts, rcutils_allocator_t allocator,
                   rcutils_string_array_t* array) {
  const rcutils_ret_t result = rcutils_string_array_init(array, parts.size(), &allocator);
  if (result != RCUTILS_RET_OK) {
    return result;
  }
  for (size_t i = 0; i < parts.size(); ++i) {
    array->data[i] = rcutils_strndup(parts[i].data(), parts[i].size(), allocator);
    if (array->data[i] == nullptr) {
      static_cast<void>(rcutils_string_array_fini(array));
      return refuse("failed to allocate memory", RCUTILS_RET_BAD_ALLOC);
    }
  }
  return RCUTILS_RET_OK;
}

}  // namespace

extern "C" {

rcutils_string_array_t rcutils_get_zero_initialized_string_array(void) {
  return rcutils_string_array_t{};
}

rcutils_ret_t rcutils_string_array_init(rcutils_string_array_t* array, size_t size,
                                        const rcutils_allocator_t* allocator) {
  if (array == nullptr) {
    return refuse("string_array is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  if (!rcutils_allocator_is_valid(allocator)) {
    return refuse("allocator is invalid", RCUTILS_RET_INVALID_ARGUMENT);
  }
  *array = rcutils_string_array_t{size, nullptr, *allocator};
  if (size > 0) {
    array->data =
        static_cast<char**>(allocator->zero_allocate(size, sizeof(char*), allocator->state));
    if (array->data == nullptr) {
      return refuse("failed to allocate string array", RCUTILS_RET_BAD_ALLOC);
    }
  }
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_string_array_fini(rcutils_string_array_t* array) {
  if (array == nullptr) {
    return refuse("string_array is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  if (array->data == nullptr) {
    return RCUTILS_RET_OK;
  }
  if (!rcutils_allocator_is_valid(&array->allocator)) {
    return refuse("allocator is invalid", RCUTILS_RET_INVALID_ARGUMENT);
  }
  for (size_t i = 0; i < array->size; ++i) {
    array->allocator.deallocate(array->data[i], array->allocator.state);
  }
  array->allocator.deallocate(array->data, array->allocator.state);
  array->data = nullptr;
  array->size = 0;
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_string_array_cmp(const rcutils_string_array_t* left,
                                       const rcutils_string_array_t* right, int* result) {
  if (left == nullptr || right == nullptr || result == nullptr) {
    return refuse("an argument of rcutils_string_array_cmp is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  for (size_t i = 0; i < std::min(left->size, right->size); ++i) {
    if (left->data[i] == nullptr || right->data[i] == nullptr) {
      return refuse("a string of the array is null", RCUTILS_RET_ERROR);
    }
    *result = std::strcmp(left->data[i], right->data[i]);
    if (*result != 0) {
      return RCUTILS_RET_OK;
    }
  }
  *result = left->size == right->size ? 0 : (left->size < right->size ? -1 : 1);
  return RCUTILS_RET_OK;
}

rcutils_ret_t rcutils_string_array_resize(rcutils_string_array_t* array, size_t new_size) {
  if (array == nullptr) {
    return refuse("string_array is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  const rcutils_allocator_t allocator = array->allocator;
  if (!rcutils_allocator_is_valid(&allocator)) {
    return refuse("allocator is invalid", RCUTILS_RET_INVALID_ARGUMENT);
  }
  for (size_t i = new_size; i < array->size; ++i) {
    allocator.deallocate(array->data[i], allocator.state);
    array->data[i] = nullptr;
  }
  if (new_size == 0) {
    allocator.deallocate(array->data, allocator.state);
    array->data = nullptr;
  } else if (new_size != array->size) {
    auto** grown = static_cast<char**>(
        allocator.reallocate(array->data, new_size * sizeof(char*), allocator.state));
    if (grown == nullptr) {
      return refuse("failed to allocate string array", RCUTILS_RET_BAD_ALLOC);
    }
    array->data = grown;
    for (size_t i = array->size; i < new_size; ++i) {
      array->data[i] = nullptr;
    }
  }
  array->size = new_size;
  return RCUTILS_RET_OK;
}

/* Null strings come last. */
int rcutils_string_array_sort_compare(const void* left, const void* right) {
  const char* const a = *static_cast<const char* const*>(left);
  const char* const b = *static_cast<const char* const*>(right);
  if (a == nullptr || b == nullptr) {
    return a == b ? 0 : (a == nullptr ? 1 : -1);
  }
  return std::strcmp(a, b);
}

/* Empty parts, of delimiters at an end or in a row, are skipped. */
rcutils_ret_t rcutils_split(const char* str, char delimiter, rcutils_allocator_t allocator,
                            rcutils_string_array_t* string_array) {
  if (string_array == nullptr) {
    return refuse("string_array is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  std::vector<std::string_view> parts;
  std::string_view rest(str == nullptr ? "" : str);
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find(delimiter));
    if (!part.empty()) {
      parts.push_back(part);
    }
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
  }
  return fill(parts, allocator, string_array);
}

rcutils_ret_t rcutils_split_last(const char* str, char delimiter, rcutils_allocator_t allocator,
                                 rcutils_string_array_t* string_array) {
  if (string_array == nullptr) {
    return refuse("string_array is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  std::string_view text(str == nullptr ? "" : str);
  while (!text.empty() && text.front() == delimiter) {
    text.remove_prefix(1);
  }
  while (!text.empty() && text.back() == delimiter) {
    text.remove_suffix(1);
  }
  std::vector<std::string_view> parts;
  const size_t at = text.rfind(delimiter);
  if (at != std::string_view::npos) {
    std::string_view before = text.substr(0, at);
    while (!before.empty() && before.back() == delimiter) {
      before.remove_suffix(1);
    }
    parts = {before, text.substr(at + 1)};
  } else if (!text.empty()) {
    parts = {text};
  }
  return fill(parts, allocator, string_array);
}

char* rcutils_repl_str(const char* str, const char* from, const char* to,
                       const rcutils_allocator_t* allocator) {
  std::string text(str);
  const size_t length = std::strlen(from);
  for (size_t at = 0; length > 0 && (at = text.find(from, at)) != std::string::npos;
       at += std::strlen(to)) {
    text.replace(at, length, to);
  }
  return rcutils_strndup(text.data(), text.size(), *allocator);
}

rcutils_ret_t rcutils_qsort(void* ptr, size_t count, size_t size,
                            int (*comp)(const void*, const void*)) {
  if (comp == nullptr) {
    return refuse("comp is null", RCUTILS_RET_INVALID_ARGUMENT);
  }
  if (count > 1) {
    if (ptr == nullptr || size == 0) {
      return refuse("there is nothing to sort", RCUTILS_RET_INVALID_ARGUMENT);
    }
    std::qsort(ptr, count, size, comp);
  }
  return RCUTILS_RET_OK;
}

void rcutils_strerror(char* buffer, size_t buffer_length) {
  if (buffer_length > 0) {
    const char* const text = std::strerror(errno);
    const size_t size = std::min(std::strlen(text), buffer_length - 1);
    std::memcpy(buffer, text, size);
    buffer[size] = '\0';
  }
}

char* rcutils_get_executable_name(rcutils_allocator_t allocator) {
  if (!rcutils_allocator_is_valid(&allocator)) {
    return nullptr;
  }
  const std::string_view path(program_invocation_name == nullptr ? "" : program_invocation_name);
  const std::string_view name = path.substr(path.rfind('/') + 1);
  return rcutils_strndup(name.data(), name.size(), allocator);
}

}  // extern "C"
