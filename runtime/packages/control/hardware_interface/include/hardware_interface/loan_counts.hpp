// How often a loaned interface could not be read or written at once.
#pragma once

#include <thread>

#include "hardware_interface/handle.hpp"

namespace hardware_interface {
namespace detail {

struct LoanCounts {
  unsigned int total = 0;
  unsigned int failed = 0;
  unsigned int timeouts = 0;

  /// Tries until `attempt` is true, at most `max_tries` times; false when it never was.
  template <typename AttemptT>
  bool repeat(unsigned int max_tries, const AttemptT& attempt) {
    ++total;
    for (unsigned int tries = 0; tries < max_tries; ++tries) {
      if (attempt()) {
        return true;
      }
      ++failed;
      std::this_thread::yield();
    }
    ++timeouts;
    return false;
  }
  /// Warns when something failed.
  void report(const char* kind, const Handle& handle, const char* calls) const;
};

}  // namespace detail
}  // namespace hardware_interface
