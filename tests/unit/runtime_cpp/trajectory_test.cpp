// Trajectories of joint_trajectory_controller below ROS: splines, paths, tolerances, checks.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "joint_trajectory_controller/path.hpp"
#include "joint_trajectory_controller/tolerances.hpp"
#include "joint_trajectory_controller/trajectory_checks.hpp"

namespace {

using namespace joint_trajectory_controller;

constexpr int64_t kSecond = 1'000'000'000;

PathPoint point(double at_s, std::vector<double> positions, std::vector<double> velocities = {},
                std::vector<double> accelerations = {}) {
  PathPoint made;
  made.from_start_ns = static_cast<int64_t>(at_s * 1e9);
  made.positions = std::move(positions);
  made.velocities = std::move(velocities);
  made.accelerations = std::move(accelerations);
  return made;
}

TEST(Spline, IsLinearWithPositionsOnly) {
  const PathPoint now = interpolate(point(0, {1.0}), point(0, {3.0}), 0.5, 2.0);
  EXPECT_DOUBLE_EQ(now.positions[0], 1.5);
  EXPECT_DOUBLE_EQ(now.velocities[0], 1.0);
  EXPECT_DOUBLE_EQ(now.accelerations[0], 0.0);
}

TEST(Spline, IsCubicWithVelocities) {
  // From rest to rest over 2 in 2 s: 3 s^2 - 2 s^3 of the way, s = t / 2.
  const PathPoint now = interpolate(point(0, {1.0}, {0.0}), point(0, {3.0}, {0.0}), 0.5, 2.0);
  EXPECT_NEAR(now.positions[0], 1.0 + 2.0 * (3 * 0.0625 - 2 * 0.015625), 1e-12);
  EXPECT_NEAR(now.velocities[0], 6 * 0.25 * 0.75, 1e-12);
  EXPECT_NEAR(now.accelerations[0], 6 * (1 - 2 * 0.25) / 2.0, 1e-12);
}

TEST(Spline, IsQuinticWithAccelerations) {
  // From rest to rest: 10 s^3 - 15 s^4 + 6 s^5 of the way, half of it in the middle.
  const PathPoint a = point(0, {0.0}, {0.0}, {0.0});
  const PathPoint b = point(0, {4.0}, {0.0}, {0.0});
  EXPECT_NEAR(interpolate(a, b, 1.0, 2.0).positions[0], 2.0, 1e-12);
  EXPECT_NEAR(interpolate(a, b, 1.0, 2.0).velocities[0], 1.875 * 4.0 / 2.0, 1e-12);
  EXPECT_NEAR(interpolate(a, b, 1.0, 2.0).accelerations[0], 0.0, 1e-12);
  // The ends have what was asked for.
  const PathPoint c = point(0, {1.0}, {0.5}, {-0.25});
  const PathPoint d = point(0, {2.0}, {-1.0}, {0.75});
  const PathPoint end = interpolate(c, d, 3.0, 3.0);
  EXPECT_NEAR(end.positions[0], 2.0, 1e-9);
  EXPECT_NEAR(end.velocities[0], -1.0, 1e-9);
  EXPECT_NEAR(end.accelerations[0], 0.75, 1e-9);
}

TEST(Spline, DeducesPositionsFromDerivatives) {
  PathPoint a = point(0, {1.0});
  PathPoint b = point(0, {}, {}, {2.0});
  deduce_from_derivatives(a, b, 1, 2.0);
  EXPECT_DOUBLE_EQ(b.velocities[0], 2.0);  // (0 + 2) / 2 for 2 s
  EXPECT_DOUBLE_EQ(b.positions[0], 3.0);   // (0 + 2) / 2 for 2 s
  EXPECT_EQ(a.effort, std::vector<double>{0.0});
}

TEST(Spline, WrapsTheShorterWay) {
  std::vector<double> positions = {3.0, 3.0, 0.0};
  wrap_around(positions, {-3.0, -3.0, M_PI}, {true, false, true});
  EXPECT_NEAR(positions[0], -3.0 - (2 * M_PI - 6.0), 1e-12);
  EXPECT_EQ(positions[1], 3.0);
  EXPECT_NEAR(positions[2], 0.0, 1e-12) << "half a turn forwards";
  EXPECT_NEAR(position_error(-3.0, 3.0, true), 2 * M_PI - 6.0, 1e-12);
  EXPECT_EQ(position_error(-3.0, 3.0, false), -6.0);
}

std::shared_ptr<PathRequest> two_joints() {
  auto request = std::make_shared<PathRequest>();
  request->joints = {"j1", "j2"};
  request->points = {point(1.0, {1.0, -1.0}), point(2.0, {0.5, 0.5})};
  return request;
}

TEST(Path, GoesFromTheStateBeforeToEachPoint) {
  Path path;
  path.start(two_joints());
  const int64_t now = 7 * kSecond;
  path.set_point_before(now, point(0, {0.0, 0.0}), {});
  PathPoint wanted;
  const auto at = [&](double seconds) {
    return path.sample(now + static_cast<int64_t>(seconds * 1e9), Interpolation::kSplines, wanted);
  };
  ASSERT_TRUE(at(0.0));
  EXPECT_EQ(path.start_ns(), now);
  EXPECT_EQ(wanted.positions, (std::vector<double>{0.0, 0.0}));
  auto segment = at(0.5);
  EXPECT_EQ(segment->end, 0u) << "before the first point";
  EXPECT_NEAR(wanted.positions[0], 0.5, 1e-12);
  EXPECT_NEAR(wanted.positions[1], -0.5, 1e-12);
  segment = at(1.5);
  EXPECT_EQ(segment->begin, 0u);
  EXPECT_EQ(segment->end, 1u);
  EXPECT_FALSE(path.is_over(*segment));
  EXPECT_NEAR(wanted.positions[0], 0.75, 1e-12);
  EXPECT_NEAR(wanted.velocities[1], 1.5, 1e-12);
  segment = at(2.0);
  EXPECT_TRUE(path.is_over(*segment));
  EXPECT_EQ(wanted.positions, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(wanted.velocities, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(path.time_of(segment->begin), now + 2 * kSecond);
}

TEST(Path, WithoutInterpolationGoesToTheNextPointAtOnce) {
  Path path;
  path.start(two_joints());
  path.set_point_before(0, point(0, {0.25, 0.25}), {});
  PathPoint wanted;
  ASSERT_TRUE(path.sample(1, Interpolation::kNone, wanted));
  EXPECT_EQ(wanted.positions[0], 0.25);
  ASSERT_TRUE(path.sample(kSecond + 2, Interpolation::kNone, wanted));
  EXPECT_EQ(wanted.positions[0], 0.5);
}

TEST(Path, StartsAtItsTimeAndHasNothingBeforeTheState) {
  auto request = two_joints();
  request->start_ns = 10 * kSecond;
  Path path;
  path.start(request);
  path.set_point_before(9 * kSecond, point(0, {0.0, 0.0}), {});
  PathPoint wanted;
  EXPECT_FALSE(path.sample(8 * kSecond, Interpolation::kSplines, wanted));
  ASSERT_TRUE(path.sample(10 * kSecond, Interpolation::kSplines, wanted));
  EXPECT_NEAR(wanted.positions[0], 0.5, 1e-12) << "half of the two seconds to the first point";
}

TEST(Path, PointsWithVelocitiesOnlyAreIntegrated) {
  auto request = std::make_shared<PathRequest>();
  request->joints = {"j"};
  request->points = {point(0.0, {}, {0.0}), point(1.0, {}, {2.0}), point(2.0, {}, {0.0})};
  Path path;
  path.start(request);
  path.set_point_before(kSecond, point(0, {1.0}), {});
  PathPoint wanted;
  ASSERT_TRUE(path.sample(kSecond, Interpolation::kSplines, wanted));
  ASSERT_TRUE(path.sample(4 * kSecond, Interpolation::kSplines, wanted));
  EXPECT_NEAR(wanted.positions[0], 3.0, 1e-12);
}

TEST(Path, BrakesWithinTheGreatestDeceleration) {
  const PathRequest braking =
      braking_path({"j1", "j2"}, point(0, {1.0, 0.0}, {-1.0, 0.0}), {2.0, 1.0}, 0.125);
  ASSERT_EQ(braking.points.size(), 5u);  // 1 / 2 s in steps of 0.125 s
  EXPECT_NEAR(braking.points[2].positions[0], 1.0 - 0.25 + 2.0 * 0.0625 / 2.0, 1e-12);
  EXPECT_NEAR(braking.points[2].velocities[0], -0.5, 1e-12);
  EXPECT_NEAR(braking.points[2].accelerations[0], 2.0, 1e-12);
  EXPECT_NEAR(braking.points[4].positions[0], 0.75, 1e-12);  // v^2 / 2a
  EXPECT_EQ(braking.points[4].velocities[0], 0.0);
  EXPECT_EQ(braking.points[4].positions[1], 0.0);
}

TEST(Path, CompletesAndSortsJoints) {
  PathRequest request;
  request.joints = {"c", "a"};
  request.points = {point(1.0, {3.0, 1.0}, {0.3, 0.1})};
  complete_and_sort(request, {"a", "b", "c"}, {9.0, 2.0, 9.0});
  EXPECT_EQ(request.points[0].positions, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(request.points[0].velocities, (std::vector<double>{0.1, 0.0, 0.3}));
  EXPECT_TRUE(mapping({"a", "x"}, {"a", "b"}).empty());
}

TEST(Tolerances, OfTheGoalReplaceEraseOrKeepDefaults) {
  SegmentTolerances defaults(2);
  defaults.state_tolerance[0].position = 0.1;
  defaults.goal_state_tolerance[1] = {0.2, 0.01, 0.0};
  defaults.goal_time_tolerance = 1.0;
  GoalTolerances goal;
  goal.path = {{"j1", {-1.0, 0.5, 0.0}}};
  goal.goal = {{"j2", {0.0, -1.0, 0.0}}};
  goal.goal_time_s = 0.25;
  std::string problem;
  const auto active = segment_tolerances(defaults, goal, {"j1", "j2"}, problem);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(active.state_tolerance[0].position, 0.0);
  EXPECT_EQ(active.state_tolerance[0].velocity, 0.5);
  EXPECT_EQ(active.goal_state_tolerance[1].position, 0.2);
  EXPECT_EQ(active.goal_state_tolerance[1].velocity, 0.0);
  EXPECT_EQ(active.goal_time_tolerance, 0.25);
}

TEST(Tolerances, ThatAreIllegalLeaveTheDefaults) {
  const SegmentTolerances defaults(1);
  GoalTolerances goal;
  goal.path = {{"j1", {-2.0, 0.0, 0.0}}};
  goal.goal_time_s = 3.0;
  std::string problem;
  EXPECT_EQ(segment_tolerances(defaults, goal, {"j1"}, problem).goal_time_tolerance, 0.0);
  EXPECT_EQ(problem,
            "joint 'j1' specified in goal.path_tolerance has a invalid position tolerance. Using "
            "default tolerances.");
  goal.path = {{"other", {}}};
  segment_tolerances(defaults, goal, {"j1"}, problem);
  EXPECT_EQ(problem,
            "joint 'other' specified in goal.path_tolerance does not exist. Using default "
            "tolerances.");
}

TEST(Tolerances, OfZeroAreNotChecked) {
  const PathPoint error = point(0, {0.5}, {-0.2});
  EXPECT_TRUE(is_within(error, 0, {0.0, 0.0, 0.1}));
  EXPECT_TRUE(is_within(error, 0, {0.5, 0.2, 0.0}));
  EXPECT_FALSE(is_within(error, 0, {0.0, 0.1, 0.0}));
  const auto lines = explain(error, 0, {0.4, 0.3, 0.0});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "State tolerances failed for joint 0:");
  EXPECT_EQ(lines[1], "Position Error: 0.500000, Position Tolerance: 0.400000");
}

TEST(TrajectoryChecks, RefuseWhatCannotBeRun) {
  TrajectoryRules rules;
  rules.joints = {"j1", "j2"};
  rules.now_ns = 100 * kSecond;
  PathRequest good = *two_joints();
  EXPECT_EQ(why_refused(good, rules), "");

  PathRequest bad = good;
  bad.joints[1] = "j3";
  EXPECT_EQ(why_refused(bad, rules), "Incoming joint j3 doesn't match the controller's joints.");
  bad = good;
  bad.joints = {"j1"};
  EXPECT_EQ(why_refused(bad, rules),
            "Joints on incoming trajectory don't match the controller joints.");
  bad = good;
  bad.points[1].from_start_ns = kSecond;
  EXPECT_EQ(why_refused(bad, rules),
            "Time between points 0 and 1 is not strictly increasing, it is 1.000000 and 1.000000 "
            "respectively");
  bad = good;
  bad.points[1].velocities = {0.0, 0.5};
  EXPECT_EQ(why_refused(bad, rules),
            "Velocity of last trajectory point of joint j2 is not zero: 0.500000000000000");
  bad.points[1].velocities = {0.0};
  EXPECT_EQ(why_refused(bad, rules),
            "Mismatch between joint_names size (2) and velocities (1) at point #1.");
  bad = good;
  bad.start_ns = 97 * kSecond;
  EXPECT_EQ(why_refused(bad, rules),
            "Received trajectory with non-zero start time (97.000000) that ends in the past "
            "(99.000000)");
  bad = good;
  bad.points[0].effort = {1.0, 1.0};
  EXPECT_NE(why_refused(bad, rules), "");
  bad.points.clear();
  EXPECT_EQ(why_refused(bad, rules), "Empty trajectory received.");
}

TEST(TrajectoryChecks, MayAllowPartsAndIntegration) {
  TrajectoryRules rules;
  rules.joints = {"j1", "j2"};
  rules.allows_partial_joints = true;
  rules.allows_integration = true;
  PathRequest request;
  request.joints = {"j2"};
  request.points = {point(1.0, {}, {0.0})};
  EXPECT_EQ(why_refused(request, rules), "");
  request.points = {point(1.0, {})};
  EXPECT_EQ(why_refused(request, rules),
            "The given trajectory has no position, velocity, or acceleration points.");
  rules.allows_integration = false;
  EXPECT_EQ(why_refused(request, rules),
            "Mismatch between joint_names size (1) and positions (0) at point #0.");
}

}  // namespace
