// See costmap_queue.hpp.
#include "costmap_queue/costmap_queue.hpp"

#include <algorithm>
#include <cmath>

namespace costmap_queue {

CostmapQueue::CostmapQueue(nav2_costmap_2d::Costmap2D& costmap, bool manhattan)
    : costmap_(costmap), manhattan_(manhattan) {
  CostmapQueue::reset();
}

void CostmapQueue::reset() {
  const size_t cells = size_t{costmap_.getSizeInCellsX()} * costmap_.getSizeInCellsY();
  seen_.assign(cells, false);
  computeCache();
  MapBasedQueue::reset();
}

void CostmapQueue::enqueueCell(unsigned int x, unsigned int y) {
  enqueueCell(costmap_.getIndex(x, y), x, y, x, y);
}

void CostmapQueue::enqueueCell(unsigned int index, unsigned int cur_x, unsigned int cur_y,
                               unsigned int src_x, unsigned int src_y) {
  if (seen_[index]) return;
  const double distance = distanceLookup(cur_x, cur_y, src_x, src_y);
  const CellData cell(distance, index, cur_x, cur_y, src_x, src_y);
  if (!validCellToQueue(cell)) return;
  seen_[index] = true;
  enqueue(distance, cell);
}

CellData CostmapQueue::getNextCell() {
  const CellData cell = front();
  pop();
  const unsigned int size_x = costmap_.getSizeInCellsX();
  const auto visit = [&](unsigned int index, unsigned int x, unsigned int y) {
    enqueueCell(index, x, y, cell.src_x_, cell.src_y_);
  };
  if (cell.x_ > 0) visit(cell.index_ - 1, cell.x_ - 1, cell.y_);
  if (cell.y_ > 0) visit(cell.index_ - size_x, cell.x_, cell.y_ - 1);
  if (cell.x_ + 1 < size_x) visit(cell.index_ + 1, cell.x_ + 1, cell.y_);
  if (cell.y_ + 1 < costmap_.getSizeInCellsY()) visit(cell.index_ + size_x, cell.x_, cell.y_ + 1);
  return cell;
}

void CostmapQueue::computeCache() {
  // A cell beyond the greatest distance is looked up before it is refused.
  const int largest =
      static_cast<int>(std::max(costmap_.getSizeInCellsX(), costmap_.getSizeInCellsY()));
  const int distance = max_distance_ == -1 ? largest : std::min(max_distance_, largest);
  if (distance == cached_max_distance_) return;
  const size_t size = static_cast<size_t>(distance) + 2;
  cached_distances_.assign(size, std::vector<double>(size));
  for (size_t x = 0; x < size; ++x) {
    for (size_t y = 0; y < size; ++y) {
      const double dx = static_cast<double>(x);
      const double dy = static_cast<double>(y);
      cached_distances_[x][y] = manhattan_ ? dx + dy : std::hypot(dx, dy);
    }
  }
  cached_max_distance_ = distance;
}

}  // namespace costmap_queue
