// See shape_extent.hpp.
#include "checks/shape_extent.hpp"

namespace ros2wasm_sim {
namespace {

constexpr double square(double x) {
  return x * x;
}

}  // namespace

std::optional<double> extent(const Geometry& geometry, const Quaternion& orientation,
                             const Vector3& direction) {
  const Vector3 d = rotate(inverse(orientation), direction);
  if (const auto* box = std::get_if<Box>(&geometry))
    return (std::abs(d.x) * box->size.x + std::abs(d.y) * box->size.y +
            std::abs(d.z) * box->size.z) /
           2;
  if (const auto* one = std::get_if<Cylinder>(&geometry))
    return std::abs(d.z) * one->length / 2 + std::hypot(d.x, d.y) * one->radius;
  if (const auto* sphere = std::get_if<Sphere>(&geometry)) return sphere->radius;
  if (const auto* one = std::get_if<Capsule>(&geometry))
    return std::abs(d.z) * one->length / 2 + one->radius;
  if (const auto* one = std::get_if<Ellipsoid>(&geometry))
    return std::sqrt(square(d.x * one->radii.x) + square(d.y * one->radii.y) +
                     square(d.z * one->radii.z));
  return std::nullopt;
}

}  // namespace ros2wasm_sim
