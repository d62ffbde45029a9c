// Limits a value and its first two derivatives from step to step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace control_toolbox {

template <typename T>
class RateLimiter {
 public:
  static constexpr T kUnset = std::numeric_limits<T>::quiet_NaN();

  /// A limit whose maximum is NaN is off; a minimum that is NaN is minus the maximum. The `_pos`
  /// and `_neg` limits of the first derivative are those for values above and below 0. Throws
  /// std::invalid_argument for limits that are the wrong way round.
  RateLimiter(T min_value = kUnset, T max_value = kUnset, T min_first_derivative_neg = kUnset,
              T max_first_derivative_pos = kUnset, T min_first_derivative_pos = kUnset,
              T max_first_derivative_neg = kUnset, T min_second_derivative = kUnset,
              T max_second_derivative = kUnset) {
    set_params(min_value, max_value, min_first_derivative_neg, max_first_derivative_pos,
               min_first_derivative_pos, max_first_derivative_neg, min_second_derivative,
               max_second_derivative);
  }

  void set_params(T min_value = kUnset, T max_value = kUnset, T min_first_derivative_neg = kUnset,
                  T max_first_derivative_pos = kUnset, T min_first_derivative_pos = kUnset,
                  T max_first_derivative_neg = kUnset, T min_second_derivative = kUnset,
                  T max_second_derivative = kUnset) {
    const Limits value = limits(min_value, max_value, "Invalid value limits");
    const char* const wrong_first = "Invalid first derivative limits";
    const Limits neg_pos = limits(min_first_derivative_neg, max_first_derivative_pos, wrong_first);
    Limits pos_neg = neg_pos;
    if (neg_pos.are_on) {
      if (!std::isnan(min_first_derivative_pos)) pos_neg.min = min_first_derivative_pos;
      if (!std::isnan(max_first_derivative_neg)) pos_neg.max = max_first_derivative_neg;
      if (pos_neg.min > pos_neg.max) throw std::invalid_argument(wrong_first);
    }
    const Limits second =
        limits(min_second_derivative, max_second_derivative, "Invalid second derivative limits");
    value_ = value;
    first_at_rest_ = neg_pos;
    first_above_ = {neg_pos.are_on, pos_neg.min, neg_pos.max};
    first_below_ = {neg_pos.are_on, neg_pos.min, pos_neg.max};
    second_ = second;
  }

  /// Limits `v`, after `v0` and before that `v1`, each `dt` [s] later. Returns the factor by which
  /// it was changed.
  T limit(T& v, T v0, T v1, T dt) {
    const T wanted = v;
    limit_second_derivative(v, v0, v1, dt);
    limit_first_derivative(v, v0, dt);
    limit_value(v);
    return factor(v, wanted);
  }

  T limit_value(T& v) {
    const T wanted = v;
    if (value_.are_on) v = std::clamp(v, value_.min, value_.max);
    return factor(v, wanted);
  }

  T limit_first_derivative(T& v, T v0, T dt) {
    const T wanted = v;
    const Limits& now = v0 > T(0) ? first_above_ : (v0 < T(0) ? first_below_ : first_at_rest_);
    if (now.are_on) v = v0 + std::clamp(v - v0, now.min * dt, now.max * dt);
    return factor(v, wanted);
  }

  /// Only while the value gets away from the last one faster: slowing down would swing otherwise.
  T limit_second_derivative(T& v, T v0, T v1, T dt) {
    const T wanted = v;
    const T dv = v - v0;
    const T dv0 = v0 - v1;
    if (second_.are_on && (dv - dv0) * dv > T(0)) {
      v = v0 + dv0 + std::clamp(dv - dv0, second_.min * dt * dt, second_.max * dt * dt);
    }
    return factor(v, wanted);
  }

 private:
  struct Limits {
    bool are_on = false;
    T min = kUnset;
    T max = kUnset;
  };

  static Limits limits(T min, T max, const char* wrong) {
    if (std::isnan(max)) return {};
    if (std::isnan(min)) min = -max;
    if (min > max) throw std::invalid_argument(wrong);
    return {true, min, max};
  }
  static T factor(T v, T wanted) { return wanted != T(0) ? v / wanted : T(1); }

  Limits value_;
  Limits first_at_rest_;
  Limits first_above_;  ///< for values above 0
  Limits first_below_;
  Limits second_;
};

}  // namespace control_toolbox
