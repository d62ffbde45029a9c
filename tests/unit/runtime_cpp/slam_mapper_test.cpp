// SLAM below ROS: matching of scans, the pose graph, closed loops, the map, and saved sessions.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/coverage.hpp"
#include "core/mapper.hpp"
#include "core/session_file.hpp"

namespace slam_toolbox {
namespace {

struct Wall {
  Point from, to;
};

/// Walls around a corridor of 2 m that leads around a block of 8 m by 4 m, with some niches.
std::vector<Wall> corridor() {
  std::vector<Wall> walls;
  const auto add = [&walls](const std::vector<Point>& corners) {
    for (size_t i = 0; i < corners.size(); ++i) {
      walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
    }
  };
  add({{0, 0},    {5, 0},    {5, -0.6}, {6, -0.6}, {6, 0},    {12, 0},  {12, 3},
       {12.5, 3}, {12.5, 4}, {12, 4},   {12, 8},   {8, 8},    {8, 8.7}, {7, 8.7},
       {7, 8},    {0, 8},    {0, 5},    {-0.5, 5}, {-0.5, 4}, {0, 4}});
  add({{2, 2},
       {4, 2},
       {4, 2.4},
       {4.8, 2.4},
       {4.8, 2},
       {10, 2},
       {10, 6},
       {6, 6},
       {6, 5.5},
       {5, 5.5},
       {5, 6},
       {2, 6}});
  return walls;
}

double range_at(const std::vector<Wall>& walls, const Point& from, double angle) {
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : walls) {
    const double ex = b.x - a.x;
    const double ey = b.y - a.y;
    const double det = ex * dy - ey * dx;
    if (std::abs(det) < 1e-12) continue;
    const double t = (ex * (a.y - from.y) - ey * (a.x - from.x)) / det;
    const double u = (dx * (a.y - from.y) - dy * (a.x - from.x)) / det;
    if (t > 0 && u >= 0 && u <= 1) least = std::min(least, t);
  }
  return least;
}

/// 360 beams of up to 4 m with noise of 1 cm, of which 3.5 m are drawn.
Scan look(const std::vector<Wall>& walls, const Pose& pose, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 0.01);
  Scan scan;
  scan.sensor = {-0.03, 0.0};
  scan.rays = 360;
  scan.max_range = 3.5;
  const Point from = pose * scan.sensor;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * M_PI / 180.0;
    const double range = range_at(walls, from, pose.yaw + angle) + noise(random);
    if (range > 4.0) continue;
    scan.hits.push_back(
        {scan.sensor.x + range * std::cos(angle), scan.sensor.y + range * std::sin(angle)});
  }
  find_middle(scan);
  return scan;
}

/// Odometry that is 2 % too long and turns by 0.02 rad too much each meter.
class Drive {
 public:
  explicit Drive(const Pose& start) : pose(start), odometry(start) {}

  template <typename VisitT>
  void to(const Point& goal, const VisitT& visit) {
    turn(wrapped(std::atan2(goal.y - pose.y, goal.x - pose.x) - pose.yaw), visit);
    double left = std::sqrt(squared_distance(goal, pose.position()));
    for (; left > 1e-9; left -= 0.1) {
      const double step = std::min(left, 0.1);
      pose = pose * Pose{step, 0, 0};
      odometry = odometry * Pose{1.02 * step, 0, 0.02 * step};
      visit();
    }
  }
  template <typename VisitT>
  void turn(double angle, const VisitT& visit) {
    for (int i = 0; i < 10; ++i) {
      pose.yaw = wrapped(pose.yaw + angle / 10);
      odometry.yaw = wrapped(odometry.yaw + 1.02 * angle / 10);
      visit();
    }
  }

  Pose pose;
  Pose odometry;
};

double error_of(const Pose& corrected, const Pose& pose) {
  return std::sqrt(squared_distance(corrected.position(), pose.position()));
}

struct Trip {
  Mapper mapper{MapperSettings()};
  double mean = 0.0;  ///< error of the scans' poses, in m, as the next
  double worst = 0.0;
  double raw = 0.0;  ///< that of odometry, in the end
};

/// Around the block, and half of the first leg again.
Trip around(const MapperSettings& settings, unsigned seed = 1) {
  const std::vector<Wall> walls = corridor();
  std::mt19937 random(seed);
  Trip trip{Mapper(settings)};
  std::vector<Pose> truth;
  Drive drive({1, 1, 0});
  const auto visit = [&] {
    Scan scan = look(walls, drive.pose, random);
    scan.odometry = scan.corrected = drive.odometry;
    scan.time_ns = static_cast<int64_t>(1e9 * drive.odometry.x);
    if (trip.mapper.process(scan)) truth.push_back(drive.pose);
  };
  visit();
  for (const Point& corner : {Point{11, 1}, Point{11, 7}, Point{1, 7}, Point{1, 1}, Point{6, 1}}) {
    drive.to(corner, visit);
  }
  trip.raw = error_of(drive.odometry, drive.pose);
  for (size_t i = 0; i < truth.size(); ++i) {
    const double error = error_of(trip.mapper.scans()[i].corrected, truth[i]);
    trip.mean += error / static_cast<double>(truth.size());
    trip.worst = std::max(trip.worst, error);
  }
  return trip;
}

TEST(SlamMapper, ClosesALoop) {
  MapperSettings settings;
  const Trip closed = around(settings);
  EXPECT_GT(closed.raw, 1.5);
  EXPECT_EQ(closed.mapper.closed_loops(), 1);
  EXPECT_EQ(closed.mapper.revision(), 1);
  EXPECT_LT(closed.worst, 0.08);
  settings.do_loop_closing = false;
  const Trip open = around(settings);
  EXPECT_EQ(open.mapper.closed_loops(), 0);
  EXPECT_GT(open.worst, 1.3 * closed.worst);
}

TEST(SlamMapper, IsAsFarOffAsTheDocsSay) {
  MapperSettings settings;
  settings.matcher.minimum_distance_penalty = 0.5;
  double mean = 0.0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Trip trip = around(settings, seed);
    EXPECT_EQ(trip.mapper.scans().size(), 83U);
    EXPECT_LT(trip.worst, 0.0515);
    mean += trip.mean / 6.0;
  }
  EXPECT_NEAR(mean, 0.021, 0.0005);
}

TEST(SlamMapper, AddsAScanOnlyAfterAMove) {
  const std::vector<Wall> walls = corridor();
  std::mt19937 random(1);
  MapperSettings settings;
  settings.use_scan_matching = false;
  Mapper mapper(settings);
  const auto is_added = [&](const Pose& odometry) {
    Scan scan = look(walls, {1, 1, 0}, random);
    scan.odometry = scan.corrected = odometry;
    return mapper.process(scan).has_value();
  };
  EXPECT_TRUE(is_added({0, 0, 0}));
  EXPECT_FALSE(is_added({0.4, 0, 0.4}));
  EXPECT_TRUE(is_added({0.5, 0, 0}));
  EXPECT_FALSE(is_added({0.5, 0.3, 0}));
  EXPECT_TRUE(is_added({0.5, 0, -0.5}));
  EXPECT_EQ(mapper.scans().size(), 3U);
  // Another laser of a robot that stands.
  Scan other = look(walls, {1, 1, 0}, random);
  other.sensor = {0.6, 0};
  other.odometry = other.corrected = {0.5, 0, -0.5};
  EXPECT_FALSE(mapper.process(other));
}

/// Matches a scan at `pose` that is guessed to be elsewhere.
Match found(const Pose& pose, const Pose& guess, bool refine = true) {
  const std::vector<Wall> walls = corridor();
  std::mt19937 random(2);
  Scan known = look(walls, {1, 1, 0}, random);
  known.corrected = {1, 1, 0};
  const Scan scan = look(walls, pose, random);
  ScanMatcher matcher{SearchSpace(), MatcherSettings()};
  return matcher.match(scan, guess, {&known}, true, refine);
}

TEST(ScanMatcher, FindsAPoseInACorner) {
  const Pose pose{1.2, 0.9, 0.15};
  const Match match = found(pose, {1.05, 1.05, 0});
  EXPECT_LT(error_of(match.pose, pose), 0.02);
  EXPECT_NEAR(match.pose.yaw, pose.yaw, 0.01);
  EXPECT_GT(match.response, 0.7);
  EXPECT_LT(match.covariance(0, 0), 0.02);
}

TEST(ScanMatcher, SaysWhenNothingFits) {
  const Match match = found({11, 7, 0}, {30, 30, 1});
  EXPECT_EQ(match.response, 0.0);
  EXPECT_EQ(match.pose.x, 30.0);
  EXPECT_EQ(match.covariance(0, 0), 500.0);
  ScanMatcher matcher{SearchSpace(), MatcherSettings()};
  EXPECT_EQ(matcher.match(Scan(), {1, 2, 3}, {}).response, 0.0);
}

TEST(ScanMatcher, FarReadingsAreNoHindrance) {
  const std::vector<Wall> walls = corridor();
  std::mt19937 random(5);
  Scan known = look(walls, {1, 1, 0}, random);
  known.corrected = {1, 1, 0};
  known.hits.push_back({1e7, 1e7});
  Scan scan = look(walls, {1.1, 1, 0}, random);
  scan.hits.push_back({-1e12, 5});
  scan.max_range = 1e6;
  ScanMatcher matcher{SearchSpace(), MatcherSettings()};
  EXPECT_LT(error_of(matcher.match(scan, {1, 1, 0}, {&known}).pose, {1.1, 1, 0}), 0.02);
}

TEST(ScanMatcher, HasAnInverseOfEachCovariance) {
  // Two points on a diagonal, without any smear to speak of.
  Scan known;
  known.sensor = {0, -5};
  known.rays = 3;
  known.max_range = 100;
  known.hits = {{0, 0}, {0.2, 0.2}, {0.4, 0.4}};
  ScanMatcher matcher{SearchSpace{0.5, 0.1, 0.05}, MatcherSettings()};
  const Match match = matcher.match(known, {0, 0, 0}, {&known}, false, false);
  EXPECT_GT(match.response, 0.0);
  EXPECT_GT(match.covariance.determinant(), 0.0);
}

TEST(ScanMatcher, LeavesTheLengthOfACorridorOpen) {
  // Between the niches, where only the two walls are seen.
  std::vector<Wall> walls{{{-50, 0}, {50, 0}}, {{-50, 2}, {50, 2}}};
  std::mt19937 random(3);
  Scan known = look(walls, {0, 1, 0}, random);
  known.corrected = {0, 1, 0};
  ScanMatcher matcher{SearchSpace(), MatcherSettings()};
  const Match match = matcher.match(look(walls, {0.1, 1, 0}, random), {0, 1, 0}, {&known});
  EXPECT_GT(match.covariance(0, 0), 3.0 * match.covariance(1, 1));
}

TEST(ScanMatcher, DoesNotSeeTheOtherSideOfAWall) {
  // A thin wall from above, and a scan from below that would fit to it.
  std::vector<Wall> walls{{{-50, 0}, {50, 0}}};
  std::mt19937 random(4);
  Scan known = look(walls, {0, 1, 0}, random);
  known.corrected = {0, 1, 0};
  ScanMatcher matcher{SearchSpace(), MatcherSettings()};
  EXPECT_EQ(matcher.match(look(walls, {0, -1, 0}, random), {0, -1, 0}, {&known}).response, 0.0);
}

TEST(PoseGraph, SharesAnErrorAmongItsEdges) {
  PoseGraph graph;
  std::vector<Pose> poses{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  for (size_t i = 0; i < poses.size(); ++i) graph.add_node();
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
  graph.link(0, {0, 0, 0}, 1, {1, 0, 0}, unit);
  graph.link(1, {0, 0, 0}, 2, {1, 0, 0}, unit);
  graph.link(0, {0, 0, 0}, 2, {2.3, 0, 0}, unit);
  EXPECT_TRUE(graph.are_linked(2, 0));
  EXPECT_TRUE(graph.optimize(poses));
  EXPECT_EQ(poses[0].x, 0.0);
  EXPECT_NEAR(poses[1].x, 1.1, 1e-6);
  EXPECT_NEAR(poses[2].x, 2.2, 1e-6);
}

TEST(PoseGraph, ClosesASquare) {
  // Four legs of 1 m and 90 degrees, each measured with 0.05 rad too much, and one edge that knows
  // better.
  PoseGraph graph;
  std::vector<Pose> poses{{0, 0, 0}};
  const Pose way{1, 0, M_PI / 2 + 0.05};
  graph.add_node();
  for (int i = 0; i < 4; ++i) {
    const Pose from = poses.back();
    poses.push_back(from * way);
    graph.add_node();
    graph.link(i, from, i + 1, poses.back(), 0.01 * Eigen::Matrix3d::Identity());
  }
  const double open = error_of(poses[4], poses[0]);
  graph.link(0, {0, 0, 0}, 4, {0, 0, 0}, 1e-8 * Eigen::Matrix3d::Identity());
  EXPECT_TRUE(graph.optimize(poses));
  EXPECT_GT(open, 0.1);
  EXPECT_LT(error_of(poses[4], poses[0]), 1e-4);
  EXPECT_NEAR(poses[4].yaw, 0.0, 1e-4);
  EXPECT_NEAR(wrapped(poses[2].yaw - M_PI), 0.0, 0.03);
}

TEST(PoseGraph, TurnsACovarianceIntoTheFrameOfItsStart) {
  PoseGraph graph;
  graph.add_node();
  graph.add_node();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  covariance(0, 0) = 4.0;  // along x of the map, which is -y of the first pose
  graph.link(0, {0, 0, M_PI / 2}, 1, {1, 0, M_PI / 2}, covariance);
  const Edge& edge = graph.edges().at(0);
  EXPECT_NEAR(edge.way.y, -1.0, 1e-12);
  EXPECT_NEAR(edge.information(1, 1), 0.25, 1e-12);
  EXPECT_NEAR(edge.information(0, 0), 1.0, 1e-12);
}

TEST(Coverage, CountsRaysAndTheirEnds) {
  Coverage coverage(0.5);
  Scan scan;
  scan.corrected = {0.25, 0.25, 0};
  scan.max_range = 2.5;
  // The second is too far away.
  scan.hits = {{2.0, 0.0}, {0.0, 10.0}};
  coverage.add(scan);
  coverage.add(scan);
  OccupancyCells cells = coverage.cells();
  // Two passes are too few, but for the cell of the sensor, which has four.
  EXPECT_EQ(cells.columns, 5);
  EXPECT_EQ(cells.rows, 6);
  EXPECT_EQ(std::count(cells.values.begin(), cells.values.end(), -1), 29);
  coverage.add(scan);
  cells = coverage.cells();
  std::vector<int8_t> expected(30, -1);
  for (int i = 0; i < 4; ++i) expected[static_cast<size_t>(i)] = 0;
  for (int i = 0; i < 6; ++i) expected[static_cast<size_t>(5 * i)] = 0;
  expected[4] = 100;
  EXPECT_EQ(cells.values, expected);
  // One to the left and below: the counts move with the map.
  scan.corrected = {-0.25, -0.25, 0};
  for (int i = 0; i < 3; ++i) coverage.add(scan);
  cells = coverage.cells();
  EXPECT_EQ(cells.origin.x, -0.5);
  EXPECT_EQ(cells.origin.y, -0.5);
  EXPECT_EQ(cells.columns, 6);
  const std::vector<int8_t> row(cells.values.begin() + 6, cells.values.begin() + 12);
  EXPECT_EQ(row, (std::vector<int8_t>{0, 0, 0, 0, 0, 100}));
}

TEST(Coverage, IsBounded) {
  Coverage coverage(0.05);
  Scan scan;
  scan.max_range = 1e9;
  scan.hits = {{1e6, 1e6}};
  EXPECT_FALSE(coverage.add(scan));
  scan.hits = {{std::numeric_limits<double>::infinity(), 0}};
  EXPECT_FALSE(coverage.add(scan));
  scan.hits = {{1, 0}};
  EXPECT_TRUE(coverage.add(scan));
  scan.corrected.x = 1e30;
  EXPECT_FALSE(coverage.add(scan));
  EXPECT_EQ(coverage.cells().columns, 21);
  scan.corrected.x = 1500;
  EXPECT_FALSE(coverage.add(scan));
  EXPECT_EQ(coverage.cells().columns, 21);
}

TEST(Session, IsTheSameAfterReading) {
  const Trip trip = around(MapperSettings());
  const Mapper& mapper = trip.mapper;
  const Session session = session_of(to_bytes(mapper.scans(), mapper.graph().edges()));
  ASSERT_EQ(session.scans.size(), mapper.scans().size());
  ASSERT_EQ(session.edges.size(), mapper.graph().edges().size());
  for (size_t i = 0; i < session.scans.size(); ++i) {
    const Scan& read = session.scans[i];
    const Scan& written = mapper.scans()[i];
    for (const auto member : {&Pose::x, &Pose::y, &Pose::yaw}) {
      EXPECT_EQ(read.corrected.*member, written.corrected.*member);
      EXPECT_EQ(read.odometry.*member, written.odometry.*member);
    }
    EXPECT_EQ(read.time_ns, written.time_ns);
    EXPECT_EQ(read.max_range, 3.5);
    EXPECT_EQ(read.sensor.x, -0.03);
    EXPECT_NEAR(read.hits.back().x, written.hits.back().x, 1e-6);
    ASSERT_EQ(session.scans[i].hits.size(), mapper.scans()[i].hits.size());
    EXPECT_EQ(session.scans[i].rays, 360U);
    EXPECT_NEAR(session.scans[i].middle.y, mapper.scans()[i].middle.y, 1e-5);
  }
  for (size_t i = 0; i < session.edges.size(); ++i) {
    const Edge& read = session.edges[i];
    const Edge& written = mapper.graph().edges()[i];
    EXPECT_EQ(read.from, written.from);
    EXPECT_EQ(read.to, written.to);
    EXPECT_EQ(read.way.y, written.way.y);
    EXPECT_EQ(read.information, written.information);
  }

  // A robot that is put near a known place finds its pose, and goes on from there.
  Mapper next{MapperSettings()};
  next.restore(session.scans, session.edges);
  std::mt19937 random(7);
  const std::vector<Wall> walls = corridor();
  Scan scan = look(walls, {5, 1.1, 0.1}, random);
  scan.odometry = {100, 100, 2};
  scan.corrected = {5.1, 1.0, 0.2};
  ASSERT_TRUE(next.process_near(scan));
  EXPECT_LT(error_of(next.scans().back().corrected, {5, 1.1, 0.1}), 0.08);
  scan = look(walls, Pose{5, 1.1, 0.1} * Pose{0.6, 0, 0}, random);
  scan.odometry = Pose{100, 100, 2} * Pose{0.6, 0, 0};
  ASSERT_TRUE(next.process(scan));
  EXPECT_LT(error_of(next.scans().back().corrected, Pose{5, 1.1, 0.1} * Pose{0.6, 0, 0}), 0.08);
  // And one that is put where nothing is known is still part of the graph.
  scan.corrected = {60, 60, 0};
  ASSERT_TRUE(next.process_near(scan));
  EXPECT_EQ(next.graph().edges().back().to, static_cast<int>(next.scans().size()) - 1);
}

TEST(Session, DamagedFilesAreRefused) {
  Scan scan;
  scan.hits = {{1, 2}, {3, 4}};
  Edge edge;
  edge.to = 1;
  const std::string bytes = to_bytes({scan, scan}, {edge});
  EXPECT_EQ(session_of(bytes).edges.size(), 1U);
  for (size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(session_of(bytes.substr(0, size)), std::runtime_error) << size;
  }
  EXPECT_THROW(session_of(bytes + "x"), std::runtime_error);
  edge.to = 2;
  EXPECT_THROW(session_of(to_bytes({scan, scan}, {edge})), std::runtime_error);
  scan.corrected.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(session_of(to_bytes({scan}, {})), std::runtime_error);
  // Counts that promise more than there is.
  std::string many = to_bytes({}, {});
  many.replace(8, 4, 4, '\xff');
  EXPECT_THROW(session_of(many), std::runtime_error);
}

}  // namespace
}  // namespace slam_toolbox
