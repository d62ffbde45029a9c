// See geographic.hpp.
#include "sensors/geographic.hpp"

#include <cmath>

namespace ros2wasm_sim {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
// WGS84: half the axes in metres, and the squares of both eccentricities.
constexpr double kEquatorial = 6378137.0;
constexpr double kPolar = 6356752.314245;
constexpr double kFirstSquared = 1 - kPolar * kPolar / (kEquatorial * kEquatorial);
constexpr double kSecondSquared = kEquatorial * kEquatorial / (kPolar * kPolar) - 1;

/// From the surface along its normal to the axis of the earth, in metres.
double curvature_radius(double sin_latitude) {
  return kEquatorial / std::sqrt(1 - kFirstSquared * sin_latitude * sin_latitude);
}

/// By Bowring's formula, which is exact to a fraction of a millimetre near the earth.
Geographic from_centre(const Vector3& at) {
  const double from_axis = std::hypot(at.x, at.y);
  const double reduced = std::atan2(at.z * kEquatorial, from_axis * kPolar);
  const double s = std::sin(reduced), c = std::cos(reduced);
  const double latitude = std::atan2(at.z + kSecondSquared * kPolar * s * s * s,
                                     from_axis - kFirstSquared * kEquatorial * c * c * c);
  const double sine = std::sin(latitude);
  // From both coordinates, so that it holds at the poles too.
  const double altitude = from_axis * std::cos(latitude) + at.z * sine -
                          kEquatorial * kEquatorial / curvature_radius(sine);
  return {latitude / kDegree, std::atan2(at.y, at.x) / kDegree, altitude};
}

}  // namespace

TangentPlane::TangentPlane(const SphericalCoordinates& origin, Heading heading)
    : sin_latitude_(std::sin(origin.latitude_deg * kDegree)),
      cos_latitude_(std::cos(origin.latitude_deg * kDegree)),
      sin_longitude_(std::sin(origin.longitude_deg * kDegree)),
      cos_longitude_(std::cos(origin.longitude_deg * kDegree)),
      sin_heading_(std::sin(origin.heading_deg * kDegree)),
      cos_heading_(std::cos(origin.heading_deg * kDegree)),
      heading_(heading) {
  const double radius = curvature_radius(sin_latitude_);
  const double out = (radius + origin.elevation) * cos_latitude_;
  origin_ = {out * cos_longitude_, out * sin_longitude_,
             ((1 - kFirstSquared) * radius + origin.elevation) * sin_latitude_};
}

Vector3 TangentPlane::east_north_up(const Vector3& local) const {
  const double along = local.x * cos_heading_, across = local.y * sin_heading_;
  const double side = local.x * sin_heading_, ahead = local.y * cos_heading_;
  if (heading_ == Heading::kClassic) return {-along - across, side - ahead, local.z};
  return {along - across, side + ahead, local.z};
}

Geographic TangentPlane::position(const Vector3& local) const {
  const Vector3 enu = east_north_up(local);
  // Away from the axis of the earth, and along it.
  const double out = enu.z * cos_latitude_ - enu.y * sin_latitude_;
  const double along = enu.z * sin_latitude_ + enu.y * cos_latitude_;
  return from_centre(origin_ + Vector3{out * cos_longitude_ - enu.x * sin_longitude_,
                                       out * sin_longitude_ + enu.x * cos_longitude_, along});
}

}  // namespace ros2wasm_sim
