// Whether particles find a robot that drives through a room, for several seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "amcl_room.hpp"
#include "nav2_amcl/angleutils.hpp"

namespace nav2_amcl {
namespace {

using amcl_room::Robot;
using amcl_room::room;
using amcl_room::scan_at;

struct Outcome {
  double distance;  // m
  double angle;     // rad
  size_t particles;
};

/// A robot, its laser and a filter that follows it. A seed repeats all of it.
struct Scene {
  Scene(std::uint64_t seed, const std::string& type, const FilterSettings& settings,
        const pf_vector_t& start)
      : world(seed * 1000 + 1),
        random(seed),
        map(room()),
        laser(make_laser_model(type, LaserSettings(), map, {})),
        filter(settings, random),
        robot(start, world) {
    motion.initialize(0.2, 0.2, 0.2, 0.2, 0.2);
  }

  void update() {
    const pf_vector_t now = robot.odometry();
    filter.move(motion, now, pf_vector_sub(now, before));
    before = now;
    const LaserData data = scan_at(*map, robot.pose(), 360, world);
    filter.measure([&](Particles& particles, bool is_converged) {
      return laser->weigh(data, particles, is_converged);
    });
    filter.resample(nullptr);
  }

  Outcome outcome() const {
    const pf_vector_t& found = filter.best_cluster()->mean;
    const pf_vector_t& truth = robot.pose();
    return {std::hypot(found.v[0] - truth.v[0], found.v[1] - truth.v[1]),
            std::abs(angleutils::angle_diff(found.v[2], truth.v[2])), filter.particles().size()};
  }

  Random world;
  Random random;
  std::shared_ptr<OccupancyMap> map;
  std::unique_ptr<LaserModel> laser;
  DifferentialMotionModel motion;
  ParticleFilter filter;
  Robot robot;
  pf_vector_t before{};
};

/// Begins 0.5 m and up to 0.1 rad off. Eleven steps of 0.25 m, with turns of 0.35 rad after the
/// third, seventh and eleventh.
Outcome localize(std::uint64_t seed, const std::string& type) {
  Scene scene(seed, type, FilterSettings(), {{2.0, 2.0, 0.3}});
  const double off = 2 * M_PI * scene.world.uniform();
  pf_matrix_t covariance{};
  covariance.m[0][0] = covariance.m[1][1] = 0.25;
  covariance.m[2][2] = 0.0685;
  scene.filter.reset(
      {{2.0 + 0.5 * std::cos(off), 2.0 + 0.5 * std::sin(off), 0.2 + 0.2 * scene.world.uniform()}},
      covariance);
  for (int step = 1; step <= 11; ++step) {
    scene.robot.drive(0.25);
    scene.update();
    if (step % 4 != 3) continue;
    scene.robot.turn(0.35);
    scene.update();
  }
  return scene.outcome();
}

// Upstream's filter has a mean error of 0.050 m and 0.043 rad in this scene over 60 seeds, and ours
// 0.049 m and 0.041 rad. One angle in 60 is near 0.1 rad, so one of ten may be above it.
TEST(AmclScene, FindsTheRobotForEachSeed) {
  double sum = 0.0;
  int turned = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Outcome outcome = localize(seed, "likelihood_field");
    EXPECT_LT(outcome.distance, 0.2) << seed;
    EXPECT_LT(outcome.angle, 0.15) << seed;
    EXPECT_GE(outcome.particles, 500U) << seed;
    EXPECT_LT(outcome.particles, 2000U) << seed;
    sum += outcome.distance;
    if (outcome.angle > 0.1) ++turned;
  }
  EXPECT_LT(sum / 10, 0.08);
  EXPECT_LE(turned, 1);
}

TEST(AmclScene, TheOtherModelsFindItToo) {
  for (const char* const type : {"beam", "likelihood_field_prob"}) {
    const Outcome outcome = localize(1, type);
    EXPECT_LT(outcome.distance, 0.2) << type;
    EXPECT_LT(outcome.angle, 0.15) << type;
  }
}

TEST(AmclScene, ASeedRepeats) {
  const Outcome first = localize(5, "likelihood_field");
  const Outcome second = localize(5, "likelihood_field");
  const Outcome other = localize(6, "likelihood_field");
  EXPECT_EQ(first.distance, second.distance);
  EXPECT_EQ(first.particles, second.particles);
  EXPECT_NE(first.distance, other.distance);
}

// The room looks much the same from the place that is opposite of its centre.
TEST(AmclScene, OfTwoPlacesTheOneThatFitsRemains) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Scene scene(seed, "likelihood_field", FilterSettings(), {{2.0, 1.0, 0.3}});
    int made = 0;
    scene.filter.reset([&made](Random& numbers) {
      const double x = 2.0 + 0.2 * numbers.gaussian();
      const double y = 1.0 + 0.2 * numbers.gaussian();
      const double yaw = 0.3 + 0.1 * numbers.gaussian();
      return ++made % 2 == 0 ? pf_vector_t{{x, y, yaw}}
                             : pf_vector_t{{8.0 - x, 6.0 - y, yaw + M_PI}};
    });
    ASSERT_EQ(scene.filter.clusters().size(), 2U);
    for (int step = 0; step < 16; ++step) {
      step % 4 == 3 ? scene.robot.turn(0.4) : scene.robot.drive(0.25);
      scene.update();
    }
    EXPECT_LT(scene.outcome().distance, 0.2) << seed;
    EXPECT_GT(scene.filter.best_cluster()->weight, 0.6) << seed;
  }
}

}  // namespace
}  // namespace nav2_amcl
