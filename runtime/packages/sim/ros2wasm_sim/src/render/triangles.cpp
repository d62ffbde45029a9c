// See triangles.hpp.
#include "render/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <variant>

namespace ros2wasm_sim {
namespace {

constexpr int kSides = 32;  ///< of round shapes
constexpr double kFullTurn = 2 * std::numbers::pi;

Corner corner(const Vector3& at, const Vector3& normal, double u, double v) {
  const auto f = [](double value) { return static_cast<float>(value); };
  return {{f(at.x), f(at.y), f(at.z)}, {f(normal.x), f(normal.y), f(normal.z)}, f(u), f(v)};
}

/// A rectangle with `right` and `up` as half sides, seen from where `right` x `up` points.
void add_rectangle(const Vector3& middle, const Vector3& right, const Vector3& up,
                   Triangles& result) {
  const Vector3 across = cross(right, up);
  const double size = length(across);
  if (!(size > 0)) return;
  const Vector3 normal = (1 / size) * across;
  const Corner a = corner(middle - right - up, normal, 0, 1);
  const Corner b = corner(middle + right - up, normal, 1, 1);
  const Corner c = corner(middle + right + up, normal, 1, 0);
  const Corner d = corner(middle - right + up, normal, 0, 0);
  result.insert(result.end(), {a, b, c, a, c, d});
}

Triangles box(const Vector3& size) {
  Triangles result;
  const Vector3 x{size.x / 2, 0, 0}, y{0, size.y / 2, 0}, z{0, 0, size.z / 2};
  add_rectangle(x, y, z, result);
  add_rectangle(-1.0 * x, -1.0 * y, z, result);
  add_rectangle(y, -1.0 * x, z, result);
  add_rectangle(-1.0 * y, x, z, result);
  add_rectangle(z, x, y, result);
  add_rectangle(-1.0 * z, x, -1.0 * y, result);
  return result;
}

/// A ring of a surface of revolution about z.
struct Ring {
  double radius, z;
  double normal_out, normal_up;  ///< of the surface, of length 1 together
};

void add_band(const Ring& lower, const Ring& upper, double v_lower, double v_upper,
              Triangles& result) {
  for (int i = 0; i < kSides; ++i) {
    const auto at = [&](const Ring& ring, int side, double v) {
      const double angle = kFullTurn * side / kSides;
      const double c = std::cos(angle), s = std::sin(angle);
      return corner({ring.radius * c, ring.radius * s, ring.z},
                    {ring.normal_out * c, ring.normal_out * s, ring.normal_up},
                    static_cast<double>(side) / kSides, v);
    };
    const Corner a = at(lower, i, v_lower), b = at(lower, i + 1, v_lower);
    const Corner c = at(upper, i + 1, v_upper), d = at(upper, i, v_upper);
    if (lower.radius > 0) result.insert(result.end(), {a, b, c});
    if (upper.radius > 0) result.insert(result.end(), {a, c, d});
  }
}

Triangles cylinder(double radius, double length) {
  Triangles result;
  const double z = length / 2;
  add_band({0, -z, 0, -1}, {radius, -z, 0, -1}, 0.5, 1, result);
  add_band({radius, -z, 1, 0}, {radius, z, 1, 0}, 1, 0, result);
  add_band({radius, z, 0, 1}, {0, z, 0, 1}, 0, 0.5, result);
  return result;
}

/// A sphere whose halves are `length` apart.
Triangles capsule(double radius, double length) {
  Triangles result;
  constexpr int kBands = kSides / 4;  // of a half sphere
  std::vector<Ring> rings;
  for (int half : {-1, 1})
    for (int i = 0; i <= kBands; ++i) {
      const double angle = kFullTurn / 4 * (half < 0 ? i - kBands : i) / kBands;
      const bool is_pole = i == (half < 0 ? 0 : kBands);
      rings.push_back({is_pole ? 0 : radius * std::cos(angle),
                       radius * std::sin(angle) + half * length / 2, std::cos(angle),
                       std::sin(angle)});
    }
  const auto v_of = [&](std::size_t i) { return 1 - static_cast<double>(i) / (rings.size() - 1); };
  for (std::size_t i = 1; i < rings.size(); ++i)
    if (length > 0 || i != kBands + 1)
      add_band(rings[i - 1], rings[i], v_of(i - 1), v_of(i), result);
  return result;
}

Triangles ellipsoid(const Vector3& radii) {
  Triangles result = capsule(1, 0);
  for (Corner& one : result) {
    const double scale[3] = {radii.x, radii.y, radii.z};
    double size = 0;
    for (int i = 0; i < 3; ++i) {
      one.position[i] = static_cast<float>(one.position[i] * scale[i]);
      one.normal[i] = static_cast<float>(one.normal[i] / std::max(scale[i], 1e-9));
      size += static_cast<double>(one.normal[i]) * one.normal[i];
    }
    for (float& n : one.normal) n = static_cast<float>(n / std::sqrt(size));
  }
  return result;
}

Triangles plane(const Plane& plane) {
  const Vector3& n = plane.normal;
  // `right` is the direction along the plane that is nearest to x.
  Vector3 up = std::abs(n.z) > 1 - 1e-9 ? Vector3{0, 1, 0} : cross(n, cross({0, 0, 1}, n));
  up = (1 / length(up)) * up;
  Triangles result;
  add_rectangle({}, plane.width / 2 * cross(up, n), plane.height / 2 * up, result);
  return result;
}

Vector3 position_of(const TriangleMesh& mesh, int vertex, const Vector3& scale) {
  const float* at = &mesh.vertices[3 * static_cast<std::size_t>(vertex)];
  return {scale.x * at[0], scale.y * at[1], scale.z * at[2]};
}

/// For each vertex the first one that is at the same place: STL files have one for each corner.
std::vector<int> same_places(const std::vector<float>& vertices) {
  std::vector<int> order(vertices.size() / 3), result(order.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](int vertex) { return vertices.begin() + 3 * std::ptrdiff_t{vertex}; };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto at = place(a), other = place(b);
    const auto [first, second] = std::mismatch(at, at + 3, other);
    return first == at + 3 ? a < b : *first < *second;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same =
        i > 0 && std::equal(place(order[i]), place(order[i]) + 3, place(order[i - 1]));
    result[order[i]] = is_same ? result[order[i - 1]] : order[i];
  }
  return result;
}

struct Face {
  Vector3 normal;  ///< of length 1, or 0 for a face without an area
  double area = 0;
};

Face face_of(const TriangleMesh& mesh, const Vector3& scale, std::size_t face) {
  const int* vertices = &mesh.faces[3 * face];
  const Vector3 a = position_of(mesh, vertices[0], scale);
  const Vector3 across =
      cross(position_of(mesh, vertices[1], scale) - a, position_of(mesh, vertices[2], scale) - a);
  const double size = length(across);
  return {size > 0 ? (1 / size) * across : Vector3{}, size / 2};
}

}  // namespace

Triangles triangles_of(const Geometry& geometry) {
  if (const auto* one = std::get_if<Box>(&geometry)) return box(one->size);
  if (const auto* one = std::get_if<Cylinder>(&geometry)) return cylinder(one->radius, one->length);
  if (const auto* one = std::get_if<Sphere>(&geometry)) return capsule(one->radius, 0);
  if (const auto* one = std::get_if<Capsule>(&geometry)) return capsule(one->radius, one->length);
  if (const auto* one = std::get_if<Ellipsoid>(&geometry)) return ellipsoid(one->radii);
  if (const auto* one = std::get_if<Plane>(&geometry)) return plane(*one);
  return {};
}

Triangles triangles_of(const TriangleMesh& mesh, const Vector3& scale, std::size_t first,
                       std::size_t count) {
  const double kCosine = std::sqrt(0.5);
  std::vector<Face> faces(count);
  const std::vector<int> places = same_places(mesh.vertices);
  // The faces at each vertex: those of vertex i are from begins[i] to begins[i + 1].
  std::vector<std::size_t> begins(mesh.vertices.size() / 3 + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    faces[i] = face_of(mesh, scale, first + i);
    for (int k = 0; k < 3; ++k) ++begins[places[mesh.faces[3 * (first + i) + k]] + 1];
  }
  for (std::size_t i = 1; i < begins.size(); ++i) begins[i] += begins[i - 1];
  std::vector<std::size_t> at_vertex(3 * count), next(begins.begin(), begins.end() - 1);
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) at_vertex[next[places[mesh.faces[3 * (first + i) + k]]]++] = i;

  // More neighbours than these do not change what is seen, and bound the work of a fan.
  constexpr std::size_t kMostNeighbours = 64;
  Triangles result;
  result.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    if (faces[i].area == 0) continue;
    for (int k = 0; k < 3; ++k) {
      const std::size_t place = 3 * (first + i) + k;
      const int vertex = places[mesh.faces[place]];
      Vector3 normal = faces[i].area * faces[i].normal;
      const std::size_t end = std::min(begins[vertex + 1], begins[vertex] + kMostNeighbours);
      for (std::size_t j = begins[vertex]; j < end; ++j) {
        const Face& other = faces[at_vertex[j]];
        if (at_vertex[j] != i && dot(other.normal, faces[i].normal) > kCosine)
          normal = normal + other.area * other.normal;
      }
      const bool has_uv = !mesh.uvs.empty();
      result.push_back(corner(position_of(mesh, vertex, scale), (1 / length(normal)) * normal,
                              has_uv ? mesh.uvs[2 * place] : 0,
                              has_uv ? mesh.uvs[2 * place + 1] : 0));
    }
  }
  return result;
}

}  // namespace ros2wasm_sim
