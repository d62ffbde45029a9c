// See inertia.hpp.
#include "sdf/inertia.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ros2wasm_sim {
namespace {

using Matrix3 = std::array<Vector3, 3>;  ///< rows

/// The moments along the axes of the frame that the pose is in.
Matrix3 turned(const Inertial& body) {
  const Quaternion& q = body.pose.orientation;
  // The columns of the rotation.
  const Vector3 x = rotate(q, {1, 0, 0});
  const Vector3 y = rotate(q, {0, 1, 0});
  const Vector3 z = rotate(q, {0, 0, 1});
  const auto part = [&](double Vector3::*i, double Vector3::*j) {
    return body.ixx * x.*i * x.*j + body.iyy * y.*i * y.*j + body.izz * z.*i * z.*j +
           body.ixy * (x.*i * y.*j + y.*i * x.*j) + body.ixz * (x.*i * z.*j + z.*i * x.*j) +
           body.iyz * (y.*i * z.*j + z.*i * y.*j);
  };
  const std::array<double Vector3::*, 3> axes{&Vector3::x, &Vector3::y, &Vector3::z};
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = {part(axes[i], axes[0]), part(axes[i], axes[1]), part(axes[i], axes[2])};
  }
  return result;
}

Inertial body_of(double mass, double ixx, double iyy, double izz) {
  Inertial result;
  result.mass = mass;
  result.ixx = ixx;
  result.iyy = iyy;
  result.izz = izz;
  return result;
}

Inertial solid_box(const Vector3& size, double density) {
  const double mass = density * size.x * size.y * size.z;
  const double x = size.x * size.x, y = size.y * size.y, z = size.z * size.z;
  return body_of(mass, mass * (y + z) / 12, mass * (x + z) / 12, mass * (x + y) / 12);
}

Inertial solid_cylinder(double radius, double length, double density) {
  const double mass = density * std::numbers::pi * radius * radius * length;
  const double across = mass * (3 * radius * radius + length * length) / 12;
  return body_of(mass, across, across, mass * radius * radius / 2);
}

Inertial solid_ellipsoid(const Vector3& radii, double density) {
  const double mass = density * 4 / 3 * std::numbers::pi * radii.x * radii.y * radii.z;
  const double x = radii.x * radii.x, y = radii.y * radii.y, z = radii.z * radii.z;
  return body_of(mass, mass * (y + z) / 5, mass * (x + z) / 5, mass * (x + y) / 5);
}

/// A cylinder and two half spheres, whose centres of mass are 3/8 of the radius from its ends.
Inertial solid_capsule(double radius, double length, double density) {
  const Inertial cylinder = solid_cylinder(radius, length, density);
  const double sphere = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  const double r2 = radius * radius;
  const double across =
      sphere * (2 * r2 / 5 + length * length / 4 + 3 * length * radius / 8) + cylinder.ixx;
  return body_of(cylinder.mass + sphere, across, across, cylinder.izz + sphere * 2 * r2 / 5);
}

}  // namespace

Inertial combined(const std::vector<Inertial>& bodies) {
  if (bodies.size() == 1) {
    return bodies.front();
  }
  Inertial result = body_of(0, 0, 0, 0);
  Vector3 centre;
  for (const Inertial& body : bodies) {
    result.mass += body.mass;
    centre = centre + body.mass * body.pose.position;
  }
  centre = result.mass > 0 ? (1 / result.mass) * centre : Vector3{};
  result.pose.position = centre;
  for (const Inertial& body : bodies) {
    const Matrix3 moments = turned(body);
    const Vector3 d = body.pose.position - centre;
    result.ixx += moments[0].x + body.mass * (d.y * d.y + d.z * d.z);
    result.iyy += moments[1].y + body.mass * (d.x * d.x + d.z * d.z);
    result.izz += moments[2].z + body.mass * (d.x * d.x + d.y * d.y);
    result.ixy += moments[0].y - body.mass * d.x * d.y;
    result.ixz += moments[0].z - body.mass * d.x * d.z;
    result.iyz += moments[1].z - body.mass * d.y * d.z;
  }
  return result;
}

std::optional<Inertial> solid(const Geometry& geometry, double density) {
  if (const auto* box = std::get_if<Box>(&geometry)) {
    return solid_box(box->size, density);
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    return solid_cylinder(cylinder->radius, cylinder->length, density);
  }
  if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
    return solid_ellipsoid({sphere->radius, sphere->radius, sphere->radius}, density);
  }
  if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
    return solid_capsule(capsule->radius, capsule->length, density);
  }
  if (const auto* ellipsoid = std::get_if<Ellipsoid>(&geometry)) {
    return solid_ellipsoid(ellipsoid->radii, density);
  }
  return std::nullopt;
}

bool is_possible(const Inertial& i) {
  const double tolerance = 1e-6 * (std::fabs(i.ixx) + std::fabs(i.iyy) + std::fabs(i.izz));
  const double minor = i.ixx * i.iyy - i.ixy * i.ixy;
  const double determinant = i.ixx * (i.iyy * i.izz - i.iyz * i.iyz) -
                             i.ixy * (i.ixy * i.izz - i.iyz * i.ixz) +
                             i.ixz * (i.ixy * i.iyz - i.iyy * i.ixz);
  return i.ixx > 0 && i.iyy > 0 && i.izz > 0 && minor > 0 && determinant > 0 &&
         i.ixx <= i.iyy + i.izz + tolerance && i.iyy <= i.ixx + i.izz + tolerance &&
         i.izz <= i.ixx + i.iyy + tolerance;
}

}  // namespace ros2wasm_sim
