// See limited_costmap_queue.hpp.
#include "costmap_queue/limited_costmap_queue.hpp"

#include <algorithm>

namespace costmap_queue {

LimitedCostmapQueue::LimitedCostmapQueue(nav2_costmap_2d::Costmap2D& costmap,
                                         const int cell_distance_limit)
    : CostmapQueue(costmap) {
  max_distance_ = std::max(cell_distance_limit, 0);
  CostmapQueue::reset();
}

bool LimitedCostmapQueue::validCellToQueue(const CellData& cell) {
  return cell.distance_ <= max_distance_;
}

}  // namespace costmap_queue
