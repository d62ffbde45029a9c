#pragma once
#include <cstdint>

inline std::size_t bytes_of_int() {
  return sizeof(std::int32_t);
}
