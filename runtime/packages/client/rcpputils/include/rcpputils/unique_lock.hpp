// std::unique_lock, as thread safety analysis understands it.
#pragma once

#include <mutex>

#include "rcpputils/thread_safety_annotations.hpp"

namespace rcpputils {

template <typename MutexT>
class RCPPUTILS_TSA_SCOPED_CAPABILITY unique_lock : public std::unique_lock<MutexT> {
 public:
  explicit unique_lock(MutexT& mu) RCPPUTILS_TSA_ACQUIRE(mu) : std::unique_lock<MutexT>(mu) {}
  ~unique_lock() RCPPUTILS_TSA_RELEASE() {}
};

}  // namespace rcpputils
