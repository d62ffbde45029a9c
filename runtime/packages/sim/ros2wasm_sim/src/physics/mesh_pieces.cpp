// See mesh_pieces.hpp.
#include "physics/mesh_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace ros2wasm_sim {
namespace {

/// Corners nearer than this, as a part of the size of the mesh, are the same: files repeat them for
/// each face.
constexpr double kSame = 1e-6;
/// Faces whose normals are as near as this lie in one plane, and a part may bulge by this much of
/// its size.
constexpr double kFlat = 1e-4;

/// The thickness of a flat mesh, as a part of its size.
constexpr double kThickness = 1e-3;
/// Faces at one side that are compared with one of them: two are usual.
constexpr std::size_t kMostUsers = 8;
/// Pairs of a face and a corner, for one part.
constexpr std::size_t kMostCompared = 20'000'000;

using Face = std::array<int, 3>;

/// Sets of numbers that grow together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }
  int root(int one) {
    while (parents_[one] != one) one = parents_[one] = parents_[parents_[one]];
    return one;
  }
  void join(int a, int b) { parents_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

 private:
  std::vector<int> parents_;
};

/// The mesh with each corner once, and without faces that have no area.
class MeshSurface {
 public:
  MeshSurface(const TriangleMesh& mesh, const Vector3& scale) {
    read_points(mesh, scale);
    std::vector<int> number = merged(mesh.vertices.size() / 3);
    const bool is_mirrored = scale.x * scale.y * scale.z < 0;
    for (std::size_t i = 0; i + 2 < mesh.faces.size(); i += 3) {
      Face face{number[mesh.faces[i]], number[mesh.faces[i + 1]], number[mesh.faces[i + 2]]};
      if (is_mirrored) std::swap(face[1], face[2]);
      const Vector3 twice =
          cross(points[face[1]] - points[face[0]], points[face[2]] - points[face[0]]);
      if (length(twice) <= kSame * kSame * size * size) continue;
      faces.push_back(face);
      normals.push_back((1 / length(twice)) * twice);
      areas.push_back(length(twice) / 2);
    }
  }

  std::vector<Vector3> points = {};
  std::vector<Face> faces = {};
  std::vector<Vector3> normals = {};
  std::vector<double> areas = {};
  double size = 0;  ///< the greatest side of the box around it

 private:
  void read_points(const TriangleMesh& mesh, const Vector3& scale) {
    Vector3 low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
    for (std::size_t i = 0; i + 2 < mesh.vertices.size(); i += 3) {
      const Vector3 p{scale.x * mesh.vertices[i], scale.y * mesh.vertices[i + 1],
                      scale.z * mesh.vertices[i + 2]};
      points.push_back(p);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    if (!points.empty()) size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  }

  /// For each point the first one at its place.
  std::vector<int> merged(std::size_t count) const {
    std::map<std::tuple<long long, long long, long long>, int> first;
    std::vector<int> result(count);
    const double cell = std::max(kSame * size, 1e-12);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3& p = points[i];
      const std::tuple key{std::llround(p.x / cell), std::llround(p.y / cell),
                           std::llround(p.z / cell)};
      result[i] = first.emplace(key, static_cast<int>(i)).first->second;
    }
    return result;
  }
};

using FaceList = std::vector<int>;

/// Faces that hang together by their corners.
std::vector<FaceList> parts_of(const MeshSurface& surface) {
  Groups groups(surface.points.size());
  for (const Face& face : surface.faces) {
    groups.join(face[0], face[1]);
    groups.join(face[0], face[2]);
  }
  std::map<int, FaceList> parts;
  for (std::size_t i = 0; i < surface.faces.size(); ++i)
    parts[groups.root(surface.faces[i][0])].push_back(static_cast<int>(i));
  std::vector<FaceList> result;
  for (auto& [root, faces] : parts) result.push_back(std::move(faces));
  return result;
}

std::vector<int> corners_of(const MeshSurface& surface, const FaceList& faces) {
  std::vector<int> result;
  for (const int face : faces)
    result.insert(result.end(), surface.faces[face].begin(), surface.faces[face].end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Each side of its faces is one of two: a shell with an opening, such as walls around a room, is
/// no body.
bool is_closed(const MeshSurface& surface, const FaceList& faces) {
  std::map<std::pair<int, int>, int> uses;
  for (const int face : faces)
    for (int k = 0; k < 3; ++k) {
      const int a = surface.faces[face][k], b = surface.faces[face][(k + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  return std::all_of(uses.begin(), uses.end(), [](const auto& one) { return one.second == 2; });
}

/// A body with no corner before any face. Of very large parts not all faces are looked at.
bool is_convex(const MeshSurface& surface, const FaceList& faces, const std::vector<int>& corners) {
  const double slack = kFlat * surface.size;
  if (!is_closed(surface, faces)) return false;
  const std::size_t stride = 1 + faces.size() * corners.size() / kMostCompared;
  for (std::size_t i = 0; i < faces.size(); i += stride) {
    const int face = faces[i];
    const Vector3& origin = surface.points[surface.faces[face][0]];
    for (const int corner : corners) {
      const double height = dot(surface.points[corner] - origin, surface.normals[face]);
      if (height > slack) return false;
    }
  }
  return true;
}

/// Faces of a part that lie in one plane and share sides.
std::vector<FaceList> flat_areas(const MeshSurface& surface, const FaceList& part) {
  Groups groups(part.size());
  std::map<std::pair<int, int>, FaceList> sides;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Face& face = surface.faces[part[i]];
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      sides[{std::min(a, b), std::max(a, b)}].push_back(static_cast<int>(i));
    }
  }
  const auto is_flat = [&](int a, int b) {
    return dot(surface.normals[part[a]], surface.normals[part[b]]) > 1 - kFlat * kFlat;
  };
  for (const auto& [side, users] : sides)
    for (std::size_t a = 0; a < users.size(); ++a)
      for (std::size_t b = a + 1; b < std::min(users.size(), a + kMostUsers); ++b)
        if (is_flat(users[a], users[b])) groups.join(users[a], users[b]);
  std::map<int, FaceList> areas;
  for (std::size_t i = 0; i < part.size(); ++i)
    areas[groups.root(static_cast<int>(i))].push_back(part[i]);
  std::vector<FaceList> result;
  for (auto& [root, faces] : areas) result.push_back(std::move(faces));
  return result;
}

/// The convex hull of points in a plane, against the clock as seen from where the normal points.
struct Outline {
  std::vector<int> corners;
  double area = 0;
};

Outline outline_of(const MeshSurface& surface, const std::vector<int>& corners,
                   const Vector3& normal) {
  const Vector3 other = std::fabs(normal.x) < 0.9 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  Vector3 u = cross(normal, other);
  u = (1 / length(u)) * u;
  const Vector3 v = cross(normal, u);
  struct Point {
    double x, y;
    int corner;
  };
  std::vector<Point> flat;
  for (const int corner : corners)
    flat.push_back({dot(surface.points[corner], u), dot(surface.points[corner], v), corner});
  std::sort(flat.begin(), flat.end(), [](const Point& a, const Point& b) {
    return std::tie(a.x, a.y, a.corner) < std::tie(b.x, b.y, b.corner);
  });
  const auto turn = [](const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double straight = kFlat * kFlat * surface.size * surface.size;
  std::vector<Point> hull;
  for (int pass = 0; pass < 2; ++pass) {  // its lower half, then its upper one
    const std::size_t begin = hull.size();
    for (const Point& point : flat) {
      while (hull.size() >= begin + 2 &&
             turn(hull[hull.size() - 2], hull.back(), point) <= straight)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(flat.begin(), flat.end());
  }
  Outline result;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point& next = hull[(i + 1) % hull.size()];
    result.corners.push_back(hull[i].corner);
    result.area += (hull[i].x * next.y - hull[i].y * next.x) / 2;
  }
  return result;
}

/// The rotation whose axes these are, of length 1 and square to each other.
Quaternion axes(const Vector3& x, const Vector3& y, const Vector3& z) {
  const double w = 0.5 * std::sqrt(std::max(0.0, 1 + x.x + y.y + z.z));
  if (w > 0.1) return {w, (y.z - z.y) / (4 * w), (z.x - x.z) / (4 * w), (x.y - y.x) / (4 * w)};
  // Half a turn, nearly: by the greatest of the other three.
  const double a = 0.5 * std::sqrt(std::max(0.0, 1 + x.x - y.y - z.z));
  if (a > 0.4) return {(y.z - z.y) / (4 * a), a, (y.x + x.y) / (4 * a), (z.x + x.z) / (4 * a)};
  const double b = 0.5 * std::sqrt(std::max(0.0, 1 - x.x + y.y - z.z));
  if (b > 0.4) return {(z.x - x.z) / (4 * b), (y.x + x.y) / (4 * b), b, (z.y + y.z) / (4 * b)};
  const double c = 0.5 * std::sqrt(std::max(0.0, 1 - x.x - y.y + z.z));
  return {(x.y - y.x) / (4 * c), (z.x + x.z) / (4 * c), (z.y + y.z) / (4 * c), c};
}

/// The engine knows more of the contacts of boxes than of those of other hulls.
void make_box(const MeshSurface& surface, const std::vector<int>& corners, MeshPiece& piece) {
  if (corners.size() != 4) return;
  const Vector3& origin = surface.points[corners[0]];
  const Vector3 x = surface.points[corners[1]] - origin;
  const Vector3 y = surface.points[corners[3]] - origin;
  const Vector3 opposite = surface.points[corners[2]] - origin;
  const double width = length(x), depth = length(y);
  const double slack = kFlat * surface.size;
  if (std::fabs(dot(x, y)) > slack * std::min(width, depth) || length(opposite - x - y) > slack)
    return;
  const Vector3 along = (1 / width) * x;
  piece.box = Vector3{width, depth, kSlabThickness};
  piece.pose.position = origin + 0.5 * opposite - 0.5 * kSlabThickness * piece.normal;
  piece.pose.orientation = axes(along, cross(piece.normal, along), piece.normal);
}

MeshPiece slab(const MeshSurface& surface, const std::vector<int>& corners, const Vector3& normal) {
  MeshPiece piece;
  piece.normal = normal;
  make_box(surface, corners, piece);
  for (const int corner : corners) {
    piece.points.push_back(surface.points[corner]);
    piece.points.push_back(surface.points[corner] - kSlabThickness * normal);
  }
  return piece;
}

void add_slabs(const MeshSurface& surface, const FaceList& part, std::vector<MeshPiece>& pieces) {
  for (const FaceList& area : flat_areas(surface, part)) {
    const Vector3& normal = surface.normals[area.front()];
    const Outline outline = outline_of(surface, corners_of(surface, area), normal);
    double size = 0;
    for (const int face : area) size += surface.areas[face];
    if (area.size() > 1 && outline.corners.size() > 2 && outline.area < (1 + 1e-3) * size) {
      pieces.push_back(slab(surface, outline.corners, normal));
      continue;
    }
    for (const int face : area)
      pieces.push_back(slab(surface, corners_of(surface, {face}), surface.normals[face]));
  }
}

}  // namespace

TriangleMesh with_thickness(const TriangleMesh& mesh, const Vector3& scale) {
  TriangleMesh result = mesh;
  const MeshSurface surface(mesh, scale);
  if (surface.faces.empty()) return result;
  const Vector3& normal = surface.normals.front();
  const Vector3& origin = surface.points[surface.faces.front()[0]];
  for (const Vector3& point : surface.points)
    if (std::fabs(dot(point - origin, normal)) > kFlat * surface.size) return result;
  const Vector3 behind = -kThickness * surface.size * normal;
  const Vector3 offset{behind.x / scale.x, behind.y / scale.y, behind.z / scale.z};
  const int count = static_cast<int>(mesh.vertices.size() / 3);
  for (int i = 0; i < count; ++i) {
    result.vertices.push_back(static_cast<float>(mesh.vertices[3 * i] + offset.x));
    result.vertices.push_back(static_cast<float>(mesh.vertices[3 * i + 1] + offset.y));
    result.vertices.push_back(static_cast<float>(mesh.vertices[3 * i + 2] + offset.z));
  }
  for (std::size_t i = 0; i + 2 < mesh.faces.size(); i += 3)
    for (const std::size_t corner : {i, i + 2, i + 1})
      result.faces.push_back(mesh.faces[corner] + count);
  return result;
}

std::vector<MeshPiece> mesh_pieces(const TriangleMesh& mesh, const Vector3& scale) {
  const MeshSurface surface(mesh, scale);
  const std::vector<FaceList> parts = parts_of(surface);
  std::vector<MeshPiece> pieces;
  for (const FaceList& part : parts) {
    const std::vector<int> corners = corners_of(surface, part);
    if (!is_convex(surface, part, corners)) {
      add_slabs(surface, part, pieces);
    } else {
      MeshPiece piece;
      if (parts.size() > 1)
        for (const int corner : corners) piece.points.push_back(surface.points[corner]);
      pieces.push_back(std::move(piece));
    }
    if (pieces.size() > kMostPieces) return {};
  }
  return pieces;
}

}  // namespace ros2wasm_sim
