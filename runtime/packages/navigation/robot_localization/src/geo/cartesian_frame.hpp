// The flat coordinates of a place on the globe: UTM, or a plane that touches the globe at a datum.
// The only file that knows GeographicLib, whose exceptions end here.
#pragma once

#include <Eigen/Core>
#include <GeographicLib/LocalCartesian.hpp>
#include <optional>
#include <string>
#include <variant>

namespace robot_localization {

/// Latitude and longitude [deg], altitude [m].
struct GeoPoint {
  double latitude = 0.0;
  double longitude = 0.0;
  double altitude = 0.0;
};

class CartesianFrame {
 public:
  explicit CartesianFrame(bool is_local) : is_local_(is_local) {}

  /// A point, or why there is none: a latitude beyond a pole, a zone far away.
  using Point = std::variant<Eigen::Vector3d, std::string>;

  /// Makes it the datum: of UTM, the zone is that of the point, unless set_zone() fixed it.
  Point set_datum(const GeoPoint& datum);
  /// "31U", or a longer grid reference of the military grid. Returns an error, or nothing.
  std::optional<std::string> set_zone(const std::string& name);

  /// x to the east, y to the north, z up [m]. After set_datum() or set_zone().
  Point from_geo(const GeoPoint& point) const;
  std::optional<GeoPoint> to_geo(const Eigen::Vector3d& point) const;

  bool is_local() const { return is_local_; }
  int zone() const { return zone_; }
  bool is_north() const { return is_north_; }
  /// From true north to that of the grid [rad]; 0 in a local frame.
  double meridian_convergence() const { return convergence_; }

 private:
  bool is_local_;
  bool is_zone_fixed_ = false;
  int zone_ = 0;
  bool is_north_ = true;
  double convergence_ = 0.0;
  GeographicLib::LocalCartesian local_;
};

}  // namespace robot_localization
