// The first include of its sources, so that nothing else brings std::max.
#pragma once
#include <cmath>

inline int larger(int a, int b) {
  return std::max(a, static_cast<int>(std::fabs(b)));
}
