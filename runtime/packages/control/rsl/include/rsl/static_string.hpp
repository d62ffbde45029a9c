// A string that never allocates: parameters of type `string_fixed_N`.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <string>
#include <string_view>

namespace rsl {

/// At most `capacity` bytes; a longer text is cut, which is a mistake of the caller.
template <size_t capacity>
class StaticString {
 public:
  StaticString() = default;
  StaticString(const std::string& text) : size_(std::min(text.size(), capacity)) {
    assert(text.size() <= capacity);
    std::copy_n(text.begin(), size_, bytes_.begin());
  }

  [[nodiscard]] auto begin() const { return bytes_.cbegin(); }
  [[nodiscard]] auto end() const { return begin() + static_cast<std::ptrdiff_t>(size_); }
  operator std::string_view() const { return {bytes_.data(), size_}; }

 private:
  std::array<char, capacity> bytes_{};
  size_t size_ = 0;
};

template <size_t capacity>
[[nodiscard]] std::string to_string(const StaticString<capacity>& text) {
  return std::string(text.begin(), text.end());
}

}  // namespace rsl
