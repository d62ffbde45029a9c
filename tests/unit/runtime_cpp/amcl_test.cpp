// The parts of localization with particles: how many there are, how they move, and how scans weigh
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "amcl_room.hpp"
#include "nav2_amcl/angleutils.hpp"
#include "nav2_amcl/motion_model/omni_motion_model.hpp"
#include "nav2_amcl/pf/pf_pdf.hpp"

namespace nav2_amcl {
namespace {

using amcl_room::room;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

/// Angles are taken relative to `about`, so that turns by 2 pi do not count.
Moments moments(const Particles& particles, size_t axis, double about = 0.0) {
  double sum = 0.0;
  double squares = 0.0;
  for (const pf_sample_t& particle : particles) {
    const double value = particle.pose.v[axis];
    const double off = axis == 2 ? angleutils::angle_diff(value, about) : value - about;
    sum += off;
    squares += off * off;
  }
  const auto count = static_cast<double>(particles.size());
  const double mean = sum / count;
  return {about + mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

FilterSettings many(int count) {
  FilterSettings settings;
  settings.min_particles = count;
  settings.max_particles = count;
  return settings;
}

TEST(AmclFilter, BinsSetTheNumberOfParticles) {
  FilterSettings unlimited;
  unlimited.min_particles = 0;
  unlimited.max_particles = 1'000'000;
  const std::vector<std::pair<size_t, int>> numbers{{2, 20},   {10, 131},   {20, 250},
                                                    {50, 588}, {100, 1129}, {200, 2188}};
  for (const auto& [bins, count] : numbers) EXPECT_EQ(particles_needed(unlimited, bins), count);
  const FilterSettings usual;
  EXPECT_EQ(particles_needed(usual, 20), 500);
  EXPECT_EQ(particles_needed(usual, 100), 1129);
  EXPECT_EQ(particles_needed(usual, 200), 2000);
  EXPECT_EQ(particles_needed(usual, 0), 2000);
  EXPECT_EQ(particles_needed(usual, 1), 2000);
  FilterSettings exact;
  exact.error = 0.0;
  EXPECT_EQ(particles_needed(exact, 50), 2000);
  exact.error = kNaN;
  EXPECT_EQ(particles_needed(exact, 50), 2000);
}

TEST(AmclFilter, BinsThatTouchAreOneCluster) {
  PoseBins bins;
  for (const pf_vector_t& pose : std::vector<pf_vector_t>{
           {{0.1, 0.1, 0.01}}, {{0.2, 0.2, 0.02}}, {{0.6, 0.6, 0.2}}, {{2.0, 0.1, 0.01}}}) {
    bins.insert(pose);
  }
  EXPECT_EQ(bins.count(), 3U);
  EXPECT_EQ(bins.find_clusters(), 2);
  EXPECT_EQ(bins.cluster_of({{0.3, 0.3, 0.1}}), bins.cluster_of({{0.9, 0.9, 0.3}}));
  EXPECT_NE(bins.cluster_of({{0.3, 0.3, 0.1}}), bins.cluster_of({{2.1, 0.2, 0.1}}));
  // Yaw is a ring: a turn by 2 pi changes nothing, and -0.1 touches 0.1.
  bins.insert({{0.1, 0.1, 0.01 + 4 * M_PI}});
  EXPECT_EQ(bins.count(), 3U);
  bins.insert({{0.1, 0.1, -0.1}});
  EXPECT_EQ(bins.find_clusters(), 2);
  EXPECT_EQ(bins.cluster_of({{0.1, 0.1, -0.1}}), bins.cluster_of({{0.1, 0.1, 0.1}}));
  for (const double wrong : {kNaN, kInfinity, -kInfinity, 1e300, -1e300}) {
    bins.insert({{wrong, wrong, wrong}});
  }
  EXPECT_GT(bins.find_clusters(), 2);
}

TEST(AmclFilter, ResetFollowsTheCovariance) {
  Random random(1);
  ParticleFilter filter(many(20'000), random);
  pf_matrix_t covariance{};
  covariance.m[0][0] = 0.5;
  covariance.m[1][1] = 0.5;
  covariance.m[0][1] = covariance.m[1][0] = 0.4;
  covariance.m[2][2] = 0.04;
  filter.reset({{1.0, -2.0, 3.0}}, covariance);
  const PoseEstimate& whole = filter.whole();
  EXPECT_NEAR(whole.mean.v[0], 1.0, 0.02);
  EXPECT_NEAR(whole.mean.v[1], -2.0, 0.02);
  EXPECT_NEAR(whole.mean.v[2], 3.0, 0.01);
  EXPECT_NEAR(whole.covariance.m[0][0], 0.5, 0.02);
  EXPECT_NEAR(whole.covariance.m[0][1], 0.4, 0.02);
  EXPECT_NEAR(whole.covariance.m[1][1], 0.5, 0.02);
  EXPECT_NEAR(whole.covariance.m[2][2], 0.04, 0.002);
  covariance.m[0][0] = -1.0;
  covariance.m[2][2] = -1.0;
  filter.reset({{1.0, 2.0, 3.0}}, covariance);
  EXPECT_TRUE(std::isfinite(filter.whole().mean.v[0]));
  EXPECT_NEAR(filter.whole().covariance.m[2][2], 0.0, 1e-9);
}

TEST(AmclFilter, BestClusterIsTheHeaviest) {
  Random random(1);
  ParticleFilter filter(many(1'000), random);
  int made = 0;
  filter.reset([&made](Random&) {
    return ++made % 4 == 0 ? pf_vector_t{{5.0, 5.0, 0.0}} : pf_vector_t{{1.0, 1.0, M_PI}};
  });
  ASSERT_EQ(filter.clusters().size(), 2U);
  const PoseEstimate* const best = filter.best_cluster();
  EXPECT_NEAR(best->weight, 0.75, 1e-9);
  EXPECT_NEAR(best->mean.v[0], 1.0, 1e-9);
  EXPECT_NEAR(std::abs(best->mean.v[2]), M_PI, 1e-9);
  EXPECT_NEAR(filter.whole().mean.v[0], 2.0, 1e-9);
}

TEST(AmclFilter, ResamplingFollowsWeights) {
  Random random(1);
  ParticleFilter filter(many(10'000), random);
  int made = 0;
  filter.reset([&made](Random&) {
    return pf_vector_t{{static_cast<double>(++made % 2), 0.0, 0.0}};
  });
  EXPECT_FALSE(filter.is_converged());
  filter.measure([](Particles& particles, bool) {
    for (pf_sample_t& particle : particles) particle.weight *= particle.pose.v[0] > 0.5 ? 3.0 : 1.0;
    return true;
  });
  filter.resample(nullptr);
  EXPECT_NEAR(moments(filter.particles(), 0).mean, 0.75, 0.02);
  EXPECT_NEAR(filter.particles().front().weight, 1.0 / 10'000, 1e-12);
  filter.measure([](Particles& particles, bool) {
    for (pf_sample_t& particle : particles) particle.weight *= particle.pose.v[0];
    return true;
  });
  filter.resample(nullptr);
  EXPECT_EQ(moments(filter.particles(), 0).mean, 1.0);
  EXPECT_TRUE(filter.is_converged());
}

TEST(AmclFilter, WithoutLikelihoodAllWeightsAreEqual) {
  Random random(1);
  ParticleFilter filter(many(100), random);
  for (const double factor : {0.0, kNaN}) {
    filter.reset({{0.0, 0.0, 0.0}}, {});
    filter.measure([factor](Particles& particles, bool) {
      for (pf_sample_t& particle : particles) particle.weight *= factor;
      return true;
    });
    for (const pf_sample_t& particle : filter.particles()) EXPECT_EQ(particle.weight, 0.01);
  }
}

TEST(AmclFilter, RandomPosesComeWhenLikelihoodDrops) {
  FilterSettings settings = many(10'000);
  settings.alpha_slow = 0.001;
  settings.alpha_fast = 0.5;
  Random random(1);
  ParticleFilter filter(settings, random);
  filter.reset({{0.0, 0.0, 0.0}}, {});
  const auto measure = [&filter](double factor) {
    filter.measure([factor](Particles& particles, bool) {
      for (pf_sample_t& particle : particles) particle.weight *= factor;
      return true;
    });
  };
  const auto elsewhere = [](Random&) { return pf_vector_t{{9.0, 9.0, 0.0}}; };
  measure(1.0);
  filter.resample(elsewhere);
  EXPECT_EQ(moments(filter.particles(), 0).mean, 0.0);
  // The averages fall from 1 to 0.999 + 0.001 * 0.2 and to 0.6.
  measure(0.2);
  filter.resample(elsewhere);
  const double share = 1 - 0.6 / (1 - 0.001 * 0.8);
  EXPECT_NEAR(moments(filter.particles(), 0).mean, 9 * share, 0.1);
  const double before = moments(filter.particles(), 0).mean;
  measure(0.2);
  filter.resample(elsewhere);
  EXPECT_NEAR(moments(filter.particles(), 0).mean, before, 0.15);
}

TEST(AmclFilter, NoParticlesIsNoCrash) {
  Random random(1);
  ParticleFilter filter(many(0), random);
  filter.reset({{0.0, 0.0, 0.0}}, {});
  DifferentialMotionModel model;
  filter.move(model, {{1.0, 0.0, 0.0}}, {{1.0, 0.0, 0.0}});
  filter.measure([](Particles&, bool) { return true; });
  filter.resample(nullptr);
  EXPECT_EQ(filter.best_cluster(), nullptr);
}

/// Particles that all stood at a pose, after one move.
template <typename ModelT>
Particles moved(const pf_vector_t& from, const pf_vector_t& pose, const pf_vector_t& delta,
                const std::array<double, 5>& alphas) {
  Random random(7);
  ParticleFilter filter(many(40'000), random);
  filter.reset(from, {});
  ModelT model;
  model.initialize(alphas[0], alphas[1], alphas[2], alphas[3], alphas[4]);
  filter.move(model, pose, delta);
  return filter.particles();
}

void expect_moments(const Particles& particles, size_t axis, double mean, double deviation) {
  const Moments found = moments(particles, axis, mean);
  EXPECT_NEAR(found.mean, mean, 0.01) << "axis " << axis;
  EXPECT_NEAR(found.deviation, deviation, 0.02 * deviation + 1e-6) << "axis " << axis;
}

TEST(AmclMotion, DifferentialDrivesWithItsNoise) {
  // 1 m straight ahead in odometry; the particle looks along y.
  const pf_vector_t from{{3.0, 4.0, M_PI / 2}};
  const pf_vector_t pose{{1.0, 0.0, 0.0}};
  const auto still = moved<DifferentialMotionModel>(from, pose, pose, {0, 0, 0, 0, 0});
  expect_moments(still, 0, 3.0, 0.0);
  expect_moments(still, 1, 5.0, 0.0);
  // Translation gives a length of 1 +- sqrt(0.01) m and two turns of +- sqrt(0.0004) rad.
  const auto noisy =
      moved<DifferentialMotionModel>(from, pose, pose, {0.3, 0.0004, 0.01, 0.3, 0.3});
  expect_moments(noisy, 1, 5.0, 0.1);
  expect_moments(noisy, 0, 3.0, 0.02);
  expect_moments(noisy, 2, M_PI / 2, std::sqrt(2 * 0.0004));
  // Backward is as exact as forward: a way to the back needs no turns.
  const auto back = moved<DifferentialMotionModel>(from, {{-1.0, 0.0, 0.0}}, {{-1.0, 0.0, 0.0}},
                                                   {0.3, 0.0, 0.01, 0.3, 0.3});
  expect_moments(back, 1, 3.0, 0.1);
  expect_moments(back, 2, M_PI / 2, 0.0);
}

TEST(AmclMotion, DifferentialTurnsWithItsNoise) {
  // 5 mm are no direction, so 0.5 rad is the second turn.
  const auto particles = moved<DifferentialMotionModel>({{0, 0, 0}}, {{0.0, 0.005, 0.5}},
                                                        {{0.0, 0.005, 0.5}}, {0.04, 0, 0, 0.01, 0});
  expect_moments(particles, 2, 0.5, 0.1);     // sqrt(0.04 * 0.5^2)
  expect_moments(particles, 0, 0.005, 0.05);  // sqrt(0.01 * 0.5^2)
}

TEST(AmclMotion, OmnidirectionalDrivesSideways) {
  const pf_vector_t delta{{0.0, 1.0, 0.0}};  // to the left
  const pf_vector_t from{{0.0, 0.0, M_PI / 2}};
  const auto particles = moved<OmniMotionModel>(from, delta, delta, {0.5, 0.0025, 0.01, 0.5, 0.04});
  expect_moments(particles, 0, -1.0, 0.1);       // along the way: sqrt(0.01)
  expect_moments(particles, 1, 0.0, 0.2);        // across: sqrt(0.04)
  expect_moments(particles, 2, M_PI / 2, 0.05);  // sqrt(0.0025)
  const pf_vector_t turn{{0.0, 0.0, 1.0}};
  const auto turned = moved<OmniMotionModel>({{0, 0, 0}}, turn, turn, {0.04, 0, 0, 0.01, 0});
  expect_moments(turned, 2, 1.0, 0.2);
  expect_moments(turned, 0, 0.0, 0.1);
}

TEST(AmclMotion, RandomNumbersNeedAFilter) {
  EXPECT_THROW(pf_ran_gaussian(1.0), std::logic_error);
}

TEST(AmclMotion, AnglesTakeTheShortWay) {
  EXPECT_NEAR(angleutils::angle_diff(3.0, -3.0), 6.0 - 2 * M_PI, 1e-12);
  EXPECT_NEAR(angleutils::angle_diff(-3.0, 3.0), 2 * M_PI - 6.0, 1e-12);
  EXPECT_NEAR(angleutils::normalize(7.0), 7.0 - 2 * M_PI, 1e-12);
}

/// A map of one row, and one of its cells.
std::shared_ptr<OccupancyMap> map_of(int width, int height, const std::set<int>& occupied,
                                     double resolution = 0.1) {
  std::vector<CellState> cells(static_cast<size_t>(width * height), CellState::Free);
  for (const int cell : occupied) cells[static_cast<size_t>(cell)] = CellState::Occupied;
  return std::make_shared<OccupancyMap>(MapGeometry{width, height, resolution, -1.0, -2.0},
                                        std::move(cells));
}

TEST(AmclMap, PointsBelongToTheNearestCorner) {
  const auto map = map_of(10, 5, {});
  EXPECT_EQ(map->cell_at(-1.0, -2.0), 0U);
  EXPECT_EQ(map->cell_at(-0.96, -2.0), 0U);
  EXPECT_EQ(map->cell_at(-0.94, -1.86), 11U);
  EXPECT_EQ(map->cell_at(-1.06, -2.0), std::nullopt);
  EXPECT_EQ(map->cell_at(0.0, -2.0), std::nullopt);
  for (const double wrong : {kNaN, kInfinity, -1e300}) {
    EXPECT_EQ(map->cell_at(wrong, -2.0), std::nullopt);
  }
  EXPECT_NEAR(map->point_of(11).x, -0.9, 1e-12);
  EXPECT_NEAR(map->point_of(11).y, -1.9, 1e-12);
  EXPECT_EQ(map_of(3, 3, {4})->free_cells(1), (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6, 7, 8}));
  EXPECT_EQ(map_of(3, 3, {0})->free_cells(2), (std::vector<std::uint32_t>{2, 6, 8}));
}

TEST(AmclMap, DistancesAreThoseToTheNearestOccupiedCell) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    std::set<int> occupied;
    for (int i = 0; i < round; ++i) occupied.insert(static_cast<int>(random.uniform() * 30 * 20));
    const auto map = map_of(30, 20, occupied);
    map->measure_distances(1.0);
    for (int cell = 0; cell < 30 * 20; ++cell) {
      double expected = 1.0;
      for (const int other : occupied) {
        expected =
            std::min(expected, 0.1 * std::hypot(cell % 30 - other % 30, cell / 30 - other / 30));
      }
      ASSERT_NEAR(map->distance(static_cast<size_t>(cell)), expected, 1e-5) << round << " " << cell;
    }
  }
}

TEST(AmclMap, RangesEndAtWalls) {
  const auto map = room();
  EXPECT_NEAR(map->range(2.0, 2.0, 0.0, 10.0), 3.5, 0.051);  // the second block
  EXPECT_NEAR(map->range(2.0, 2.0, M_PI, 10.0), 2.0, 0.051);
  EXPECT_NEAR(map->range(2.5, 2.0, M_PI / 2, 10.0), 2.0, 0.051);  // the first block
  EXPECT_NEAR(map->range(2.0, 2.0, -3 * M_PI / 4, 10.0), 2 * std::sqrt(2.0), 0.08);
  EXPECT_EQ(map->range(2.0, 2.0, 0.0, 1.0), 1.0);
  EXPECT_EQ(map->range(-5.0, 2.0, 0.0, 10.0), 0.0);
  EXPECT_EQ(map->range(kNaN, 2.0, 0.0, 10.0), 0.0);
  EXPECT_EQ(map->range(2.0, 2.0, kNaN, 10.0), 10.0);
  EXPECT_NEAR(map->range(2.0, 2.0, 0.0, kInfinity), 3.5, 0.051);
}

/// The factor by which one scan changes the weight of a particle at a pose.
double factor(const std::string& type, const LaserSettings& settings, const LaserData& data,
              const std::shared_ptr<OccupancyMap>& map, const pf_vector_t& pose,
              const pf_vector_t& laser = {}) {
  Particles particles{{pose, 1.0}};
  EXPECT_TRUE(make_laser_model(type, settings, map, laser)->weigh(data, particles, false));
  return particles.front().weight;
}

/// A wall across the way in x, at 2.0 m.
std::shared_ptr<OccupancyMap> wall() {
  std::set<int> cells;
  for (int y = 0; y < 40; ++y) cells.insert(y * 50 + 30);
  return map_of(50, 40, cells);
}

TEST(AmclLaser, LikelihoodFieldFollowsItsFormula) {
  const LaserSettings settings;
  const auto p = [](double distance) {
    return 0.5 * std::exp(-distance * distance / (2 * 0.2 * 0.2)) + 0.5 / 10.0;
  };
  const auto cubes = [&p](std::initializer_list<double> distances) {
    double sum = 1.0;
    for (const double distance : distances) sum += std::pow(p(distance), 3);
    return sum;
  };
  const pf_vector_t at{{0.0, 0.0, 0.0}};
  const auto one = [&](double range, double bearing = 0.0) {
    return factor("likelihood_field", settings, {10.0, {{range, bearing}}}, wall(), at);
  };
  EXPECT_NEAR(one(2.0), cubes({0.0}), 1e-6);
  EXPECT_NEAR(one(1.7), cubes({0.3}), 1e-6);
  EXPECT_NEAR(one(1.7 * std::sqrt(2.0), M_PI / 4), cubes({0.3}), 1e-6);
  EXPECT_NEAR(one(9.0), cubes({2.0}), 1e-6);  // beyond the map: the greatest distance
  EXPECT_EQ(one(10.0), 1.0);
  EXPECT_EQ(one(kInfinity), 1.0);
  EXPECT_EQ(one(kNaN), 1.0);
  EXPECT_NEAR(one(1.0, kNaN), cubes({2.0}), 1e-6);
  EXPECT_EQ(factor("likelihood_field", settings, {10.0, {}}, wall(), at), 1.0);
  // The laser is 0.5 m ahead of a robot that looks to the left, away from the wall.
  EXPECT_NEAR(factor("likelihood_field", settings, {10.0, {{1.2, -M_PI / 2}}}, wall(),
                     {{0.5, 0.0, M_PI / 2}}, {{0.5, 0.0, 0.0}}),
              cubes({0.3}), 1e-6);
}

TEST(AmclLaser, EverySoManyBeamsAreUsed) {
  LaserSettings settings;
  settings.max_beams = 4;
  LaserData data{10.0, {}};
  for (int i = 0; i < 10; ++i) data.beams.push_back({i % 3 == 0 ? 2.0 : 1.0, 0.0});
  // (10 - 1) / (4 - 1): each third, and those fit.
  const double p = 0.5 + 0.5 / 10.0;
  EXPECT_NEAR(factor("likelihood_field", settings, data, wall(), {{0, 0, 0}}), 1 + 4 * p * p * p,
              1e-6);
  settings.max_beams = 1;
  Particles particles{{{{0, 0, 0}}, 1.0}};
  EXPECT_FALSE(
      make_laser_model("likelihood_field", settings, wall(), {})->weigh(data, particles, true));
  EXPECT_EQ(particles.front().weight, 1.0);
}

TEST(AmclLaser, ProbabilitiesAreMultiplied) {
  const LaserSettings settings;
  const double near = 0.5 + 0.05;
  const double far = 0.5 * std::exp(-0.09 / 0.08) + 0.05;
  const LaserData data{10.0, {{2.0, 0.0}, {1.7, 0.0}, {kNaN, 0.0}, {10.0, 0.0}}};
  EXPECT_NEAR(factor("likelihood_field_prob", settings, data, wall(), {{0, 0, 0}}), near * far,
              1e-6);
}

TEST(AmclLaser, BeamsThatMostParticlesDisagreeWithAreSkipped) {
  LaserSettings settings;
  settings.max_beams = 4;
  settings.do_beamskip = true;
  // The last beam ends at somebody, 1 m before the wall.
  const LaserData data{10.0, {{2.0, 0.0}, {2.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}}};
  const auto weight = [&](bool is_converged) {
    Particles particles(10, {{{0, 0, 0}}, 1.0});
    EXPECT_TRUE(make_laser_model("likelihood_field_prob", settings, wall(), {})
                    ->weigh(data, particles, is_converged));
    return particles.front().weight;
  };
  const double near = 0.5 + 0.05;
  const double far = 0.5 * std::exp(-1.0 / 0.08) + 0.05;
  EXPECT_NEAR(weight(true), near * near * near, 1e-6);
  EXPECT_NEAR(weight(false), near * near * near * far, 1e-6);
  // A quarter of the beams is too many: all count.
  settings.beam_skip_error_threshold = 0.25;
  EXPECT_NEAR(weight(true), near * near * near * far, 1e-6);
}

TEST(AmclLaser, BeamModelFollowsItsFormula) {
  const LaserSettings settings;
  const auto one = [&](double range) {
    return factor("beam", settings, {10.0, {{range, 0.0}}}, wall(), {{0, 0, 0}});
  };
  const auto cube = [](double p) { return 1 + p * p * p; };
  const auto hit = [](double error) { return 0.5 * std::exp(-error * error / 0.08); };
  EXPECT_NEAR(one(2.2), cube(hit(0.2) + 0.05), 1e-6);
  EXPECT_NEAR(one(1.5), cube(hit(0.5) + 0.05 * 0.1 * std::exp(-0.15) + 0.05), 1e-6);
  EXPECT_NEAR(one(10.0), cube(0.05), 1e-6);
  EXPECT_EQ(one(kNaN), 1.0);
  EXPECT_EQ(one(kInfinity), 1.0);
  EXPECT_EQ(factor("beam", settings, {10.0, {}}, wall(), {{0, 0, 0}}), 1.0);
}

}  // namespace
}  // namespace nav2_amcl
