// The map that a filter localizes in: free, unknown and occupied cells, distances to occupied ones,
// and ranges that a laser would see. Without ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace nav2_amcl {

enum class CellState : std::int8_t { Free = -1, Unknown = 0, Occupied = 1 };

struct MapGeometry {
  int width = 0;            // cells
  int height = 0;           // cells
  double resolution = 1.0;  // m/cell
  double origin_x = 0.0;    // m; where the cell 0, 0 is
  double origin_y = 0.0;    // m
};

class OccupancyMap {
 public:
  struct Point {
    double x;  // m
    double y;  // m
  };

  /// `cells` has width times height of them, row by row from the origin on.
  OccupancyMap(const MapGeometry& geometry, std::vector<CellState> cells);

  const MapGeometry& geometry() const { return geometry_; }
  /// The index of the cell at a point; nothing outside the map and for NaN. As in upstream, the
  /// point of a cell is its lower left corner, and a point belongs to the cell of the nearest one.
  std::optional<size_t> cell_at(double x, double y) const;
  Point point_of(size_t cell) const;
  CellState state(size_t cell) const { return cells_[cell]; }
  /// All free cells, or those of every `step`-th row and column.
  std::vector<std::uint32_t> free_cells(int step) const;

  /// Measures how far each cell is from the nearest occupied one. Longer distances than `most` [m]
  /// become `most`.
  void measure_distances(double most);
  double max_distance() const { return max_distance_; }
  /// In m, after measure_distances().
  float distance(size_t cell) const { return distances_[cell]; }

  /// How far a ray gets before it meets a cell that is not free, or the end of the map; `most` [m]
  /// when it meets none.
  double range(double x, double y, double angle, double most) const;

 private:
  struct Cell {
    int x;
    int y;
  };

  std::optional<Cell> place_of(double x, double y) const;
  bool blocks(int x, int y) const;
  size_t index_of(int x, int y) const;
  void measure_columns();

  MapGeometry geometry_;
  std::vector<CellState> cells_;
  std::vector<float> distances_;
  double max_distance_ = 0.0;
};

}  // namespace nav2_amcl
