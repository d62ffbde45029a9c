// See occupancy_map.hpp.
#include "nav2_amcl/map/occupancy_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace nav2_amcl {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Squared distances along one row, from the distances along the columns: the lower envelope of
/// parabolas (Felzenszwalb and Huttenlocher), in time that grows with the length of the row.
class RowDistances {
 public:
  explicit RowDistances(size_t length) : tops_(length), begins_(length + 1) {}

  /// `row` has distances to the nearest occupied cell of each column, then of all cells; in cells.
  void measure(float* row, size_t length) {
    size_t count = 0;
    column_.assign(row, row + length);
    for (size_t x = 0; x < length; ++x) {
      if (column_[x] == kFar) continue;
      double begin = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        begin = crossing(tops_[count - 1], x);
        if (begin > begins_[count - 1]) break;
        --count;
        begin = -std::numeric_limits<double>::infinity();
      }
      tops_[count] = x;
      begins_[count++] = begin;
    }
    if (count == 0) return;
    size_t top = 0;
    for (size_t x = 0; x < length; ++x) {
      while (top + 1 < count && begins_[top + 1] <= static_cast<double>(x)) ++top;
      row[x] = static_cast<float>(std::sqrt(height_at(tops_[top], x)));
    }
  }

 private:
  double height_at(size_t top, size_t x) const {
    const double across = static_cast<double>(x) - static_cast<double>(top);
    const double along = column_[top];
    return across * across + along * along;
  }

  /// Where the parabola of `b` becomes the lower one; a is before b.
  double crossing(size_t a, size_t b) const {
    return (height_at(b, 0) - height_at(a, 0)) /
           (2 * (static_cast<double>(b) - static_cast<double>(a)));
  }

  std::vector<float> column_;
  std::vector<size_t> tops_;
  std::vector<double> begins_;
};

}  // namespace

OccupancyMap::OccupancyMap(const MapGeometry& geometry, std::vector<CellState> cells)
    : geometry_(geometry), cells_(std::move(cells)) {}

size_t OccupancyMap::index_of(int x, int y) const {
  return static_cast<size_t>(y) * static_cast<size_t>(geometry_.width) + static_cast<size_t>(x);
}

std::optional<OccupancyMap::Cell> OccupancyMap::place_of(double x, double y) const {
  const double column = std::floor((x - geometry_.origin_x) / geometry_.resolution + 0.5);
  const double row = std::floor((y - geometry_.origin_y) / geometry_.resolution + 0.5);
  const bool is_inside =
      column >= 0 && column < geometry_.width && row >= 0 && row < geometry_.height;
  if (!is_inside) return std::nullopt;
  return Cell{static_cast<int>(column), static_cast<int>(row)};
}

std::optional<size_t> OccupancyMap::cell_at(double x, double y) const {
  const std::optional<Cell> place = place_of(x, y);
  if (!place) return std::nullopt;
  return index_of(place->x, place->y);
}

OccupancyMap::Point OccupancyMap::point_of(size_t cell) const {
  const auto width = static_cast<size_t>(geometry_.width);
  return {geometry_.origin_x + static_cast<double>(cell % width) * geometry_.resolution,
          geometry_.origin_y + static_cast<double>(cell / width) * geometry_.resolution};
}

std::vector<std::uint32_t> OccupancyMap::free_cells(int step) const {
  std::vector<std::uint32_t> found;
  for (int y = 0; y < geometry_.height; y += step) {
    for (int x = 0; x < geometry_.width; x += step) {
      const size_t index = index_of(x, y);
      if (cells_[index] == CellState::Free) found.push_back(static_cast<std::uint32_t>(index));
    }
  }
  return found;
}

void OccupancyMap::measure_distances(double most) {
  if (!distances_.empty() && most == max_distance_) return;
  max_distance_ = most;
  measure_columns();
  const auto width = static_cast<size_t>(geometry_.width);
  RowDistances row(width);
  for (size_t begin = 0; begin < distances_.size(); begin += width) {
    row.measure(distances_.data() + begin, width);
  }
  const auto limit = static_cast<float>(most);
  const auto scale = static_cast<float>(geometry_.resolution);
  for (float& distance : distances_) distance = std::min(distance * scale, limit);
}

void OccupancyMap::measure_columns() {
  const auto width = static_cast<size_t>(geometry_.width);
  const size_t size = cells_.size();
  distances_.assign(size, kFar);
  for (size_t i = 0; i < size; ++i) {
    if (cells_[i] == CellState::Occupied) {
      distances_[i] = 0;
    } else if (i >= width) {
      distances_[i] = distances_[i - width] + 1;
    }
  }
  for (size_t i = size - std::min(size, width); i-- > 0;) {
    distances_[i] = std::min(distances_[i], distances_[i + width] + 1);
  }
}

bool OccupancyMap::blocks(int x, int y) const {
  if (x < 0 || y < 0 || x >= geometry_.width || y >= geometry_.height) return true;
  return cells_[index_of(x, y)] != CellState::Free;
}

double OccupancyMap::range(double x, double y, double angle, double most) const {
  const std::optional<Cell> start = place_of(x, y);
  if (!start || blocks(start->x, start->y)) return 0.0;
  // A longer ray leaves the map.
  const double length = std::min(most, (geometry_.width + geometry_.height) * geometry_.resolution);
  const double dx = length * std::cos(angle) / geometry_.resolution;
  const double dy = length * std::sin(angle) / geometry_.resolution;
  if (!std::isfinite(dx + dy)) return most;
  const bool is_steep = std::abs(dy) > std::abs(dx);
  // Steps of one cell along the longer axis.
  const double steps = std::max(std::abs(dx), std::abs(dy));
  const int count = static_cast<int>(steps + 0.5) + 1;
  const double slope = steps > 0 ? (is_steep ? dx : dy) / steps : 0.0;
  const int step = (is_steep ? dy : dx) < 0 ? -1 : 1;
  for (int i = 1; i <= count; ++i) {
    const int along = i * step;
    const int across = static_cast<int>(std::floor(i * slope + 0.5));
    const int cell_x = start->x + (is_steep ? across : along);
    const int cell_y = start->y + (is_steep ? along : across);
    if (blocks(cell_x, cell_y)) return std::hypot(along, across) * geometry_.resolution;
  }
  return most;
}

}  // namespace nav2_amcl
