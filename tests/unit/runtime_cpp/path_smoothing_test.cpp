// The smoothing of paths: what becomes shorter and less curved, what stays, and where it ends.
#include <cmath>
#include <limits>

#include "gtest/gtest.h"
#include "nav2_smoother/path_geometry.hpp"

namespace nav2_smoother {
namespace {

constexpr RelaxationSettings kDefaults{1e-10, 1000, 0.2, 0.3};
const auto kFree = [](const PathPoint&) { return true; };
const auto kInTime = [] { return false; };

PathPoints line(size_t count, double dx, double dy) {
  PathPoints path;
  for (size_t i = 0; i < count; ++i) {
    const auto k = static_cast<double>(i);
    path.push_back({k * dx, k * dy, std::atan2(dy, dx)});
  }
  return path;
}

/// 0.1 m between points, which are by turns 0.05 m to the left and to the right of a line.
PathPoints zigzag(size_t count) {
  PathPoints path = line(count, 0.1, 0.0);
  for (size_t i = 0; i < count; ++i) path[i].y = i % 2 == 0 ? 0.05 : -0.05;
  return path;
}

double length(const PathPoints& path) {
  double sum = 0.0;
  for (size_t i = 1; i < path.size(); ++i) {
    sum += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
  }
  return sum;
}

double heading(const PathPoints& path, size_t i) {
  return std::atan2(path[i + 1].y - path[i].y, path[i + 1].x - path[i].x);
}

/// The sum of all changes of direction.
double bend(const PathPoints& path) {
  double sum = 0.0;
  for (size_t i = 1; i + 1 < path.size(); ++i) {
    sum += std::abs(std::remainder(heading(path, i) - heading(path, i - 1), 2 * M_PI));
  }
  return sum;
}

void expect_same_ends(const PathPoints& smooth, const PathPoints& path) {
  ASSERT_EQ(smooth.size(), path.size());
  EXPECT_EQ(smooth.front().x, path.front().x);
  EXPECT_EQ(smooth.front().y, path.front().y);
  EXPECT_EQ(smooth.back().x, path.back().x);
  EXPECT_EQ(smooth.back().y, path.back().y);
}

TEST(PathSmoothing, RelaxationMakesAZigzagShorterAndStraighter) {
  const PathPoints path = zigzag(30);
  PathPoints smooth = path;
  EXPECT_EQ(relax(smooth, kDefaults, kFree, kInTime), Relaxation::done);
  expect_same_ends(smooth, path);
  EXPECT_LT(length(smooth), 0.85 * length(path));
  EXPECT_LT(bend(smooth), 0.3 * bend(path));
}

TEST(PathSmoothing, RelaxationRestsWhereBothPullsAreEqual) {
  // 0.2 (1 - y) + 0.3 (0 + 0 - 2 y) = 0
  PathPoints path{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
  EXPECT_EQ(relax(path, kDefaults, kFree, kInTime), Relaxation::done);
  EXPECT_NEAR(path[1].x, 1.0, 1e-9);
  EXPECT_NEAR(path[1].y, 0.25, 1e-9);
  PathPoints straight = line(12, 0.1, 0.05);
  EXPECT_EQ(relax(straight, kDefaults, kFree, kInTime), Relaxation::done);
  for (size_t i = 0; i < straight.size(); ++i) {
    EXPECT_NEAR(straight[i].y, 0.05 * static_cast<double>(i), 1e-9);
  }
}

TEST(PathSmoothing, RelaxationStopsBeforeAnObstacle) {
  const PathPoints path = zigzag(30);
  PathPoints smooth = path;
  // The first round already puts a point there.
  const auto is_far = [](const PathPoint& point) { return std::abs(point.y) > 0.04; };
  EXPECT_EQ(relax(smooth, kDefaults, is_far, kInTime), Relaxation::blocked);
  for (size_t i = 0; i < path.size(); ++i) EXPECT_EQ(smooth[i].y, path[i].y);
}

TEST(PathSmoothing, RelaxationStopsInALaterRound) {
  const PathPoints path = zigzag(30);
  RelaxationSettings one_round = kDefaults;
  one_round.most_rounds = 2;
  PathPoints once = path;
  EXPECT_EQ(relax(once, one_round, kFree, kInTime), Relaxation::too_many_rounds);
  // The second round is blocked at its first point.
  size_t asked = 0;
  PathPoints smooth = path;
  EXPECT_EQ(
      relax(
          smooth, kDefaults, [&](const PathPoint&) { return ++asked < path.size() - 1; }, kInTime),
      Relaxation::blocked);
  for (size_t i = 0; i < path.size(); ++i) EXPECT_EQ(smooth[i].y, once[i].y);
  EXPECT_NE(smooth[2].y, path[2].y);
}

TEST(PathSmoothing, RelaxationEnds) {
  PathPoints path = zigzag(30);
  RelaxationSettings settings = kDefaults;
  settings.most_rounds = 4;
  int asked = 0;
  EXPECT_EQ(relax(path, settings, kFree, [&asked] { return ++asked > 100; }),
            Relaxation::too_many_rounds);
  // As in upstream, the last round is the one before the limit.
  EXPECT_EQ(asked, 3);
  EXPECT_LT(length(path), length(zigzag(30)));
  EXPECT_EQ(relax(path, kDefaults, kFree, [] { return true; }), Relaxation::late);
  settings = {-1.0, 20, 0.2, 0.3};
  EXPECT_EQ(relax(path, settings, kFree, kInTime), Relaxation::too_many_rounds);
  settings = {1e-10, 100000, 40.0, 70.0};
  const PathPoints before = zigzag(30);
  PathPoints wild = before;
  EXPECT_EQ(relax(wild, settings, kFree, kInTime), Relaxation::blocked);
  for (const PathPoint& point : wild) EXPECT_TRUE(std::isfinite(point.x + point.y));
  PathPoints broken = before;
  broken[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(relax(broken, kDefaults, kFree, kInTime), Relaxation::blocked);
  PathPoints none;
  EXPECT_EQ(relax(none, kDefaults, kFree, kInTime), Relaxation::done);
}

TEST(PathSmoothing, SavitzkyGolayFlattensAZigzag) {
  const PathPoints path = zigzag(30);
  PathPoints smooth = path;
  for (int pass = 0; pass < 3; ++pass) filter_savitzky_golay(smooth);
  expect_same_ends(smooth, path);
  EXPECT_LT(length(smooth), 0.85 * length(path));
  EXPECT_LT(bend(smooth), 0.3 * bend(path));
}

TEST(PathSmoothing, SavitzkyGolayReproducesLinesAndParabolas) {
  const PathPoints straight = line(20, 0.1, 0.05);
  PathPoints smooth = straight;
  filter_savitzky_golay(smooth);
  for (size_t i = 0; i < straight.size(); ++i) {
    // On the line, and at the same place where no end is near.
    EXPECT_NEAR(smooth[i].y, 0.5 * smooth[i].x, 1e-12);
  }
  for (size_t i = 3; i + 3 < straight.size(); ++i) {
    EXPECT_NEAR(smooth[i].x, straight[i].x, 1e-12);
  }
  PathPoints parabola = line(20, 0.1, 0.0);
  for (PathPoint& point : parabola) point.y = point.x * point.x;
  smooth = parabola;
  filter_savitzky_golay(smooth);
  for (size_t i = 3; i + 3 < parabola.size(); ++i) EXPECT_NEAR(smooth[i].y, parabola[i].y, 1e-12);
}

TEST(PathSmoothing, SavitzkyGolayCountsTheEndsForWhatIsBeyond) {
  // The first point, at 0, has the weights -2, 3 and 6 at once.
  PathPoints path = line(10, 1.0, 0.0);
  filter_savitzky_golay(path);
  EXPECT_NEAR(path[1].x, (7.0 * 1 + 6 * 2 + 3 * 3 - 2 * 4) / 21, 1e-12);
  PathPoints pair = line(2, 1.0, 0.0);
  filter_savitzky_golay(pair);
  EXPECT_EQ(pair[1].x, 1.0);
}

TEST(PathSmoothing, PartsEndWhereTheRobotReverses) {
  PathPoints path = line(5, 1.0, 0.0);
  for (double x = 3.0; x >= 0.0; x -= 1.0) path.push_back({x, 0.0, 0.0});
  const auto parts = parts_of(path);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].start, 0U);
  EXPECT_EQ(parts[0].end, 4U);
  EXPECT_EQ(parts[1].start, 4U);
  EXPECT_EQ(parts[1].end, 8U);
}

TEST(PathSmoothing, PartsEndWhereTheRobotTurnsOnTheSpot) {
  PathPoints path = line(3, 1.0, 0.0);
  path.push_back({2.0, 0.0, M_PI / 2});
  path.push_back({2.0, 1.0, M_PI / 2});
  const auto parts = parts_of(path);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].end, 2U);
  EXPECT_EQ(parts[1].end, 4U);
  EXPECT_TRUE(parts_of({}).empty());
  ASSERT_EQ(parts_of({{0, 0, 0}}).size(), 1U);
}

TEST(PathSmoothing, PointsLookAlongThePath) {
  PathPoints path{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 0.3}};
  EXPECT_FALSE(turn_along(path));
  EXPECT_NEAR(path[1].yaw, M_PI / 4, 1e-12);
  EXPECT_NEAR(path[2].yaw, M_PI / 2, 1e-12);
  EXPECT_EQ(path[3].yaw, 0.3);
  PathPoints backward{{0, 0, M_PI}, {1, 0, M_PI}, {2, 0, M_PI}, {3, 0, M_PI}};
  EXPECT_TRUE(turn_along(backward));
  for (const PathPoint& point : backward) EXPECT_NEAR(std::cos(point.yaw), -1.0, 1e-12);
  PathPoints same{{0, 0, 1.0}, {0, 0, 1.0}, {1, 0, 1.0}};
  turn_along(same);
  EXPECT_EQ(same[0].yaw, 1.0);
  PathPoints pair{{0, 0, 1.0}, {1, 0, 1.0}};
  EXPECT_FALSE(turn_along(pair));
}

}  // namespace
}  // namespace nav2_smoother
