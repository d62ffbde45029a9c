// The smaller and the larger of two values.
#pragma once

#include <algorithm>

#include "tf2/LinearMath/Scalar.hpp"

template <class T>
const T& tf2Min(const T& a, const T& b) {
  return std::min(a, b);
}
template <class T>
const T& tf2Max(const T& a, const T& b) {
  return std::max(a, b);
}
template <class T>
void tf2SetMin(T& a, const T& b) {
  a = std::min(a, b);
}
template <class T>
void tf2SetMax(T& a, const T& b) {
  a = std::max(a, b);
}
template <class T>
const T& GEN_clamped(const T& a, const T& low, const T& high) {
  return std::min(std::max(a, low), high);
}
template <class T>
void GEN_clamp(T& a, const T& low, const T& high) {
  a = GEN_clamped(a, low, high);
}
