// Visits the cells of a costmap by their distance from the nearest of the cells that are put in.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "costmap_queue/map_based_queue.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"

namespace costmap_queue {

class CellData {
 public:
  CellData(const double d, const unsigned int i, const unsigned int x, const unsigned int y,
           const unsigned int sx, const unsigned int sy)
      : distance_(d), index_(i), x_(x), y_(y), src_x_(sx), src_y_(sy) {}
  CellData() = default;

  static unsigned absolute_difference(const unsigned x, const unsigned y) {
    return x > y ? x - y : y - x;
  }

  double distance_ = std::numeric_limits<double>::max();  // in cells
  unsigned int index_ = 0;
  unsigned int x_ = 0;
  unsigned int y_ = 0;
  unsigned int src_x_ = 0;  // the cell that it was reached from at first
  unsigned int src_y_ = 0;
};

class CostmapQueue : public MapBasedQueue<CellData> {
 public:
  explicit CostmapQueue(nav2_costmap_2d::Costmap2D& costmap, bool manhattan = false);

  /// Before each use: the size of the costmap may be another.
  void reset() override;
  void enqueueCell(unsigned int x, unsigned int y);
  /// Its neighbours follow later.
  CellData getNextCell();
  virtual bool validCellToQueue(const CellData& /*cell*/) { return true; }
  typedef std::shared_ptr<CostmapQueue> Ptr;

 protected:
  void enqueueCell(unsigned int index, unsigned int cur_x, unsigned int cur_y, unsigned int src_x,
                   unsigned int src_y);
  void computeCache();
  inline double distanceLookup(const unsigned int cur_x, const unsigned int cur_y,
                               const unsigned int src_x, const unsigned int src_y) {
    const unsigned int dx = CellData::absolute_difference(cur_x, src_x);
    const unsigned int dy = CellData::absolute_difference(cur_y, src_y);
    return cached_distances_[dx][dy];
  }

  nav2_costmap_2d::Costmap2D& costmap_;
  std::vector<bool> seen_;
  /// In cells; -1: as large as the costmap.
  int max_distance_ = -1;
  bool manhattan_;
  std::vector<std::vector<double>> cached_distances_;
  int cached_max_distance_ = -1;
};

}  // namespace costmap_queue
