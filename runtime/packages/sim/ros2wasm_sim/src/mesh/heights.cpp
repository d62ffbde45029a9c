// See heights.hpp.
#include "mesh/heights.hpp"

#include <algorithm>

#include "render/picture.hpp"

namespace ros2wasm_sim {
namespace {

/// Cells along a side that are drawn.
constexpr int kMostCells = 128;

/// Every so many columns, and the last one.
std::vector<int> every(int step, int count) {
  std::vector<int> result;
  for (int i = 0; i < count - 1; i += step) result.push_back(i);
  result.push_back(count - 1);
  return result;
}

}  // namespace

std::optional<TriangleMesh> read_heights(const std::string& bytes) {
  const auto picture = read_picture(bytes);
  if (!picture) return std::nullopt;
  const int columns = picture->width, rows = picture->height;
  if (std::min(columns, rows) < 2 || std::max(columns, rows) > kMostHeights) return std::nullopt;
  const auto grey = [&](int i) { return picture->rgb[3 * static_cast<std::size_t>(i)]; };
  int most = 1;
  for (int i = 0; i < columns * rows; ++i) most = std::max<int>(most, grey(i));
  TriangleMesh mesh;
  mesh.columns = columns;
  mesh.rows = rows;
  mesh.vertices.reserve(3 * static_cast<std::size_t>(columns) * rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      mesh.vertices.push_back(static_cast<float>(column) / static_cast<float>(columns - 1) - 0.5F);
      mesh.vertices.push_back(0.5F - static_cast<float>(row) / static_cast<float>(rows - 1));
      mesh.vertices.push_back(static_cast<float>(grey(row * columns + column)) /
                              static_cast<float>(most));
    }
  const int step = (std::max(columns, rows) + kMostCells - 2) / kMostCells;
  const std::vector<int> xs = every(step, columns), ys = every(step, rows);
  for (std::size_t y = 1; y < ys.size(); ++y)
    for (std::size_t x = 1; x < xs.size(); ++x) {
      const int north = ys[y - 1] * columns, south = ys[y] * columns;
      const int west = xs[x - 1], east = xs[x];
      for (const int corner :
           {north + west, south + west, south + east, north + west, south + east, north + east})
        mesh.faces.push_back(corner);
    }
  return mesh;
}

Mesh mesh_of(const Heightmap& map) {
  return {.uri = map.uri, .path = map.path, .scale = map.size, .submesh = {}};
}

}  // namespace ros2wasm_sim
