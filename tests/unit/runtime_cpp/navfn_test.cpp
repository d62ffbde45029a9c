// The navigation function: lengths of paths, costs, obstacles, and what cannot be reached.
#include "nav2_navfn_planner/navfn.hpp"

#include <cmath>
#include <vector>

#include "gtest/gtest.h"

namespace nav2_navfn_planner {
namespace {

constexpr int kSide = 100;
constexpr double kResolution = 0.05;  // m
constexpr unsigned char kLethal = 254;
constexpr unsigned char kUnknown = 255;

struct Room {
  std::vector<unsigned char> costs = std::vector<unsigned char>(kSide * kSide, 0);

  unsigned char& at(int x, int y) { return costs[static_cast<size_t>(y * kSide + x)]; }
  void wall(int x, int from, int to, unsigned char cost = kLethal) {
    for (int y = from; y <= to; ++y) at(x, y) = cost;
  }
};

struct Way {
  bool is_reached = false;
  std::vector<PathPoint> points;

  double length() const {
    double sum = 0;
    for (size_t i = 1; i < points.size(); ++i) {
      sum += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    }
    return sum * kResolution;
  }
};

Way way(const Room& room, Cell from, Cell to, bool use_astar = false, bool allow_unknown = true) {
  NavFn planner(kSide, kSide);
  planner.setCostmap(room.costs.data(), allow_unknown);
  Way found;
  found.is_reached = planner.computePotential(from, to, use_astar, nullptr);
  found.points = planner.path(to, 4 * kSide);
  return found;
}

TEST(NavFn, AcrossAnEmptyRoom) {
  for (const bool use_astar : {false, true}) {
    const Way found = way(Room(), {10, 10}, {90, 90}, use_astar);
    EXPECT_TRUE(found.is_reached);
    EXPECT_NEAR(found.length(), 5.657, 0.005);
    EXPECT_EQ(found.points.size(), 225U);
  }
}

TEST(NavFn, AroundAWall) {
  Room room;
  room.wall(50, 0, 69);
  const Way dijkstra = way(room, {10, 10}, {90, 10});
  EXPECT_NEAR(dijkstra.length(), 7.227, 0.005);
  EXPECT_EQ(dijkstra.points.size(), 283U);
  const Way astar = way(room, {10, 10}, {90, 10}, true);
  EXPECT_NEAR(astar.length(), 7.368, 0.005);
  EXPECT_EQ(astar.points.size(), 288U);
  for (const PathPoint& point : dijkstra.points) {
    if (std::abs(point.x - 50) < 1) EXPECT_GT(point.y, 68);
  }
}

TEST(NavFn, BeginsAndEndsWhereItShould) {
  const Way found = way(Room(), {20, 30}, {70, 40});
  ASSERT_FALSE(found.points.empty());
  EXPECT_EQ(found.points.front().x, 70);
  EXPECT_EQ(found.points.front().y, 40);
  EXPECT_EQ(found.points.back().x, 20);
  EXPECT_EQ(found.points.back().y, 30);
}

TEST(NavFn, GoesAroundCostsThatAreNotObstacles) {
  Room room;
  // A ridge with a gap far to the side: through it costs 253 a cell, around it the neutral cost.
  for (int x = 45; x < 55; ++x) room.wall(x, 20, 99, 252);
  const Way found = way(room, {10, 50}, {90, 50});
  double lowest = kSide;
  for (const PathPoint& point : found.points) lowest = std::min<double>(lowest, point.y);
  EXPECT_LT(lowest, 21);
}

TEST(NavFn, WhatIsWalledOffIsNotReached) {
  Room room;
  room.wall(50, 0, 99);
  const Way found = way(room, {10, 10}, {90, 90});
  EXPECT_FALSE(found.is_reached);
  EXPECT_TRUE(found.points.empty());
}

TEST(NavFn, UnknownCells) {
  Room room;
  room.wall(50, 0, 99, kUnknown);
  EXPECT_TRUE(way(room, {10, 10}, {90, 90}, false, true).is_reached);
  EXPECT_FALSE(way(room, {10, 10}, {90, 90}, false, false).is_reached);
}

TEST(NavFn, TheBorderIsAnObstacle) {
  EXPECT_FALSE(way(Room(), {0, 50}, {90, 50}).is_reached);
  EXPECT_FALSE(way(Room(), {10, 50}, {99, 50}).is_reached);
  EXPECT_TRUE(way(Room(), {1, 1}, {98, 98}).is_reached);
}

TEST(NavFn, EndsWhenNobodyWantsThePath) {
  NavFn planner(kSide, kSide);
  planner.setCostmap(Room().costs.data(), true);
  int questions = 0;
  EXPECT_FALSE(planner.computePotential({10, 10}, {90, 90}, false, [&questions] {
    ++questions;
    return true;
  }));
  EXPECT_EQ(questions, 1);
  EXPECT_GE(planner.potential({90, 90}), NavFn::kHighPotential);
}

TEST(NavFn, TinyMaps) {
  for (const int side : {1, 2, 3}) {
    NavFn planner(side, side);
    const std::vector<unsigned char> costs(static_cast<size_t>(side * side), 0);
    planner.setCostmap(costs.data(), true);
    EXPECT_FALSE(planner.computePotential({0, 0}, {side - 1, side - 1}, false, nullptr));
    EXPECT_TRUE(planner.path({side - 1, side - 1}, 10).empty());
    if (side < 3) continue;
    // All but the one cell is border.
    EXPECT_FALSE(planner.computePotential({1, 1}, {2, 2}, false, nullptr));
    EXPECT_TRUE(planner.computePotential({1, 1}, {1, 1}, false, nullptr));
    EXPECT_EQ(planner.path({1, 1}, 10).size(), 1U);
  }
}

}  // namespace
}  // namespace nav2_navfn_planner
