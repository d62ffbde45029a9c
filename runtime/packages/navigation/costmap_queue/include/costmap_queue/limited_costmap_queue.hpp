// A queue that stops at a distance.
#pragma once

#include "costmap_queue/costmap_queue.hpp"

namespace costmap_queue {

class LimitedCostmapQueue : public CostmapQueue {
 public:
  /// The limit in cells.
  LimitedCostmapQueue(nav2_costmap_2d::Costmap2D& costmap, const int cell_distance_limit);
  bool validCellToQueue(const CellData& cell) override;
};

}  // namespace costmap_queue
