// The outline of a robot: points in its frame [m], in order.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/point32.hpp"
#include "geometry_msgs/msg/polygon.hpp"
#include "geometry_msgs/msg/polygon_stamped.hpp"

namespace nav2_costmap_2d {

/// From the origin to the nearest point of the outline, and to the farthest.
std::pair<double, double> calculateMinAndMaxDistances(
    const std::vector<geometry_msgs::msg::Point>& footprint);

geometry_msgs::msg::Point toPoint(geometry_msgs::msg::Point32 pt);
geometry_msgs::msg::Point32 toPoint32(geometry_msgs::msg::Point pt);
geometry_msgs::msg::Polygon toPolygon(std::vector<geometry_msgs::msg::Point> pts);
std::vector<geometry_msgs::msg::Point> toPointVector(
    geometry_msgs::msg::Polygon::SharedPtr polygon);

/// At a pose, `theta` in rad.
void transformFootprint(double x, double y, double theta,
                        const std::vector<geometry_msgs::msg::Point>& footprint_spec,
                        std::vector<geometry_msgs::msg::Point>& oriented_footprint);
/// The header stays as it is.
void transformFootprint(double x, double y, double theta,
                        const std::vector<geometry_msgs::msg::Point>& footprint_spec,
                        geometry_msgs::msg::PolygonStamped& oriented_footprint);

/// Moves each coordinate away from 0.
void padFootprint(std::vector<geometry_msgs::msg::Point>& footprint, double padding);
/// Sixteen points of a circle.
std::vector<geometry_msgs::msg::Point> makeFootprintFromRadius(double radius);
/// Reads `[[0.1, 0.1], [0.1, -0.1], [-0.1, 0.0]]`. False, with errors logged, for other texts.
bool makeFootprintFromString(const std::string& footprint_string,
                             std::vector<geometry_msgs::msg::Point>& footprint);

}  // namespace nav2_costmap_2d
