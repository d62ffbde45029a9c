// The program's name.
#pragma once

#include <stdexcept>
#include <string>

#include "rcutils/allocator.h"
#include "rcutils/process.h"

namespace rcpputils {

inline std::string get_executable_name() {
  const rcutils_allocator_t allocator = rcutils_get_default_allocator();
  char* const name = rcutils_get_executable_name(allocator);
  if (name == nullptr) {
    throw std::runtime_error("Failed to get executable name");
  }
  std::string result(name);
  allocator.deallocate(name, allocator.state);
  return result;
}

}  // namespace rcpputils
