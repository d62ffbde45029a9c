// How often rays passed through the cells of a map, and how often they ended there.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scan.hpp"

namespace slam_toolbox {

struct OccupancyCells {
  Point origin;  ///< the corner of the first cell
  int columns = 0;
  int rows = 0;
  std::vector<int8_t> values;  ///< row by row: 0 free, 100 occupied, -1 unknown
};

class Coverage {
 public:
  explicit Coverage(double resolution) : resolution_(resolution) {}

  void clear();
  /// False when the map would have more cells than it may have, and the scan is not drawn.
  bool add(const Scan& scan);
  OccupancyCells cells() const;

 private:
  struct Cell {
    int column;
    int row;
  };
  struct Counts {
    uint32_t passed = 0;
    uint32_t hit = 0;
  };

  Cell cell_of(const Point& point) const;
  bool cover(const std::vector<Point>& ends, const Point& sensor);
  void trace(Cell from, Cell to, bool is_hit);
  Counts& at(const Cell& cell) {
    return counts_[static_cast<size_t>(cell.row - first_.row) * static_cast<size_t>(columns_) +
                   static_cast<size_t>(cell.column - first_.column)];
  }

  double resolution_;
  Cell first_{0, 0};  ///< counted from the origin of the map
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Counts> counts_;
};

}  // namespace slam_toolbox
