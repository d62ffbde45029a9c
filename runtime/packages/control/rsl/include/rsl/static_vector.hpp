// A vector that never allocates: parameters of types such as `double_array_fixed_N`.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <vector>

#include "tcb_span/span.hpp"

namespace rsl {

/// At most `capacity` elements; what is more is cut, which is a mistake of the caller.
template <class T, size_t capacity>
class StaticVector {
 public:
  StaticVector() = default;
  StaticVector(const std::initializer_list<T>& values) { assign(values); }
  template <class CollectionT, class = std::enable_if_t<!std::is_same_v<CollectionT, StaticVector>>>
  StaticVector(const CollectionT& values) {
    assign(values);
  }

  [[nodiscard]] auto begin() { return values_.begin(); }
  [[nodiscard]] auto begin() const { return values_.cbegin(); }
  [[nodiscard]] auto end() { return begin() + static_cast<std::ptrdiff_t>(size_); }
  [[nodiscard]] auto end() const { return begin() + static_cast<std::ptrdiff_t>(size_); }
  operator tcb::span<T>() { return {values_.data(), size_}; }
  operator tcb::span<const T>() const { return {values_.data(), size_}; }

 private:
  template <class CollectionT>
  void assign(const CollectionT& values) {
    assert(values.size() <= capacity);
    size_ = std::min(static_cast<size_t>(values.size()), capacity);
    std::copy_n(values.begin(), size_, values_.begin());
  }

  std::array<T, capacity> values_{};
  size_t size_ = 0;
};

template <class T, size_t capacity>
[[nodiscard]] std::vector<T> to_vector(const StaticVector<T, capacity>& values) {
  return std::vector<T>(values.begin(), values.end());
}

}  // namespace rsl
