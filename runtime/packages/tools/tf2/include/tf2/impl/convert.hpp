// Which of toMsg and fromMsg a conversion needs. The functions are found where it is used.
#pragma once

namespace tf2 {
namespace impl {

template <bool IsMessageA, bool IsMessageB>
class Converter {
 public:
  template <typename A, typename B>
  static void convert(const A& a, B& b) {
    static_assert(!IsMessageA || !IsMessageB, "between two messages there is no conversion");
    if constexpr (IsMessageA) {
      fromMsg(a, b);
    } else if constexpr (IsMessageB) {
      b = toMsg(a);
    } else {
      fromMsg(toMsg(a), b);
    }
  }
};

}  // namespace impl
}  // namespace tf2
