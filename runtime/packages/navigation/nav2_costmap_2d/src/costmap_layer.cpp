// See costmap_layer.hpp.
#include "nav2_costmap_2d/costmap_layer.hpp"

#include <algorithm>

namespace nav2_costmap_2d {

void CostmapLayer::touch(double x, double y, double* min_x, double* min_y, double* max_x,
                         double* max_y) {
  *min_x = std::min(x, *min_x);
  *min_y = std::min(y, *min_y);
  *max_x = std::max(x, *max_x);
  *max_y = std::max(y, *max_y);
}

void CostmapLayer::matchSize() {
  const Costmap2D* master = layered_costmap_->getCostmap();
  resizeMap(master->getSizeInCellsX(), master->getSizeInCellsY(), master->getResolution(),
            master->getOriginX(), master->getOriginY());
}

void CostmapLayer::clearArea(int start_x, int start_y, int end_x, int end_y, bool invert) {
  current_ = false;
  const std::unique_lock<mutex_t> lock(*getMutex());
  for (int x = 0; x < static_cast<int>(getSizeInCellsX()); ++x) {
    const bool is_column = x > start_x && x < end_x;
    for (int y = 0; y < static_cast<int>(getSizeInCellsY()); ++y) {
      if ((is_column && y > start_y && y < end_y) == invert) continue;
      setCost(static_cast<unsigned int>(x), static_cast<unsigned int>(y), NO_INFORMATION);
    }
  }
}

void CostmapLayer::addExtraBounds(double mx0, double my0, double mx1, double my1) {
  extra_min_x_ = std::min(mx0, extra_min_x_);
  extra_max_x_ = std::max(mx1, extra_max_x_);
  extra_min_y_ = std::min(my0, extra_min_y_);
  extra_max_y_ = std::max(my1, extra_max_y_);
  has_extra_bounds_ = true;
}

void CostmapLayer::useExtraBounds(double* min_x, double* min_y, double* max_x, double* max_y) {
  if (!has_extra_bounds_) return;
  touch(extra_min_x_, extra_min_y_, min_x, min_y, max_x, max_y);
  touch(extra_max_x_, extra_max_y_, min_x, min_y, max_x, max_y);
  extra_min_x_ = extra_min_y_ = 1e6;
  extra_max_x_ = extra_max_y_ = -1e6;
  has_extra_bounds_ = false;
}

template <typename JoinT>
void CostmapLayer::updateEach(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j,
                              JoinT join) {
  if (!enabled_) return;
  unsigned char* below = master_grid.getCharMap();
  const unsigned int width = master_grid.getSizeInCellsX();
  for (int j = min_j; j < max_j; ++j) {
    unsigned int at = static_cast<unsigned int>(j) * width + static_cast<unsigned int>(min_i);
    for (int i = min_i; i < max_i; ++i, ++at) join(below[at], costmap_[at]);
  }
}

void CostmapLayer::updateWithTrueOverwrite(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                           int max_j) {
  updateEach(master_grid, min_i, min_j, max_i, max_j,
             [](unsigned char& below, unsigned char own) { below = own; });
}

void CostmapLayer::updateWithOverwrite(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                       int max_j) {
  updateEach(master_grid, min_i, min_j, max_i, max_j, [](unsigned char& below, unsigned char own) {
    if (own != NO_INFORMATION) below = own;
  });
}

void CostmapLayer::updateWithMax(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                 int max_j) {
  updateEach(master_grid, min_i, min_j, max_i, max_j, [](unsigned char& below, unsigned char own) {
    if (own == NO_INFORMATION) return;
    if (below == NO_INFORMATION || below < own) below = own;
  });
}

void CostmapLayer::updateWithMaxWithoutUnknownOverwrite(Costmap2D& master_grid, int min_i,
                                                        int min_j, int max_i, int max_j) {
  updateEach(master_grid, min_i, min_j, max_i, max_j, [](unsigned char& below, unsigned char own) {
    if (own == NO_INFORMATION || below == NO_INFORMATION) return;
    below = std::max(below, own);
  });
}

void CostmapLayer::updateWithAddition(Costmap2D& master_grid, int min_i, int min_j, int max_i,
                                      int max_j) {
  updateEach(master_grid, min_i, min_j, max_i, max_j, [](unsigned char& below, unsigned char own) {
    if (own == NO_INFORMATION) return;
    const int sum = below + own;
    if (below == NO_INFORMATION) {
      below = own;
    } else {
      below = static_cast<unsigned char>(std::min<int>(sum, MAX_NON_OBSTACLE));
    }
  });
}

CombinationMethod CostmapLayer::combination_method_from_int(const int value) {
  if (value >= 0 && value <= 2) return static_cast<CombinationMethod>(value);
  RCLCPP_WARN(logger_,
              "Param combination_method: %i. Possible values are 0 (Overwrite), 1 (Maximum) or "
              "2 (Maximum without overwriting the master's NO_INFORMATION values). "
              "The default value 1 will be used.",
              value);
  return CombinationMethod::Max;
}

}  // namespace nav2_costmap_2d
