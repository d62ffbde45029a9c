// Between the types of Eigen and those of KDL, by name and by tf2::convert.
#pragma once

#include <Eigen/Geometry>
#include <kdl/frames.hpp>

#include "tf2/convert.hpp"
#include "tf2_eigen_kdl/visibility_control.h"

namespace tf2 {

namespace impl {

/// Components of equal number, one by one.
template <typename FromT, typename ToT>
void copy_numbers(const FromT& from, ToT& to, int count) {
  for (int i = 0; i < count; ++i) to[i] = from[i];
}
template <typename TransformT>
void frame_to_eigen(const KDL::Frame& k, TransformT& e) {
  e.setIdentity();
  for (int i = 0; i < 3; ++i) {
    e(i, 3) = k.p[i];
    for (int j = 0; j < 3; ++j) e(i, j) = k.M(i, j);
  }
}
template <typename TransformT>
void frame_from_eigen(const TransformT& e, KDL::Frame& k) {
  for (int i = 0; i < 3; ++i) {
    k.p[i] = e(i, 3);
    for (int j = 0; j < 3; ++j) k.M(i, j) = e(i, j);
  }
}

}  // namespace impl

inline void quaternionKDLToEigen(const KDL::Rotation& k, Eigen::Quaterniond& e) {
  k.GetQuaternion(e.x(), e.y(), e.z(), e.w());
}
inline void quaternionEigenToKDL(const Eigen::Quaterniond& e, KDL::Rotation& k) {
  k = KDL::Rotation::Quaternion(e.x(), e.y(), e.z(), e.w());
}
inline void transformKDLToEigen(const KDL::Frame& k, Eigen::Affine3d& e) {
  impl::frame_to_eigen(k, e);
}
inline void transformKDLToEigen(const KDL::Frame& k, Eigen::Isometry3d& e) {
  impl::frame_to_eigen(k, e);
}
inline void transformEigenToKDL(const Eigen::Affine3d& e, KDL::Frame& k) {
  impl::frame_from_eigen(e, k);
}
inline void transformEigenToKDL(const Eigen::Isometry3d& e, KDL::Frame& k) {
  impl::frame_from_eigen(e, k);
}
/// Linear velocity first.
inline void twistKDLToEigen(const KDL::Twist& k, Eigen::Matrix<double, 6, 1>& e) {
  impl::copy_numbers(k, e, 6);
}
inline void twistEigenToKDL(const Eigen::Matrix<double, 6, 1>& e, KDL::Twist& k) {
  impl::copy_numbers(e, k, 6);
}
inline void vectorKDLToEigen(const KDL::Vector& k, Eigen::Matrix<double, 3, 1>& e) {
  impl::copy_numbers(k, e, 3);
}
inline void vectorEigenToKDL(const Eigen::Matrix<double, 3, 1>& e, KDL::Vector& k) {
  impl::copy_numbers(e, k, 3);
}
/// Force first.
inline void wrenchKDLToEigen(const KDL::Wrench& k, Eigen::Matrix<double, 6, 1>& e) {
  impl::copy_numbers(k, e, 6);
}
inline void wrenchEigenToKDL(const Eigen::Matrix<double, 6, 1>& e, KDL::Wrench& k) {
  impl::copy_numbers(e, k, 6);
}

namespace impl {

template <>
template <>
inline void Converter<false, false>::convert(const KDL::Rotation& a, Eigen::Quaterniond& b) {
  quaternionKDLToEigen(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const Eigen::Quaterniond& a, KDL::Rotation& b) {
  quaternionEigenToKDL(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const KDL::Frame& a, Eigen::Affine3d& b) {
  transformKDLToEigen(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const KDL::Frame& a, Eigen::Isometry3d& b) {
  transformKDLToEigen(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const Eigen::Affine3d& a, KDL::Frame& b) {
  transformEigenToKDL(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const Eigen::Isometry3d& a, KDL::Frame& b) {
  transformEigenToKDL(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const KDL::Twist& a, Eigen::Matrix<double, 6, 1>& b) {
  twistKDLToEigen(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const Eigen::Matrix<double, 6, 1>& a, KDL::Twist& b) {
  twistEigenToKDL(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const KDL::Vector& a, Eigen::Matrix<double, 3, 1>& b) {
  vectorKDLToEigen(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const Eigen::Matrix<double, 3, 1>& a, KDL::Vector& b) {
  vectorEigenToKDL(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const KDL::Wrench& a, Eigen::Matrix<double, 6, 1>& b) {
  wrenchKDLToEigen(a, b);
}
template <>
template <>
inline void Converter<false, false>::convert(const Eigen::Matrix<double, 6, 1>& a, KDL::Wrench& b) {
  wrenchEigenToKDL(a, b);
}

}  // namespace impl
}  // namespace tf2
