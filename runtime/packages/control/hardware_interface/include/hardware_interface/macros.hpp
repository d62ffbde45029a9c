// Checks of pointers that throw std::runtime_error.
#pragma once

#include <stdexcept>
#include <string>

#define THROW_ON_NULLPTR(pointer)                                                                  \
  if (!(pointer)) {                                                                                \
    throw std::runtime_error(std::string(__PRETTY_FUNCTION__) + " failed. " #pointer " is null."); \
  }

#define THROW_ON_NOT_NULLPTR(pointer)                                                  \
  if (pointer) {                                                                       \
    throw std::runtime_error(std::string(__PRETTY_FUNCTION__) + " failed. " #pointer   \
                                                                " would leak memory"); \
  }
