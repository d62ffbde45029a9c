// See cartesian_frame.hpp.
#include "geo/cartesian_frame.hpp"

#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>
#include <exception>

namespace robot_localization {
namespace {

bool is_finite(const GeoPoint& point) {
  return std::isfinite(point.latitude) && std::isfinite(point.longitude) &&
         std::isfinite(point.altitude);
}

}  // namespace

CartesianFrame::Point CartesianFrame::set_datum(const GeoPoint& datum) {
  if (!is_finite(datum) || std::abs(datum.latitude) > 90.0) {
    return std::string("latitude, longitude and altitude must be numbers of a place");
  }
  if (is_local_) {
    local_.Reset(datum.latitude, datum.longitude, 0.0);
    return from_geo(datum);
  }
  try {
    Eigen::Vector3d point(0.0, 0.0, datum.altitude);
    double degrees = 0.0;
    double scale = 0.0;
    int zone = 0;
    bool is_north = true;
    GeographicLib::UTMUPS::Forward(
        datum.latitude, datum.longitude, zone, is_north, point.x(), point.y(), degrees, scale,
        is_zone_fixed_ ? zone_ : static_cast<int>(GeographicLib::UTMUPS::STANDARD));
    zone_ = zone;
    is_north_ = is_north;
    convergence_ = degrees * M_PI / 180.0;
    return point;
  } catch (const std::exception& error) {
    return std::string(error.what());
  }
}

std::optional<std::string> CartesianFrame::set_zone(const std::string& name) {
  try {
    int zone = 0;
    bool is_north = true;
    double x = 0.0;
    double y = 0.0;
    int precision = 0;
    GeographicLib::MGRS::Reverse(name, zone, is_north, x, y, precision, true);
    if (zone < GeographicLib::UTMUPS::MINUTMZONE) return "not a UTM zone: " + name;
    zone_ = zone;
    is_north_ = is_north;
    is_zone_fixed_ = true;
    return std::nullopt;
  } catch (const std::exception& error) {
    return std::string(error.what());
  }
}

CartesianFrame::Point CartesianFrame::from_geo(const GeoPoint& point) const {
  if (!is_finite(point)) return std::string("a coordinate is not finite");
  try {
    Eigen::Vector3d result(0.0, 0.0, point.altitude);
    if (is_local_) {
      local_.Forward(point.latitude, point.longitude, point.altitude, result.x(), result.y(),
                     result.z());
      return result;
    }
    int zone = 0;
    bool is_north = true;
    GeographicLib::UTMUPS::Forward(point.latitude, point.longitude, zone, is_north, result.x(),
                                   result.y(), zone_);
    // A robot may cross the equator: y goes on as in the half of its datum.
    if (is_north != is_north_)
      result.y() += (is_north ? 1.0 : -1.0) * GeographicLib::UTMUPS::UTMShift();
    return result;
  } catch (const std::exception& error) {
    return std::string(error.what());
  }
}

std::optional<GeoPoint> CartesianFrame::to_geo(const Eigen::Vector3d& point) const {
  GeoPoint result;
  try {
    if (is_local_) {
      local_.Reverse(point.x(), point.y(), point.z(), result.latitude, result.longitude,
                     result.altitude);
    } else {
      GeographicLib::UTMUPS::Reverse(zone_, is_north_, point.x(), point.y(), result.latitude,
                                     result.longitude);
      result.altitude = point.z();
    }
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return is_finite(result) ? std::optional(result) : std::nullopt;
}

}  // namespace robot_localization
