// See coverage.hpp.
#include "core/coverage.hpp"

#include <algorithm>
#include <cstdlib>

namespace slam_toolbox {
namespace {

/// 20 million cells are 220 m by 220 m at 5 cm.
constexpr double kMostCells = 20e6;
/// So that a ray does not take seconds.
constexpr int kLongestSide = 20'000;
/// A cell is known once more rays than this passed it.
constexpr uint32_t kLeastPasses = 2;
/// The share of rays that end in an occupied cell.
constexpr double kOccupied = 0.1;

}  // namespace

void Coverage::clear() {
  columns_ = rows_ = 0;
  counts_.clear();
}

Coverage::Cell Coverage::cell_of(const Point& point) const {
  return {static_cast<int>(std::floor(point.x / resolution_)),
          static_cast<int>(std::floor(point.y / resolution_))};
}

bool Coverage::add(const Scan& scan) {
  const Point sensor = scan.corrected * scan.sensor;
  std::vector<Point> ends;
  ends.reserve(scan.hits.size());
  for (const Point& hit : scan.hits) {
    // A longer ray is cut: up to there, it met nothing.
    const double part =
        std::min(1.0, scan.max_range / std::sqrt(squared_distance(scan.sensor, hit)));
    ends.push_back(scan.corrected * Point{scan.sensor.x + part * (hit.x - scan.sensor.x),
                                          scan.sensor.y + part * (hit.y - scan.sensor.y)});
  }
  if (!cover(ends, sensor)) return false;
  const Cell from = cell_of(sensor);
  for (size_t i = 0; i < ends.size(); ++i) {
    trace(from, cell_of(ends[i]), is_within_range(scan, scan.hits[i]));
  }
  return true;
}

bool Coverage::cover(const std::vector<Point>& ends, const Point& sensor) {
  Point least = sensor;
  Point most = sensor;
  for (const Point& end : ends) {
    if (!std::isfinite(end.x + end.y)) return false;
    least = {std::min(least.x, end.x), std::min(least.y, end.y)};
    most = {std::max(most.x, end.x), std::max(most.y, end.y)};
  }
  // Before anything becomes an integer: a place may be very far away.
  const double wide = (most.x - least.x) / resolution_;
  const double high = (most.y - least.y) / resolution_;
  const double far =
      std::max({std::abs(least.x), std::abs(least.y), std::abs(most.x), std::abs(most.y)}) /
      resolution_;
  if (!(wide * high <= kMostCells) || !(far < 1e8)) return false;
  Cell low = cell_of(least);
  Cell top = cell_of(most);
  if (columns_ > 0) {
    low = {std::min(low.column, first_.column), std::min(low.row, first_.row)};
    top = {std::max(top.column, first_.column + columns_ - 1),
           std::max(top.row, first_.row + rows_ - 1)};
  }
  const int columns = top.column - low.column + 1;
  const int rows = top.row - low.row + 1;
  if (std::max(columns, rows) > kLongestSide || static_cast<double>(columns) * rows > kMostCells) {
    return false;
  }
  if (columns == columns_ && rows == rows_) return true;
  std::vector<Counts> counts(static_cast<size_t>(columns) * static_cast<size_t>(rows));
  for (int row = 0; row < rows_; ++row) {
    const auto from = counts_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
    const auto to = counts.begin() +
                    static_cast<std::ptrdiff_t>(row + first_.row - low.row) * columns +
                    (first_.column - low.column);
    std::copy(from, from + columns_, to);
  }
  counts_ = std::move(counts);
  first_ = low;
  columns_ = columns;
  rows_ = rows;
  return true;
}

void Coverage::trace(Cell from, Cell to, bool is_hit) {
  const int dx = std::abs(to.column - from.column);
  const int dy = -std::abs(to.row - from.row);
  const int step_x = from.column < to.column ? 1 : -1;
  const int step_y = from.row < to.row ? 1 : -1;
  int error = dx + dy;
  for (;;) {
    ++at(from).passed;
    if (from.column == to.column && from.row == to.row) break;
    const int twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      from.column += step_x;
    }
    if (twice <= dx) {
      error += dx;
      from.row += step_y;
    }
  }
  if (is_hit) ++at(to).hit;
}

OccupancyCells Coverage::cells() const {
  OccupancyCells result;
  result.columns = columns_;
  result.rows = rows_;
  result.origin = {first_.column * resolution_, first_.row * resolution_};
  result.values.reserve(counts_.size());
  for (const Counts& count : counts_) {
    const bool is_known = count.passed > kLeastPasses;
    const bool is_occupied = count.hit > kOccupied * count.passed;
    result.values.push_back(static_cast<int8_t>(is_known ? (is_occupied ? 100 : 0) : -1));
  }
  return result;
}

}  // namespace slam_toolbox
