// From the metres of a world to latitude, longitude and altitude, by the WGS84 ellipsoid.
#pragma once

#include "world/world.hpp"

namespace ros2wasm_sim {

struct Geographic {
  double latitude_deg = 0;
  double longitude_deg = 0;
  double altitude = 0;  ///< metres above the ellipsoid
};

/// How <heading_deg> turns the axes of a world. Gazebo Sim: from east to x, counter-clockwise.
/// Gazebo Classic: x looks west at 0 and east at 180 degrees, so its worlds have 180 for x as
/// east.
enum class Heading { kSim, kClassic };

/// The plane that touches the ellipsoid at the origin of a world.
class TangentPlane {
 public:
  TangentPlane(const SphericalCoordinates& origin, Heading heading);

  /// East, north and up, of a vector along the axes of the world.
  Vector3 east_north_up(const Vector3& local) const;
  Geographic position(const Vector3& local) const;

 private:
  double sin_latitude_, cos_latitude_, sin_longitude_, cos_longitude_;
  double sin_heading_, cos_heading_;
  Heading heading_;
  Vector3 origin_;  ///< metres from the centre of the earth
};

}  // namespace ros2wasm_sim
