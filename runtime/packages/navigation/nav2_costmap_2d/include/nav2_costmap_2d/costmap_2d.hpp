// A grid of costs over a rectangle of the world: cell (0, 0) has the least x and y, rows follow
// each other in memory. Lengths are in metres.
#pragma once

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <queue>
#include <string>
#include <vector>

#include "geometry_msgs/msg/point.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"

namespace nav2_costmap_2d {

struct MapLocation {
  unsigned int x;
  unsigned int y;
};

class Costmap2D {
  friend class CostmapTester;

 public:
  typedef std::recursive_mutex mutex_t;

  Costmap2D(unsigned int cells_size_x, unsigned int cells_size_y, double resolution,
            double origin_x, double origin_y, unsigned char default_value = 0);
  Costmap2D(const Costmap2D& map);
  /// Unknown cells are NO_INFORMATION, the others proportional from FREE_SPACE to LETHAL_OBSTACLE.
  explicit Costmap2D(const nav_msgs::msg::OccupancyGrid& map);
  Costmap2D& operator=(const Costmap2D& map);
  /// Without cells.
  Costmap2D();
  virtual ~Costmap2D();

  /// Becomes a copy of a part of another map; false when that part leaves it.
  bool copyCostmapWindow(const Costmap2D& map, double win_origin_x, double win_origin_y,
                         double win_size_x, double win_size_y);
  /// Copies the cells from (sx0, sy0) to before (sxn, syn) to (dx0, dy0); false when they do not
  /// fit.
  bool copyWindow(const Costmap2D& source, unsigned int sx0, unsigned int sy0, unsigned int sxn,
                  unsigned int syn, unsigned int dx0, unsigned int dy0);

  unsigned char getCost(unsigned int mx, unsigned int my) const;
  unsigned char getCost(unsigned int index) const;
  void setCost(unsigned int mx, unsigned int my, unsigned char cost);

  /// The centre of a cell.
  void mapToWorld(unsigned int mx, unsigned int my, double& wx, double& wy) const;
  /// False outside of the map, with nothing written.
  bool worldToMap(double wx, double wy, unsigned int& mx, unsigned int& my) const;
  /// With fractions: the centre of cell 0 is 0.5.
  bool worldToMapContinuous(double wx, double wy, float& mx, float& my) const;
  void worldToMapNoBounds(double wx, double wy, int& mx, int& my) const;
  /// The nearest cell of the map.
  void worldToMapEnforceBounds(double wx, double wy, int& mx, int& my) const;

  inline unsigned int getIndex(unsigned int mx, unsigned int my) const { return my * size_x_ + mx; }
  inline void indexToCells(unsigned int index, unsigned int& mx, unsigned int& my) const {
    my = index / size_x_;
    mx = index % size_x_;
  }

  unsigned char* getCharMap() const;
  unsigned int getSizeInCellsX() const;
  unsigned int getSizeInCellsY() const;
  /// From the centre of the first cell to the far side of the last one.
  double getSizeInMetersX() const;
  double getSizeInMetersY() const;
  double getOriginX() const;
  double getOriginY() const;
  double getResolution() const;
  void setDefaultValue(unsigned char c) { default_value_ = c; }
  unsigned char getDefaultValue() { return default_value_; }

  /// False when a corner is outside of the map.
  bool setConvexPolygonCost(const std::vector<geometry_msgs::msg::Point>& polygon,
                            unsigned char cost_value);
  /// As above, for callers that restore the cells later.
  bool getMapRegionOccupiedByPolygon(const std::vector<geometry_msgs::msg::Point>& polygon,
                                     std::vector<MapLocation>& polygon_map_region);
  void polygonOutlineCells(const std::vector<MapLocation>& polygon,
                           std::vector<MapLocation>& polygon_cells);
  void convexFillCells(const std::vector<MapLocation>& polygon,
                       std::vector<MapLocation>& polygon_cells);

  /// Moves the map by whole cells; cells that stay in it have their costs, new ones the default.
  virtual void updateOrigin(double new_origin_x, double new_origin_y);
  /// Writes a PGM file; false when that is not possible.
  bool saveMap(std::string file_name);
  void resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x,
                 double origin_y);
  void resetMap(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn);
  void resetMapToValue(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn,
                       unsigned char value);
  /// Cells for a length, rounded up.
  unsigned int cellDistance(double world_dist);
  mutex_t* getMutex() { return access_; }

 protected:
  template <typename data_type>
  void copyMapRegion(data_type* source_map, unsigned int sm_lower_left_x,
                     unsigned int sm_lower_left_y, unsigned int sm_size_x, data_type* dest_map,
                     unsigned int dm_lower_left_x, unsigned int dm_lower_left_y,
                     unsigned int dm_size_x, unsigned int region_size_x,
                     unsigned int region_size_y) {
    const data_type* from = source_map + sm_lower_left_y * sm_size_x + sm_lower_left_x;
    data_type* to = dest_map + dm_lower_left_y * dm_size_x + dm_lower_left_x;
    for (unsigned int row = 0; row < region_size_y; ++row) {
      std::copy_n(from + row * sm_size_x, region_size_x, to + row * dm_size_x);
    }
  }
  virtual void deleteMaps();
  virtual void resetMaps();
  virtual void initMaps(unsigned int size_x, unsigned int size_y);

  /// Calls `at` with the index of each cell of a line, both ends included, after Bresenham. Lengths
  /// are in cells: `min_length` cells at its start are passed over, and it ends after `max_length`.
  template <class ActionType>
  inline void raytraceLine(ActionType at, unsigned int x0, unsigned int y0, unsigned int x1,
                           unsigned int y1, unsigned int max_length = UINT_MAX,
                           unsigned int min_length = 0) {
    const double full_x = static_cast<double>(x1) - x0;
    const double full_y = static_cast<double>(y1) - y0;
    const double length = std::hypot(full_x, full_y);
    if (length < min_length) return;
    if (length > 0.0) {
      x0 = static_cast<unsigned int>(x0 + full_x / length * min_length);
      y0 = static_cast<unsigned int>(y0 + full_y / length * min_length);
    }
    const int dx = static_cast<int>(x1 - x0);
    const int dy = static_cast<int>(y1 - y0);
    const double share = length == 0.0 ? 1.0 : std::min(1.0, max_length / length);
    const int column = dx > 0 ? 1 : -1;
    const int row = dy > 0 ? static_cast<int>(size_x_) : -static_cast<int>(size_x_);
    const bool is_flat = std::abs(dx) >= std::abs(dy);
    const unsigned int along = static_cast<unsigned int>(is_flat ? std::abs(dx) : std::abs(dy));
    const unsigned int across = static_cast<unsigned int>(is_flat ? std::abs(dy) : std::abs(dx));
    walkLine(at, getIndex(x0, y0), is_flat ? column : row, is_flat ? row : column, along, across,
             static_cast<unsigned int>(share * along));
  }

 private:
  template <class ActionType>
  inline void walkLine(ActionType& at, unsigned int index, int step, int side_step,
                       unsigned int along, unsigned int across, unsigned int steps) {
    unsigned int error = along / 2;
    for (unsigned int i = 0; i < std::min(steps, along); ++i) {
      at(index);
      index += static_cast<unsigned int>(step);
      error += across;
      if (error < along) continue;
      error -= along;
      index += static_cast<unsigned int>(side_step);
    }
    at(index);
  }
  bool cellsOf(const std::vector<geometry_msgs::msg::Point>& polygon,
               std::vector<MapLocation>& cells) const;

  mutex_t* access_;

 protected:
  unsigned int size_x_;
  unsigned int size_y_;
  double resolution_;
  double origin_x_;
  double origin_y_;
  unsigned char* costmap_;
  unsigned char default_value_;

  /// Gives each cell of a line a value.
  class MarkCell {
   public:
    MarkCell(unsigned char* costmap, unsigned char value) : costmap_(costmap), value_(value) {}
    inline void operator()(unsigned int offset) { costmap_[offset] = value_; }

   private:
    unsigned char* costmap_;
    unsigned char value_;
  };

  /// Lists the cells of a line.
  class PolygonOutlineCells {
   public:
    PolygonOutlineCells(const Costmap2D& costmap, const unsigned char*,
                        std::vector<MapLocation>& cells)
        : costmap_(costmap), cells_(cells) {}
    inline void operator()(unsigned int offset) {
      MapLocation location;
      costmap_.indexToCells(offset, location.x, location.y);
      cells_.push_back(location);
    }

   private:
    const Costmap2D& costmap_;
    std::vector<MapLocation>& cells_;
  };
};

}  // namespace nav2_costmap_2d
