// Definitions of the functions that rosidl_runtime_c declares for texts and lists of C messages. Each one is weak:
// every unit that includes messages has it, and a program keeps one.
#ifndef ROS2WASM_C_MESSAGES__RUNTIME_H_
#define ROS2WASM_C_MESSAGES__RUNTIME_H_

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "rosidl_runtime_c/primitives_sequence_functions.h"
#include "rosidl_runtime_c/string_functions.h"
#include "rosidl_runtime_c/u16string_functions.h"

#ifdef __cplusplus
extern "C" {
#endif

#define ROS2WASM_WEAK __attribute__((weak))

// --- texts: STRING of characters of CHARACTER, which end with a zero ---------------------------------------------
#define ROS2WASM_DEFINE_STRING(STRING, CHARACTER) \
  ROS2WASM_WEAK bool STRING ## __init(STRING * str) \
  { \
    if (!str) { \
      return false; \
    } \
    str->data = (CHARACTER *)calloc(1, sizeof(CHARACTER)); \
    str->size = 0; \
    str->capacity = str->data ? 1 : 0; \
    return str->data != NULL; \
  } \
  ROS2WASM_WEAK void STRING ## __fini(STRING * str) \
  { \
    if (str) { \
      free(str->data); \
      str->data = NULL; \
      str->size = 0; \
      str->capacity = 0; \
    } \
  } \
  ROS2WASM_WEAK bool STRING ## __are_equal(const STRING * lhs, const STRING * rhs) \
  { \
    return lhs && rhs && lhs->size == rhs->size && \
           (lhs->size == 0 || memcmp(lhs->data, rhs->data, lhs->size * sizeof(CHARACTER)) == 0); \
  } \
  ROS2WASM_WEAK bool STRING ## __assignn(STRING * str, const CHARACTER * value, size_t n) \
  { \
    if (!str || !value || n == SIZE_MAX) { \
      return false; \
    } \
    CHARACTER * data = (CHARACTER *)realloc(str->data, (n + 1) * sizeof(CHARACTER)); \
    if (!data) { \
      return false; \
    } \
    memcpy(data, value, n * sizeof(CHARACTER)); \
    data[n] = 0; \
    str->data = data; \
    str->size = n; \
    str->capacity = n + 1; \
    return true; \
  } \
  ROS2WASM_WEAK bool STRING ## __copy(const STRING * input, STRING * output) \
  { \
    return input && STRING ## __assignn(output, input->data, input->size); \
  }

ROS2WASM_DEFINE_STRING(rosidl_runtime_c__String, char)
ROS2WASM_DEFINE_STRING(rosidl_runtime_c__U16String, uint_least16_t)

ROS2WASM_WEAK bool rosidl_runtime_c__String__assign(rosidl_runtime_c__String * str, const char * value)
{
  return value && rosidl_runtime_c__String__assignn(str, value, strlen(value));
}

ROS2WASM_WEAK size_t rosidl_runtime_c__U16String__len(const uint16_t * value)
{
  size_t length = 0;
  while (value && value[length] != 0) {
    ++length;
  }
  return length;
}

ROS2WASM_WEAK bool rosidl_runtime_c__U16String__assign(rosidl_runtime_c__U16String * str, const uint16_t * value)
{
  return value && rosidl_runtime_c__U16String__assignn(str, value, rosidl_runtime_c__U16String__len(value));
}

// Each character is taken as it is, whatever its value.
ROS2WASM_WEAK bool rosidl_runtime_c__U16String__resize(rosidl_runtime_c__U16String * str, size_t n)
{
  if (!str || n == SIZE_MAX) {
    return false;
  }
  uint_least16_t * data = (uint_least16_t *)realloc(str->data, (n + 1) * sizeof(uint_least16_t));
  if (!data) {
    return false;
  }
  data[n] = 0;
  str->data = data;
  str->size = n;
  str->capacity = n + 1;
  return true;
}

// As in rosidl: `n` counts bytes, two of which are a character.
ROS2WASM_WEAK bool rosidl_runtime_c__U16String__assignn_from_char(
  rosidl_runtime_c__U16String * str, const char * value, size_t n)
{
  if (!str || !value || n % 2 != 0) {
    return false;
  }
  if (!rosidl_runtime_c__U16String__resize(str, n / 2)) {
    return false;
  }
  memcpy(str->data, value, n);
  return true;
}

// --- lists of texts --------------------------------------------------------------------------------------------------
#define ROS2WASM_DEFINE_STRING_SEQUENCE(STRING) \
  ROS2WASM_WEAK void STRING ## __Sequence__fini(STRING ## __Sequence * sequence) \
  { \
    if (sequence) { \
      for (size_t i = 0; i < sequence->capacity; ++i) { \
        STRING ## __fini(&sequence->data[i]); \
      } \
      free(sequence->data); \
      sequence->data = NULL; \
      sequence->size = 0; \
      sequence->capacity = 0; \
    } \
  } \
  ROS2WASM_WEAK bool STRING ## __Sequence__init(STRING ## __Sequence * sequence, size_t size) \
  { \
    if (!sequence) { \
      return false; \
    } \
    sequence->data = size ? (STRING *)calloc(size, sizeof(STRING)) : NULL; \
    sequence->size = 0; \
    sequence->capacity = 0; \
    if (size && !sequence->data) { \
      return false; \
    } \
    for (; sequence->capacity < size; ++sequence->capacity) { \
      if (!STRING ## __init(&sequence->data[sequence->capacity])) { \
        STRING ## __Sequence__fini(sequence); \
        return false; \
      } \
    } \
    sequence->size = size; \
    return true; \
  } \
  ROS2WASM_WEAK bool STRING ## __Sequence__are_equal( \
    const STRING ## __Sequence * lhs, const STRING ## __Sequence * rhs) \
  { \
    if (!lhs || !rhs || lhs->size != rhs->size) { \
      return false; \
    } \
    for (size_t i = 0; i < lhs->size; ++i) { \
      if (!STRING ## __are_equal(&lhs->data[i], &rhs->data[i])) { \
        return false; \
      } \
    } \
    return true; \
  } \
  ROS2WASM_WEAK bool STRING ## __Sequence__copy( \
    const STRING ## __Sequence * input, STRING ## __Sequence * output) \
  { \
    if (!input || !output) { \
      return false; \
    } \
    if (output->capacity < input->size) { \
      STRING * data = (STRING *)realloc(output->data, input->size * sizeof(STRING)); \
      if (!data) { \
        return false; \
      } \
      output->data = data; \
      for (; output->capacity < input->size; ++output->capacity) { \
        if (!STRING ## __init(&output->data[output->capacity])) { \
          return false; \
        } \
      } \
    } \
    output->size = input->size; \
    for (size_t i = 0; i < input->size; ++i) { \
      if (!STRING ## __copy(&input->data[i], &output->data[i])) { \
        return false; \
      } \
    } \
    return true; \
  } \
  ROS2WASM_WEAK STRING ## __Sequence * STRING ## __Sequence__create(size_t size) \
  { \
    STRING ## __Sequence * sequence = (STRING ## __Sequence *)calloc(1, sizeof(STRING ## __Sequence)); \
    if (sequence && !STRING ## __Sequence__init(sequence, size)) { \
      free(sequence); \
      sequence = NULL; \
    } \
    return sequence; \
  } \
  ROS2WASM_WEAK void STRING ## __Sequence__destroy(STRING ## __Sequence * sequence) \
  { \
    STRING ## __Sequence__fini(sequence); \
    free(sequence); \
  }

ROS2WASM_DEFINE_STRING_SEQUENCE(rosidl_runtime_c__String)
ROS2WASM_DEFINE_STRING_SEQUENCE(rosidl_runtime_c__U16String)

// --- lists of numbers ------------------------------------------------------------------------------------------------
#define ROS2WASM_DEFINE_SEQUENCE(NAME, TYPE) \
  ROS2WASM_WEAK bool rosidl_runtime_c__ ## NAME ## __Sequence__init( \
    rosidl_runtime_c__ ## NAME ## __Sequence * sequence, size_t size) \
  { \
    if (!sequence) { \
      return false; \
    } \
    sequence->data = size ? (TYPE *)calloc(size, sizeof(TYPE)) : NULL; \
    sequence->size = sequence->data ? size : 0; \
    sequence->capacity = sequence->size; \
    return sequence->size == size; \
  } \
  ROS2WASM_WEAK void rosidl_runtime_c__ ## NAME ## __Sequence__fini( \
    rosidl_runtime_c__ ## NAME ## __Sequence * sequence) \
  { \
    if (sequence) { \
      free(sequence->data); \
      sequence->data = NULL; \
      sequence->size = 0; \
      sequence->capacity = 0; \
    } \
  } \
  ROS2WASM_WEAK bool rosidl_runtime_c__ ## NAME ## __Sequence__are_equal( \
    const rosidl_runtime_c__ ## NAME ## __Sequence * lhs, \
    const rosidl_runtime_c__ ## NAME ## __Sequence * rhs) \
  { \
    if (!lhs || !rhs || lhs->size != rhs->size) { \
      return false; \
    } \
    for (size_t i = 0; i < lhs->size; ++i) { \
      if (lhs->data[i] != rhs->data[i]) { \
        return false; \
      } \
    } \
    return true; \
  } \
  ROS2WASM_WEAK bool rosidl_runtime_c__ ## NAME ## __Sequence__copy( \
    const rosidl_runtime_c__ ## NAME ## __Sequence * input, \
    rosidl_runtime_c__ ## NAME ## __Sequence * output) \
  { \
    if (!input || !output) { \
      return false; \
    } \
    if (output->capacity < input->size) { \
      TYPE * data = (TYPE *)realloc(output->data, input->size * sizeof(TYPE)); \
      if (!data) { \
        return false; \
      } \
      output->data = data; \
      output->capacity = input->size; \
    } \
    if (input->size) { \
      memcpy(output->data, input->data, input->size * sizeof(TYPE)); \
    } \
    output->size = input->size; \
    return true; \
  }

ROS2WASM_DEFINE_SEQUENCE(float, float)
ROS2WASM_DEFINE_SEQUENCE(double, double)
ROS2WASM_DEFINE_SEQUENCE(long_double, long double)
ROS2WASM_DEFINE_SEQUENCE(char, signed char)
ROS2WASM_DEFINE_SEQUENCE(wchar, uint16_t)
ROS2WASM_DEFINE_SEQUENCE(boolean, bool)
ROS2WASM_DEFINE_SEQUENCE(octet, uint8_t)
ROS2WASM_DEFINE_SEQUENCE(uint8, uint8_t)
ROS2WASM_DEFINE_SEQUENCE(int8, int8_t)
ROS2WASM_DEFINE_SEQUENCE(uint16, uint16_t)
ROS2WASM_DEFINE_SEQUENCE(int16, int16_t)
ROS2WASM_DEFINE_SEQUENCE(uint32, uint32_t)
ROS2WASM_DEFINE_SEQUENCE(int32, int32_t)
ROS2WASM_DEFINE_SEQUENCE(uint64, uint64_t)
ROS2WASM_DEFINE_SEQUENCE(int64, int64_t)

#ifdef __cplusplus
}
#endif

#endif  // ROS2WASM_C_MESSAGES__RUNTIME_H_
