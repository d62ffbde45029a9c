// See correlation_grid.hpp.
#include "core/correlation_grid.hpp"

#include <algorithm>

namespace slam_toolbox {
namespace {

/// 64 MB, which is 80 m by 80 m at 1 cm.
constexpr double kMostCells = 64e6;

}  // namespace

CorrelationGrid::CorrelationGrid(double resolution, double deviation)
    : resolution_(resolution), reach_(static_cast<int>(std::lround(2.0 * deviation / resolution))) {
  const int width = 2 * reach_ + 1;
  smear_.resize(static_cast<size_t>(width) * static_cast<size_t>(width));
  size_t i = 0;
  for (int row = -reach_; row <= reach_; ++row) {
    for (int column = -reach_; column <= reach_; ++column) {
      const double distance = std::hypot(row, column) * resolution / deviation;
      smear_[i++] =
          static_cast<uint8_t>(std::lround(kOccupied * std::exp(-0.5 * distance * distance)));
    }
  }
}

bool CorrelationGrid::cover(const Point& least, const Point& most) {
  const double columns = std::ceil((most.x - least.x) / resolution_) + 2.0 * reach_ + 1.0;
  const double rows = std::ceil((most.y - least.y) / resolution_) + 2.0 * reach_ + 1.0;
  if (!(columns * rows <= kMostCells)) return false;
  columns_ = static_cast<int>(columns);
  rows_ = static_cast<int>(rows);
  // Cells begin at multiples of the resolution, whatever the area is.
  origin_.x = (std::floor(least.x / resolution_) - reach_) * resolution_;
  origin_.y = (std::floor(least.y / resolution_) - reach_) * resolution_;
  cells_.assign(static_cast<size_t>(columns_) * static_cast<size_t>(rows_), 0);
  return true;
}

double CorrelationGrid::greatest_reach() const {
  return 0.5 * resolution_ * (std::sqrt(kMostCells) - 2.0 * reach_ - 3.0);
}

int CorrelationGrid::column_of(double x) const {
  return static_cast<int>(std::lround((x - origin_.x) / resolution_));
}

int CorrelationGrid::row_of(double y) const {
  return static_cast<int>(std::lround((y - origin_.y) / resolution_));
}

void CorrelationGrid::add(const Point& point) {
  const int column = column_of(point.x);
  const int row = row_of(point.y);
  // The point was drawn before.
  if (at(column, row) == kOccupied) return;
  const int first = std::max(column - reach_, 0);
  const int last = std::min(column + reach_, columns_ - 1);
  const int width = 2 * reach_ + 1;
  for (int y = std::max(row - reach_, 0); y <= std::min(row + reach_, rows_ - 1); ++y) {
    const uint8_t* const from = smear_.data() + (y - row + reach_) * width - column + reach_;
    uint8_t* const to = cells_.data() + static_cast<size_t>(y) * static_cast<size_t>(columns_);
    for (int x = first; x <= last; ++x) to[x] = std::max(to[x], from[x]);
  }
}

}  // namespace slam_toolbox
