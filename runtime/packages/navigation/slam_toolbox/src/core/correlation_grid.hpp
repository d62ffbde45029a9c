// A raster of where obstacles were seen, with soft edges: how well a scan fits is the mean of the
// cells under its points.
#pragma once

#include <cstdint>
#include <vector>

#include "core/planar.hpp"

namespace slam_toolbox {

class CorrelationGrid {
 public:
  static constexpr int kOccupied = 100;

  /// `deviation`: that of the Gaussian that a point is smeared with, in m.
  CorrelationGrid(double resolution, double deviation);

  /// Clears the raster and lets it cover this area. False when it would be too large.
  bool cover(const Point& least, const Point& most);
  /// Half the side of the largest square that can be covered, in m.
  double greatest_reach() const;
  void add(const Point& point);

  double resolution() const { return resolution_; }
  int column_of(double x) const;
  int row_of(double y) const;
  /// 0 to kOccupied; 0 outside.
  int at(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return 0;
    return cells_[static_cast<size_t>(row) * static_cast<size_t>(columns_) +
                  static_cast<size_t>(column)];
  }

 private:
  double resolution_;
  int reach_;                   ///< cells that a point is smeared over to each side
  std::vector<uint8_t> smear_;  ///< (2 * reach_ + 1) squared
  std::vector<uint8_t> cells_;  ///< row by row
  Point origin_;                ///< the centre of the first cell
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace slam_toolbox
