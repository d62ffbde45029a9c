// The byte order of the machine.
#pragma once

#if __cplusplus > 201703L
#include <bit>

namespace rcpputils {
using std::endian;
}  // namespace rcpputils

#define RCPPUTILS_HAVE_STD_ENDIAN 1
#else

namespace rcpputils {

enum class endian {
  little = __ORDER_LITTLE_ENDIAN__,
  big = __ORDER_BIG_ENDIAN__,
  native = __BYTE_ORDER__
};

}  // namespace rcpputils
#endif
