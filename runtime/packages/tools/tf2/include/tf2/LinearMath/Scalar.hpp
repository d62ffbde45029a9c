// Numbers of the linear algebra: their type, constants and functions.
#pragma once

#include <cassert>
#include <cfloat>
#include <cmath>
#include <utility>

#define TF2SIMD_FORCE_INLINE inline
#define ATTRIBUTE_ALIGNED16(a) a
#define tf2Assert(x)
#define tf2FullAssert(x)

typedef double tf2Scalar;

#define TF2_LARGE_FLOAT 1e30
#define TF2SIMD_2_PI tf2Scalar(6.283185307179586232)
#define TF2SIMD_PI (TF2SIMD_2_PI * tf2Scalar(0.5))
#define TF2SIMD_HALF_PI (TF2SIMD_2_PI * tf2Scalar(0.25))
#define TF2SIMD_RADS_PER_DEG (TF2SIMD_2_PI / tf2Scalar(360.0))
#define TF2SIMD_DEGS_PER_RAD (tf2Scalar(360.0) / TF2SIMD_2_PI)
#define TF2SIMDSQRT12 tf2Scalar(0.7071067811865475244)
#define TF2SIMD_EPSILON DBL_EPSILON
#define TF2SIMD_INFINITY DBL_MAX

inline tf2Scalar tf2Sqrt(tf2Scalar x) {
  return std::sqrt(x);
}
inline tf2Scalar tf2RecipSqrt(tf2Scalar x) {
  return 1.0 / std::sqrt(x);
}
inline tf2Scalar tf2Fabs(tf2Scalar x) {
  return std::fabs(x);
}
inline tf2Scalar tf2Cos(tf2Scalar x) {
  return std::cos(x);
}
inline tf2Scalar tf2Sin(tf2Scalar x) {
  return std::sin(x);
}
inline tf2Scalar tf2Tan(tf2Scalar x) {
  return std::tan(x);
}
/// Takes what rounding put a little outside of [-1, 1] as the end of that range.
inline tf2Scalar tf2Acos(tf2Scalar x) {
  return std::acos(x < -1 ? -1 : x > 1 ? 1 : x);
}
/// As tf2Acos.
inline tf2Scalar tf2Asin(tf2Scalar x) {
  return std::asin(x < -1 ? -1 : x > 1 ? 1 : x);
}
inline tf2Scalar tf2Atan(tf2Scalar x) {
  return std::atan(x);
}
inline tf2Scalar tf2Atan2(tf2Scalar y, tf2Scalar x) {
  return std::atan2(y, x);
}
inline tf2Scalar tf2Exp(tf2Scalar x) {
  return std::exp(x);
}
inline tf2Scalar tf2Log(tf2Scalar x) {
  return std::log(x);
}
inline tf2Scalar tf2Pow(tf2Scalar x, tf2Scalar y) {
  return std::pow(x, y);
}
inline tf2Scalar tf2Fmod(tf2Scalar x, tf2Scalar y) {
  return std::fmod(x, y);
}

inline bool tf2FuzzyZero(tf2Scalar x) {
  return std::fabs(x) < TF2SIMD_EPSILON;
}
inline bool tf2Equal(tf2Scalar a, tf2Scalar eps) {
  return -eps <= a && a <= eps;
}
inline bool tf2GreaterEqual(tf2Scalar a, tf2Scalar eps) {
  return a > eps;
}
inline int tf2IsNegative(tf2Scalar x) {
  return x < 0 ? 1 : 0;
}
inline tf2Scalar tf2Radians(tf2Scalar degrees) {
  return degrees * TF2SIMD_RADS_PER_DEG;
}
inline tf2Scalar tf2Degrees(tf2Scalar radians) {
  return radians * TF2SIMD_DEGS_PER_RAD;
}
inline tf2Scalar tf2Fsel(tf2Scalar a, tf2Scalar not_negative, tf2Scalar negative) {
  return a >= 0 ? not_negative : negative;
}
template <typename T>
void tf2Swap(T& a, T& b) {
  std::swap(a, b);
}
/// The same angle in [-pi, pi].
inline tf2Scalar tf2NormalizeAngle(tf2Scalar radians) {
  const tf2Scalar angle = std::fmod(radians, TF2SIMD_2_PI);
  return angle < -TF2SIMD_PI  ? angle + TF2SIMD_2_PI
         : angle > TF2SIMD_PI ? angle - TF2SIMD_2_PI
                              : angle;
}
