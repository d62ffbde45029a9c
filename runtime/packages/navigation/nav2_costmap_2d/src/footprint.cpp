// See footprint.hpp.
#include "nav2_costmap_2d/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nav2_costmap_2d/costmap_math.hpp"
#include "nav2_util/array_parser.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d {
namespace {

using geometry_msgs::msg::Point;
using geometry_msgs::msg::Point32;
using geometry_msgs::msg::Polygon;

Point at_pose(const Point& point, double x, double y, double cosine, double sine) {
  Point moved;
  moved.x = x + point.x * cosine - point.y * sine;
  moved.y = y + point.x * sine + point.y * cosine;
  return moved;
}

}  // namespace

std::pair<double, double> calculateMinAndMaxDistances(const std::vector<Point>& footprint) {
  double nearest = std::numeric_limits<double>::max();
  double farthest = 0.0;
  if (footprint.size() <= 2) return {nearest, farthest};
  for (size_t i = 0; i < footprint.size(); ++i) {
    const Point& point = footprint[i];
    const Point& next = footprint[(i + 1) % footprint.size()];
    const double corner = distance(0.0, 0.0, point.x, point.y);
    const double side = distanceToLine(0.0, 0.0, point.x, point.y, next.x, next.y);
    nearest = std::min({nearest, corner, side});
    farthest = std::max({farthest, corner, side});
  }
  return {nearest, farthest};
}

Point toPoint(Point32 pt) {
  Point point;
  point.x = pt.x;
  point.y = pt.y;
  point.z = pt.z;
  return point;
}

Point32 toPoint32(Point pt) {
  Point32 point;
  point.x = static_cast<float>(pt.x);
  point.y = static_cast<float>(pt.y);
  point.z = static_cast<float>(pt.z);
  return point;
}

Polygon toPolygon(std::vector<Point> pts) {
  Polygon polygon;
  std::transform(pts.begin(), pts.end(), std::back_inserter(polygon.points), toPoint32);
  return polygon;
}

std::vector<Point> toPointVector(Polygon::SharedPtr polygon) {
  std::vector<Point> points;
  std::transform(polygon->points.begin(), polygon->points.end(), std::back_inserter(points),
                 toPoint);
  return points;
}

void transformFootprint(double x, double y, double theta, const std::vector<Point>& footprint_spec,
                        std::vector<Point>& oriented_footprint) {
  const double cosine = std::cos(theta);
  const double sine = std::sin(theta);
  oriented_footprint.clear();
  for (const Point& point : footprint_spec) {
    oriented_footprint.push_back(at_pose(point, x, y, cosine, sine));
  }
}

void transformFootprint(double x, double y, double theta, const std::vector<Point>& footprint_spec,
                        geometry_msgs::msg::PolygonStamped& oriented_footprint) {
  std::vector<Point> points;
  transformFootprint(x, y, theta, footprint_spec, points);
  oriented_footprint.polygon = toPolygon(points);
}

void padFootprint(std::vector<Point>& footprint, double padding) {
  for (Point& point : footprint) {
    point.x += sign0(point.x) * padding;
    point.y += sign0(point.y) * padding;
  }
}

std::vector<Point> makeFootprintFromRadius(double radius) {
  constexpr int kPoints = 16;
  std::vector<Point> points;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = i * 2 * M_PI / kPoints;
    Point point;
    point.x = std::cos(angle) * radius;
    point.y = std::sin(angle) * radius;
    points.push_back(point);
  }
  return points;
}

bool makeFootprintFromString(const std::string& footprint_string, std::vector<Point>& footprint) {
  const rclcpp::Logger logger = rclcpp::get_logger("nav2_costmap_2d");
  std::string error;
  const std::vector<std::vector<float>> rows = nav2_util::parseVVF(footprint_string, error);
  if (!error.empty()) {
    RCLCPP_ERROR(logger, "Error parsing footprint parameter: '%s'", error.c_str());
    RCLCPP_ERROR(logger, "  Footprint string was '%s'.", footprint_string.c_str());
    return false;
  }
  if (rows.size() < 3) {
    RCLCPP_ERROR(logger,
                 "You must specify at least three points for the robot footprint, reverting to "
                 "previous footprint.");
    return false;
  }
  std::vector<Point> points;
  for (const auto& row : rows) {
    if (row.size() != 2) {
      RCLCPP_ERROR(logger,
                   "Points in the footprint specification must be pairs of numbers. Found a point "
                   "with %d numbers.",
                   static_cast<int>(row.size()));
      return false;
    }
    Point point;
    point.x = row[0];
    point.y = row[1];
    points.push_back(point);
  }
  footprint = points;
  return true;
}

}  // namespace nav2_costmap_2d
