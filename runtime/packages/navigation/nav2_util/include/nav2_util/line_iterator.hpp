// The cells on a line between two cells, after Bresenham.
#pragma once

#include <cstdlib>

namespace nav2_util {

class LineIterator {
 public:
  LineIterator(int x0, int y0, int x1, int y1)
      : x0_(x0),
        y0_(y0),
        x1_(x1),
        y1_(y1),
        x_(x0),
        y_(y0),
        x_sign_(x1 >= x0 ? 1 : -1),
        y_sign_(y1 >= y0 ? 1 : -1),
        is_flat_(std::abs(x1 - x0) >= std::abs(y1 - y0)),
        long_side_(is_flat_ ? std::abs(x1 - x0) : std::abs(y1 - y0)),
        short_side_(is_flat_ ? std::abs(y1 - y0) : std::abs(x1 - x0)),
        error_(long_side_ / 2) {}

  /// False once the last cell was passed.
  bool isValid() const { return steps_ <= long_side_; }

  void advance() {
    error_ += short_side_;
    const bool steps_aside = error_ >= long_side_;
    if (steps_aside) error_ -= long_side_;
    if (is_flat_ || steps_aside) x_ += x_sign_;
    if (!is_flat_ || steps_aside) y_ += y_sign_;
    ++steps_;
  }

  int getX() const { return x_; }
  int getY() const { return y_; }
  int getX0() const { return x0_; }
  int getY0() const { return y0_; }
  int getX1() const { return x1_; }
  int getY1() const { return y1_; }

 private:
  int x0_;
  int y0_;
  int x1_;
  int y1_;
  int x_;
  int y_;
  int x_sign_;
  int y_sign_;
  bool is_flat_;  // more columns than rows
  int long_side_;
  int short_side_;
  int error_;
  int steps_ = 0;
};

}  // namespace nav2_util
