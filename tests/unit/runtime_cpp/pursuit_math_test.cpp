// The formulas of regulated pure pursuit.
#include "pursuit_math.hpp"

#include <cmath>

#include "gtest/gtest.h"

namespace nav2_regulated_pure_pursuit_controller {
namespace {

TEST(PursuitMath, CurvatureOfTheArcToAPoint) {
  EXPECT_NEAR(curvature_to({0.6, 0.2}), 1.0, 1e-12);
  EXPECT_NEAR(curvature_to({0.6, -0.2}), -1.0, 1e-12);
  EXPECT_EQ(curvature_to({0.6, 0.0}), 0.0);
  EXPECT_EQ(curvature_to({0.0, 0.0}), 0.0);
  EXPECT_EQ(curvature_to({0.01, 0.02}), 0.0);
}

TEST(PursuitMath, CrossingOfACircle) {
  const PursuitPoint ahead = crossing({0.0, 0.0}, {2.0, 0.0}, 0.6);
  EXPECT_NEAR(ahead.x, 0.6, 1e-12);
  EXPECT_NEAR(ahead.y, 0.0, 1e-12);
  const PursuitPoint aside = crossing({0.3, 0.4}, {0.3, 2.0}, 1.0);
  EXPECT_NEAR(aside.x, 0.3, 1e-12);
  EXPECT_NEAR(aside.y, std::sqrt(1 - 0.09), 1e-12);
  // Backwards, through the middle.
  EXPECT_NEAR(crossing({0.5, 0.0}, {-2.0, 0.0}, 1.0).x, -1.0, 1e-12);
  EXPECT_EQ(crossing({0.5, 0.1}, {0.5, 0.1}, 1.0).x, 0.5);
}

TEST(PursuitMath, SlowerInTightTurns) {
  EXPECT_EQ(speed_on_arc(0.5, 1.0, 0.9), 0.5);
  EXPECT_NEAR(speed_on_arc(0.5, 1.0 / 0.45, 0.9), 0.25, 1e-12);
  EXPECT_NEAR(speed_on_arc(0.5, -1.0 / 0.45, 0.9), 0.25, 1e-12);
  EXPECT_EQ(speed_on_arc(0.5, 0.0, 0.9), 0.5);
}

TEST(PursuitMath, SlowerNearObstacles) {
  const CostRule rule{0.22, 3.0, 0.6, 1.0};
  EXPECT_EQ(speed_near_obstacles(0.5, 0, rule), 0.5);
  EXPECT_EQ(speed_near_obstacles(0.5, 255, rule), 0.5);
  // On the inscribed radius.
  EXPECT_NEAR(speed_near_obstacles(0.5, 253, rule), 0.5 * 0.22 / 0.6, 1e-9);
  // 0.5 m from the obstacle: 253 e^(-3 (0.5 - 0.22)).
  EXPECT_NEAR(speed_near_obstacles(0.5, 253 * std::exp(-0.84), rule), 0.5 * 0.5 / 0.6, 1e-9);
  EXPECT_EQ(speed_near_obstacles(0.5, 253 * std::exp(-3 * 0.4), rule), 0.5);
}

TEST(PursuitMath, SlowerNearTheGoal) {
  EXPECT_EQ(speed_of_approach(0.5, 2.0, 1.9, 0.6, 0.05), 0.5);
  EXPECT_NEAR(speed_of_approach(0.5, 0.3, 0.3, 0.6, 0.05), 0.25, 1e-12);
  EXPECT_EQ(speed_of_approach(0.5, 0.01, 0.01, 0.6, 0.05), 0.05);
  EXPECT_EQ(speed_of_approach(0.02, 0.01, 0.01, 0.6, 0.05), 0.02);
}

TEST(PursuitMath, TurnsAsFastAsItCanStop) {
  EXPECT_NEAR(speed_of_turn(1.5, 1.8, 1.8, 3.2, 0.05), 1.8, 1e-12);
  EXPECT_NEAR(speed_of_turn(-1.5, -1.8, 1.8, 3.2, 0.05), -1.8, 1e-12);
  EXPECT_NEAR(speed_of_turn(1.5, 0.0, 1.8, 3.2, 0.05), 0.16, 1e-12);
  EXPECT_NEAR(speed_of_turn(0.1, 1.8, 1.8, 3.2, 0.05), std::sqrt(2 * 3.2 * 0.1), 1e-12);
}

}  // namespace
}  // namespace nav2_regulated_pure_pursuit_controller
