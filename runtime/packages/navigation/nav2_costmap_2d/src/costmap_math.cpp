// See costmap_math.hpp.
#include "nav2_costmap_2d/costmap_math.hpp"

#include <algorithm>

double distanceToLine(double pX, double pY, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  const double square = dx * dx + dy * dy;
  const double share = square > 0 ? ((pX - x0) * dx + (pY - y0) * dy) / square : 0.0;
  const double nearest = std::clamp(share, 0.0, 1.0);
  return distance(pX, pY, x0 + nearest * dx, y0 + nearest * dy);
}
