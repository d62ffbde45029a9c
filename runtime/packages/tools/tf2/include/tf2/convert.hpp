// Conversions between messages and other types. For each type there are overloads or
// specialisations of these functions, in packages such as tf2_geometry_msgs.
#pragma once

#include <array>
#include <string>
#include <type_traits>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rosidl_runtime_cpp/traits.hpp"
#include "tf2/exceptions.hpp"
#include "tf2/impl/convert.hpp"
#include "tf2/transform_datatypes.hpp"

namespace tf2 {

template <class T>
void doTransform(const T& data_in, T& data_out,
                 const geometry_msgs::msg::TransformStamped& transform);
template <class T>
TimePoint getTimestamp(const T& t);
template <class T>
std::string getFrameId(const T& t);
template <class T>
std::array<std::array<double, 6>, 6> getCovarianceMatrix(const T& t);

template <class P>
TimePoint getTimestamp(const Stamped<P>& t) {
  return t.stamp_;
}
template <class P>
std::string getFrameId(const Stamped<P>& t) {
  return t.frame_id_;
}
template <class P>
TimePoint getTimestamp(const WithCovarianceStamped<P>& t) {
  return t.stamp_;
}
template <class P>
std::string getFrameId(const WithCovarianceStamped<P>& t) {
  return t.frame_id_;
}
template <class P>
std::array<std::array<double, 6>, 6> getCovarianceMatrix(const WithCovarianceStamped<P>& t) {
  return t.cov_mat_;
}

template <typename A, typename B>
B toMsg(const A& a);
template <typename A, typename B>
void fromMsg(const A& a, B& b);

/// Between a message and another type, or between two other types by way of a message.
template <class A, class B>
void convert(const A& a, B& b) {
  impl::Converter<rosidl_generator_traits::is_message<A>::value,
                  rosidl_generator_traits::is_message<B>::value>::convert(a, b);
}
template <class A>
void convert(const A& a1, A& a2) {
  a2 = a1;
}

inline std::array<std::array<double, 6>, 6> covarianceRowMajorToNested(
    const std::array<double, 36>& row_major) {
  std::array<std::array<double, 6>, 6> nested;
  for (size_t i = 0; i < row_major.size(); ++i) {
    nested[i / 6][i % 6] = row_major[i];
  }
  return nested;
}
inline std::array<double, 36> covarianceNestedToRowMajor(
    const std::array<std::array<double, 6>, 6>& nested_array) {
  std::array<double, 36> row_major;
  for (size_t i = 0; i < row_major.size(); ++i) {
    row_major[i] = nested_array[i / 6][i % 6];
  }
  return row_major;
}

}  // namespace tf2
