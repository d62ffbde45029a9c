// See footprint_collision_checker.hpp.
#include "nav2_costmap_2d/footprint_collision_checker.hpp"

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "nav2_util/line_iterator.hpp"

namespace nav2_costmap_2d {

template <typename CostmapT>
FootprintCollisionChecker<CostmapT>::FootprintCollisionChecker() : costmap_(nullptr) {}

template <typename CostmapT>
FootprintCollisionChecker<CostmapT>::FootprintCollisionChecker(CostmapT costmap)
    : costmap_(costmap) {}

template <typename CostmapT>
double FootprintCollisionChecker<CostmapT>::footprintCost(const Footprint& footprint) {
  std::vector<MapLocation> corners;
  for (const auto& point : footprint) {
    MapLocation corner;
    if (!worldToMap(point.x, point.y, corner.x, corner.y)) {
      return static_cast<double>(LETHAL_OBSTACLE);
    }
    corners.push_back(corner);
  }
  double cost = 0.0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const MapLocation& from = corners[i];
    const MapLocation& to = corners[(i + 1) % corners.size()];
    cost = std::max(cost, lineCost(static_cast<int>(from.x), static_cast<int>(to.x),
                                   static_cast<int>(from.y), static_cast<int>(to.y)));
    if (cost == static_cast<double>(LETHAL_OBSTACLE)) break;
  }
  return cost;
}

template <typename CostmapT>
double FootprintCollisionChecker<CostmapT>::lineCost(int x0, int x1, int y0, int y1) const {
  double cost = 0.0;
  for (nav2_util::LineIterator line(x0, y0, x1, y1); line.isValid(); line.advance()) {
    cost = std::max(cost, pointCost(line.getX(), line.getY()));
    if (cost == static_cast<double>(LETHAL_OBSTACLE)) break;
  }
  return cost;
}

template <typename CostmapT>
bool FootprintCollisionChecker<CostmapT>::worldToMap(double wx, double wy, unsigned int& mx,
                                                     unsigned int& my) {
  return costmap_->worldToMap(wx, wy, mx, my);
}

template <typename CostmapT>
double FootprintCollisionChecker<CostmapT>::pointCost(int x, int y) const {
  return static_cast<double>(
      costmap_->getCost(static_cast<unsigned int>(x), static_cast<unsigned int>(y)));
}

template <typename CostmapT>
void FootprintCollisionChecker<CostmapT>::setCostmap(CostmapT costmap) {
  costmap_ = costmap;
}

template <typename CostmapT>
double FootprintCollisionChecker<CostmapT>::footprintCostAtPose(double x, double y, double theta,
                                                                const Footprint& footprint) {
  Footprint oriented;
  transformFootprint(x, y, theta, footprint, oriented);
  return footprintCost(oriented);
}

template class FootprintCollisionChecker<std::shared_ptr<Costmap2D>>;
template class FootprintCollisionChecker<Costmap2D*>;

}  // namespace nav2_costmap_2d
