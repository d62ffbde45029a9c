// The mean of the last so many values.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace rcpputils {

template <typename T>
class RollingMeanAccumulator {
 public:
  explicit RollingMeanAccumulator(size_t rolling_window_size) : buffer_(rolling_window_size, T()) {}

  void accumulate(T value) {
    sum_ += value - buffer_[next_];
    buffer_[next_] = value;
    next_ = (next_ + 1) % buffer_.size();
    count_ += count_ < buffer_.size() ? 1 : 0;
  }

  T getRollingMean() const {
    assert(count_ > 0);
    return sum_ / static_cast<T>(count_);
  }

 private:
  std::vector<T> buffer_;
  size_t next_ = 0;
  size_t count_ = 0;
  T sum_ = T();
};

}  // namespace rcpputils
