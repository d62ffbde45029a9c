// std::span for C++17, under the name that packages of ROS 2 know: a view of elements that others
// own.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace tcb {

inline constexpr size_t dynamic_extent = std::numeric_limits<size_t>::max();

/// `extent`: how many elements there are, when that is known at compile time.
template <class T, size_t extent = dynamic_extent>
class span {
 public:
  using element_type = T;
  using value_type = std::remove_cv_t<T>;
  using size_type = size_t;
  using difference_type = std::ptrdiff_t;
  using pointer = T*;
  using const_pointer = const T*;
  using reference = T&;
  using const_reference = const T&;
  using iterator = T*;

  constexpr span() noexcept = default;
  constexpr span(T* first, size_t count) : first_(first), count_(count) {}
  constexpr span(T* first, T* last) : span(first, static_cast<size_t>(last - first)) {}
  template <size_t count>
  constexpr span(T (&elements)[count]) noexcept : span(elements, count) {}
  /// Whatever has data() and size(): vectors, arrays, other spans.
  template <
      class ContainerT,
      class = std::enable_if_t<
          !std::is_same_v<std::decay_t<ContainerT>, span> &&
          std::is_convertible_v<
              std::remove_pointer_t<decltype(std::declval<ContainerT&>().data())> (*)[], T (*)[]>>>
  constexpr span(ContainerT&& container) : span(container.data(), container.size()) {}

  constexpr T* begin() const noexcept { return first_; }
  constexpr T* end() const noexcept { return first_ + count_; }
  constexpr T* data() const noexcept { return first_; }
  constexpr size_t size() const noexcept { return count_; }
  constexpr size_t size_bytes() const noexcept { return count_ * sizeof(T); }
  constexpr bool empty() const noexcept { return count_ == 0; }
  constexpr T& operator[](size_t index) const { return first_[index]; }
  constexpr T& front() const { return first_[0]; }
  constexpr T& back() const { return first_[count_ - 1]; }
  constexpr span<T> first(size_t count) const { return {first_, count}; }
  constexpr span<T> last(size_t count) const { return {first_ + (count_ - count), count}; }
  constexpr span<T> subspan(size_t from, size_t count = dynamic_extent) const {
    return {first_ + from, count == dynamic_extent ? count_ - from : count};
  }

 private:
  T* first_ = nullptr;
  size_t count_ = extent == dynamic_extent ? 0 : extent;
};

template <class T, size_t count>
span(T (&)[count]) -> span<T, count>;
template <class T, size_t count>
span(std::array<T, count>&) -> span<T, count>;
template <class T, size_t count>
span(const std::array<T, count>&) -> span<const T, count>;
template <class ContainerT>
span(ContainerT&) -> span<std::remove_pointer_t<decltype(std::declval<ContainerT&>().data())>>;

}  // namespace tcb
