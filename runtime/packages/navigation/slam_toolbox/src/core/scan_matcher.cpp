// See scan_matcher.hpp.
#include "core/scan_matcher.hpp"

#include <algorithm>
#include <optional>

namespace slam_toolbox {
namespace {

constexpr double kTolerance = 1e-6;
constexpr double kMostVariance = 500.0;  // [m^2]: nothing is known
/// Responses that are lower than the best by more do not count for its variance.
constexpr double kResponseRange = 0.1;
constexpr double kLeastSegment = 0.1;  // [m]
constexpr double kFarthest = 1e8;      // cells

double cross(const Point& origin, const Point& a, const Point& b) {
  return (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
}

/// Adds the points of a scan whose surface shows the same side to `viewpoint` as to the scan's own
/// sensor: the other side of a wall does not fit to what is seen from here.
void add_visible(const Scan& scan, const Point& viewpoint, std::vector<Point>& seen) {
  const Point sensor = scan.corrected * scan.sensor;
  std::vector<Point> run;
  for (const Point& hit : scan.hits) {
    run.push_back(scan.corrected * hit);
    const Point& begin = run.front();
    const Point& end = run.back();
    if (squared_distance(begin, end) < kLeastSegment * kLeastSegment) continue;
    if (cross(sensor, begin, end) * cross(viewpoint, begin, end) >= 0.0) {
      seen.insert(seen.end(), run.begin(), run.end() - 1);
    }
    run.assign(1, Point(end));
  }
}

int steps_of(double reach, double step) {
  return static_cast<int>(std::lround(2.0 * reach / step)) + 1;
}

struct Offset {
  int column;
  int row;
};

/// The cells under the points of a scan that is turned, from the cell of its base.
void turn(const Scan& scan, double yaw, double resolution, std::vector<Offset>& cells) {
  cells.clear();
  const Pose turned{0.0, 0.0, yaw};
  for (const Point& hit : scan.hits) {
    const Point point = turned * hit;
    const double column = point.x / resolution;
    const double row = point.y / resolution;
    // No raster has cells that far away.
    if (!(std::abs(column) < kFarthest && std::abs(row) < kFarthest)) continue;
    cells.push_back({static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row))});
  }
}

/// The sum of the cells under the points.
int sum_of(const CorrelationGrid& grid, const std::vector<Offset>& cells, int column, int row) {
  int sum = 0;
  for (const Offset& cell : cells) sum += grid.at(column + cell.column, row + cell.row);
  return sum;
}

}  // namespace

/// The responses of all poses of a search, by angle, then by y, then by x.
struct ScanMatcher::Responses {
  Responses(const Search& search, const Pose& centre_pose)
      : centre(centre_pose),
        step(search.step),
        angle_step(search.angle_step),
        side(steps_of(search.reach, search.step)),
        angles(steps_of(search.angle, search.angle_step)),
        values(static_cast<size_t>(side) * static_cast<size_t>(side) *
               static_cast<size_t>(angles)) {}

  double offset(int i) const { return (i - (side - 1) / 2.0) * step; }
  double turning(int i) const { return (i - (angles - 1) / 2.0) * angle_step; }
  float& value(int angle, int y, int x) {
    return values[(static_cast<size_t>(angle) * static_cast<size_t>(side) +
                   static_cast<size_t>(y)) *
                      static_cast<size_t>(side) +
                  static_cast<size_t>(x)];
  }
  template <typename VisitT>
  void each(const VisitT& visit) {
    for (int angle = 0; angle < angles; ++angle) {
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
          visit(offset(x), offset(y), turning(angle), value(angle, y, x));
        }
      }
    }
  }

  /// The mean of the poses with the best response.
  Pose best(double response) {
    double count = 0.0;
    Point sum;
    double c = 0.0;
    double s = 0.0;
    each([&](double x, double y, double turning, double value) {
      if (value < response - kTolerance) return;
      count += 1.0;
      sum.x += x;
      sum.y += y;
      c += std::cos(turning);
      s += std::sin(turning);
    });
    return {centre.x + sum.x / count, centre.y + sum.y / count,
            wrapped(centre.yaw + std::atan2(s, c))};
  }

  /// How wide the peak around the best pose is: a corridor leaves its length open.
  Eigen::Matrix3d covariance(const Pose& best, double response) {
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    result(2, 2) = 4.0 * angle_step * angle_step;
    if (response < kTolerance) {
      result(0, 0) = result(1, 1) = kMostVariance;
      return result;
    }
    double norm = 0.0;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        float weight = 0.0F;
        for (int angle = 0; angle < angles; ++angle) weight = std::max(weight, value(angle, y, x));
        if (weight < response - kResponseRange) continue;
        const double dx = centre.x + offset(x) - best.x;
        const double dy = centre.y + offset(y) - best.y;
        norm += weight;
        result(0, 0) += weight * dx * dx;
        result(0, 1) += weight * dx * dy;
        result(1, 1) += weight * dy * dy;
      }
    }
    result.topLeftCorner<2, 2>() /= norm;
    const double least = 0.1 * step * step;
    result(0, 0) = std::max(result(0, 0), least);
    result(1, 1) = std::max(result(1, 1), least);
    // A peak along a diagonal would leave no inverse.
    const double most = 0.99 * std::sqrt(result(0, 0) * result(1, 1));
    result(0, 1) = std::clamp(result(0, 1), -most, most);
    // A poor response is less sure.
    result.topLeftCorner<2, 2>() /= response;
    result(1, 0) = result(0, 1);
    return result;
  }

  double angular_variance(const Pose& best, double response) {
    double norm = 0.0;
    double sum = 0.0;
    const size_t plane = static_cast<size_t>(side) * static_cast<size_t>(side);
    for (int angle = 0; angle < angles; ++angle) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(angle * plane);
      const float weight = *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(plane));
      if (weight < response - kResponseRange) continue;
      const double difference = wrapped(centre.yaw + turning(angle) - best.yaw);
      norm += weight;
      sum += weight * difference * difference;
    }
    return std::max(sum / norm, angle_step * angle_step);
  }

  Pose centre;
  double step;
  double angle_step;
  int side;    ///< how many steps there are in x, and in y
  int angles;  ///< how many angles there are
  std::vector<float> values;
};

ScanMatcher::ScanMatcher(const SearchSpace& space, const MatcherSettings& settings)
    : space_(space), settings_(settings), grid_(space.resolution, space.smear_deviation) {}

Match ScanMatcher::match(const Scan& scan, const Pose& guess, const std::vector<const Scan*>& base,
                         bool penalize, bool refine) {
  Match result;
  result.pose = guess;
  result.covariance.diagonal() << kMostVariance, kMostVariance,
      4.0 * settings_.coarse_angle_resolution * settings_.coarse_angle_resolution;
  if (scan.hits.empty() || !draw(scan, guess, base)) return result;
  Search coarse{0.5 * space_.dimension,
                2.0 * space_.resolution,
                settings_.coarse_search_angle_offset,
                settings_.coarse_angle_resolution,
                penalize,
                true};
  result = search(scan, guess, coarse);
  // Odometry may have slipped further than the usual angle.
  for (int i = 0; settings_.use_response_expansion && i < 3 && result.response < kTolerance; ++i) {
    coarse.angle += 20.0 * M_PI / 180.0;
    result = search(scan, guess, coarse);
  }
  if (!refine || result.response < kTolerance) return result;
  const Search fine{space_.resolution,
                    space_.resolution,
                    0.5 * settings_.coarse_angle_resolution,
                    settings_.fine_search_angle_offset,
                    penalize,
                    false};
  // The coarse search alone sees the peak as a whole.
  Match refined = search(scan, result.pose, fine);
  refined.covariance.topLeftCorner<2, 2>() = result.covariance.topLeftCorner<2, 2>();
  return refined;
}

bool ScanMatcher::draw(const Scan& scan, const Pose& guess, const std::vector<const Scan*>& base) {
  const Point viewpoint = guess * scan.sensor;
  seen_.clear();
  for (const Scan* const other : base) add_visible(*other, viewpoint, seen_);
  // Points out of reach need no cells.
  double reach = 0.0;
  for (const Point& hit : scan.hits) reach = std::max(reach, std::hypot(hit.x, hit.y));
  reach = std::min(reach, scan.max_range + std::hypot(scan.sensor.x, scan.sensor.y));
  reach = std::min(reach + space_.dimension + 2.0 * space_.smear_deviation, grid_.greatest_reach());
  const auto is_far = [&](const Point& point) {
    return std::abs(point.x - guess.x) > reach || std::abs(point.y - guess.y) > reach;
  };
  seen_.erase(std::remove_if(seen_.begin(), seen_.end(), is_far), seen_.end());
  if (seen_.empty()) return false;
  Point least = seen_.front();
  Point most = least;
  for (const Point& point : seen_) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y)};
  }
  if (!grid_.cover(least, most)) return false;
  for (const Point& point : seen_) grid_.add(point);
  return true;
}

double ScanMatcher::penalty(double squared_distance, double angle) const {
  const double distance_part = 1.0 - 0.2 * squared_distance / settings_.distance_variance_penalty;
  const double angle_part = 1.0 - 0.2 * angle * angle / settings_.angle_variance_penalty;
  return std::max(distance_part, settings_.minimum_distance_penalty) *
         std::max(angle_part, settings_.minimum_angle_penalty);
}

Match ScanMatcher::search(const Scan& scan, const Pose& centre, const Search& search) const {
  Responses responses(search, centre);
  std::vector<Offset> cells;
  const double most = static_cast<double>(CorrelationGrid::kOccupied) *
                      static_cast<double>(std::max<size_t>(scan.rays, scan.hits.size()));
  float best = 0.0F;
  for (int angle = 0; angle < responses.angles; ++angle) {
    const double turning = responses.turning(angle);
    turn(scan, centre.yaw + turning, grid_.resolution(), cells);
    for (int y = 0; y < responses.side; ++y) {
      const double dy = responses.offset(y);
      const int row = grid_.row_of(centre.y + dy);
      for (int x = 0; x < responses.side; ++x) {
        const double dx = responses.offset(x);
        double value = sum_of(grid_, cells, grid_.column_of(centre.x + dx), row) / most;
        if (search.penalize) value *= penalty(dx * dx + dy * dy, turning);
        responses.value(angle, y, x) = static_cast<float>(value);
        best = std::max(best, static_cast<float>(value));
      }
    }
  }
  Match result;
  result.response = best;
  result.pose = best < kTolerance ? centre : responses.best(best);
  result.covariance = responses.covariance(result.pose, best);
  if (!search.is_coarse && best >= kTolerance) {
    result.covariance(2, 2) = responses.angular_variance(result.pose, best);
  }
  return result;
}

}  // namespace slam_toolbox
