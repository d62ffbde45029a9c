// The filters of robot_localization: motion, corrections, angles, control, and hostile values.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <memory>
#include <random>

#include "filter/ekf.hpp"
#include "filter/motion_model.hpp"
#include "filter/readings.hpp"
#include "filter/ukf.hpp"

namespace robot_localization {
namespace {

constexpr int64_t kSecond = 1'000'000'000;

Measurement measured(std::initializer_list<std::pair<int, double>> values, double variance,
                     int64_t time_ns) {
  Measurement result;
  result.time_ns = time_ns;
  for (const auto& [member, value] : values) {
    result.values(member) = value;
    result.covariance(member, member) = variance;
    result.update.set(member);
  }
  return result;
}

bool is_sound(const Covariance& covariance) {
  const bool is_symmetric = covariance.isApprox(covariance.transpose(), 0.0);
  const Eigen::SelfAdjointEigenSolver<Covariance> solver(covariance);
  return is_symmetric && solver.eigenvalues().minCoeff() > -1e-12 * solver.eigenvalues().maxCoeff();
}

/// A filter for each test of both kinds.
template <class T>
class LocalizationFilter : public testing::Test {
 protected:
  T filter;
};
using Kinds = testing::Types<Ekf, Ukf>;
TYPED_TEST_SUITE(LocalizationFilter, Kinds);

TYPED_TEST(LocalizationFilter, MovesAlongALine) {
  this->filter.process(measured({{kX, 1.0}, {kYaw, M_PI / 6}, {kVx, 2.0}, {kAx, 0.5}}, 1e-9, 0));
  this->filter.predict(3 * kSecond);
  const State& mean = this->filter.state().mean;
  const double way = 2.0 * 3.0 + 0.5 * 0.5 * 9.0;
  EXPECT_NEAR(mean(kX), 1.0 + way * std::cos(M_PI / 6), 1e-5);
  EXPECT_NEAR(mean(kY), way * 0.5, 1e-5);
  EXPECT_NEAR(mean(kVx), 3.5, 1e-6);
  EXPECT_EQ(this->filter.state().time_ns, 3 * kSecond);
}

TYPED_TEST(LocalizationFilter, AddsTheNoiseOfATime) {
  this->filter.process(measured({{kX, 0.0}}, 1e-9, 0));
  this->filter.predict(kSecond / 2);
  const Covariance& covariance = this->filter.state().covariance;
  EXPECT_NEAR(covariance(kX, kX), 0.05 * 0.5, 1e-6);
  EXPECT_NEAR(covariance(kVyaw, kVyaw), 0.02 * 0.5, 1e-6);
  EXPECT_NEAR(covariance(kAz, kAz), 0.015 * 0.5, 1e-6);
}

TYPED_TEST(LocalizationFilter, TakesAnExactMeasurementExactly) {
  this->filter.process(measured({{kX, 5.0}, {kPitch, 0.2}}, 1e-9, 0));
  EXPECT_EQ(this->filter.state().mean(kX), 5.0);
  this->filter.process(measured({{kX, -3.0}, {kPitch, -0.1}}, 1e-9, kSecond));
  EXPECT_NEAR(this->filter.state().mean(kX), -3.0, 1e-3);
  EXPECT_NEAR(this->filter.state().mean(kPitch), -0.1, 1e-3);
}

TYPED_TEST(LocalizationFilter, WeighsByCovariances) {
  this->filter.process(measured({{kX, 0.0}}, 1.0, 0));
  EXPECT_TRUE(this->filter.correct(measured({{kX, 3.0}}, 2.0, 0)));
  EXPECT_NEAR(this->filter.state().mean(kX), 1.0, 1e-9);
  EXPECT_NEAR(this->filter.state().covariance(kX, kX), 2.0 / 3.0, 1e-9);
}

TYPED_TEST(LocalizationFilter, StaysSymmetricAndPositive) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  this->filter.process(measured({{kX, 0.0}, {kYaw, 0.0}}, 1e-3, 0));
  for (int step = 1; step <= 3000; ++step) {
    Measurement measurement;
    measurement.time_ns = step * kSecond / 50;
    for (int i = 0; i < kStateSize; ++i) {
      if (random() % 3 != 0) continue;
      measurement.update.set(i);
      measurement.values(i) = 0.3 * noise(random);
      measurement.covariance(i, i) = std::exp(4.0 * noise(random) - 4.0);
    }
    this->filter.process(measurement);
    ASSERT_TRUE(this->filter.state().covariance.allFinite()) << step;
    ASSERT_TRUE(is_sound(this->filter.state().covariance)) << step;
  }
}

TYPED_TEST(LocalizationFilter, TurnsTheShortWay) {
  this->filter.process(measured({{kYaw, 3.1}}, 0.1, 0));
  this->filter.correct(measured({{kYaw, -3.1}}, 0.1, 0));
  EXPECT_NEAR(std::abs(this->filter.state().mean(kYaw)), M_PI, 1e-9);
  this->filter.process(measured({{kVyaw, 1.0}}, 1e-9, 0));
  this->filter.predict(kSecond);
  EXPECT_LE(std::abs(this->filter.state().mean(kYaw)), M_PI);
}

TYPED_TEST(LocalizationFilter, RejectsWhatIsTooFarOff) {
  this->filter.process(measured({{kX, 0.0}, {kY, 0.0}}, 1.0, 0));
  // The deviation of the difference is 2, so 4 m are 2 deviations.
  Measurement measurement = measured({{kX, 4.0}}, 3.0, 0);
  measurement.rejection_threshold = 1.99;
  EXPECT_FALSE(this->filter.correct(measurement));
  EXPECT_EQ(this->filter.state().mean(kX), 0.0);
  measurement.rejection_threshold = 2.01;
  EXPECT_TRUE(this->filter.correct(measurement));
  EXPECT_NEAR(this->filter.state().mean(kX), 1.0, 1e-9);
}

TYPED_TEST(LocalizationFilter, LeavesOutWhatIsNotFinite) {
  const double nan = std::nan("");
  const double infinite = std::numeric_limits<double>::infinity();
  this->filter.process(measured({{kX, nan}}, 1.0, 5));
  EXPECT_FALSE(this->filter.state().is_initialized);
  this->filter.process(measured({{kX, nan}, {kY, 2.0}}, 1.0, 5));
  EXPECT_TRUE(this->filter.state().is_initialized);
  EXPECT_EQ(this->filter.state().mean(kX), 0.0);
  EXPECT_EQ(this->filter.state().mean(kY), 2.0);
  EXPECT_FALSE(this->filter.correct(measured({{kX, infinite}}, 1.0, 5)));
  EXPECT_FALSE(this->filter.correct(measured({{kX, 1.0}}, nan, 5)));
  EXPECT_FALSE(this->filter.correct(measured({{kX, 1.0}}, infinite, 5)));
  Measurement odd = measured({{kX, 1.0}, {kY, 2.0}}, 1.0, 5);
  odd.covariance(kX, kY) = nan;
  odd.rejection_threshold = nan;
  EXPECT_FALSE(this->filter.correct(odd));
  odd.rejection_threshold = 10.0;
  EXPECT_TRUE(this->filter.correct(odd));
  EXPECT_TRUE(this->filter.state().mean.allFinite());
  EXPECT_TRUE(is_sound(this->filter.state().covariance));
}

TYPED_TEST(LocalizationFilter, MakesBadVariancesPositive) {
  this->filter.process(measured({{kX, 0.0}}, 1.0, 0));
  EXPECT_TRUE(this->filter.correct(measured({{kX, 3.0}}, -2.0, 0)));
  EXPECT_NEAR(this->filter.state().mean(kX), 1.0, 1e-9);
  EXPECT_TRUE(this->filter.correct(measured({{kX, 4.0}}, 0.0, 0)));
  EXPECT_NEAR(this->filter.state().mean(kX), 4.0, 1e-6);
  // No two variables can vary together more than each does by itself.
  Measurement odd = measured({{kX, 1.0}, {kY, 2.0}}, 1.0, 0);
  odd.covariance(kX, kY) = odd.covariance(kY, kX) = -500.0;
  EXPECT_TRUE(this->filter.correct(odd));
  EXPECT_TRUE(is_sound(this->filter.state().covariance));
}

TYPED_TEST(LocalizationFilter, SurvivesAVerticalPitchAndALongGap) {
  this->filter.process(measured({{kPitch, M_PI / 2}, {kVyaw, 0.1}, {kVx, 1.0}}, 1e-6, 0));
  this->filter.predict(kSecond / 10);
  EXPECT_TRUE(this->filter.state().mean.allFinite());
  EXPECT_TRUE(this->filter.state().covariance.allFinite());
  this->filter.predict(2'000'000'000 * kSecond);
  this->filter.process(measured({{kX, 1.0}, {kYaw, 0.0}}, 1e-6, 2'000'000'001 * kSecond));
  EXPECT_TRUE(this->filter.state().mean.allFinite());
}

TYPED_TEST(LocalizationFilter, OnlyCorrectsWithAnOlderMeasurement) {
  this->filter.process(measured({{kX, 0.0}}, 1.0, kSecond));
  this->filter.process(measured({{kX, 2.0}}, 1.0, kSecond / 2));
  EXPECT_NEAR(this->filter.state().mean(kX), 1.0, 1e-9);
  EXPECT_EQ(this->filter.state().time_ns, kSecond);
}

TYPED_TEST(LocalizationFilter, ScalesTheNoiseWithTheSpeed) {
  this->filter.set_dynamic_process_noise(true);
  this->filter.process(measured({{kX, 0.0}}, 1e-9, 0));
  this->filter.predict(kSecond);
  EXPECT_LT(this->filter.state().covariance(kX, kX), 1e-6) << "it stands";
  EXPECT_NEAR(this->filter.state().covariance(kVx, kVx), 0.025, 1e-6);
}

TYPED_TEST(LocalizationFilter, FollowsTheControl) {
  ControlModel model;
  model.axes.set(0);
  model.axes.set(5);
  model.timeout_ns = 100 * kSecond;
  model.acceleration_limits = {1.3, 0, 0, 0, 0, 3.4};
  model.deceleration_limits = {0.4, 0, 0, 0, 0, 4.5};
  model.acceleration_gains = {0.8, 0, 0, 0, 0, 0.9};
  model.deceleration_gains = {1.0, 0, 0, 0, 0, 1.0};
  this->filter.set_control_model(model);
  Control control;
  control.velocity << 5.0, 7.0, 0, 0, 0, 1.0;
  this->filter.set_control(control);
  this->filter.process(measured({{kX, 0.0}}, 1e-9, 0));
  this->filter.predict(kSecond / 10);
  EXPECT_NEAR(this->filter.state().mean(kAx), 1.3, 1e-6) << "limited";
  EXPECT_NEAR(this->filter.state().mean(kVx), 0.13, 1e-6);
  EXPECT_NEAR(this->filter.state().mean(kVyaw), 0.09, 1e-6) << "by its gain";
  EXPECT_NEAR(this->filter.state().mean(kVy), 0.0, 1e-6) << "not controlled";
  // An old control is a stop.
  model.timeout_ns = kSecond / 10;
  this->filter.set_control_model(model);
  this->filter.predict(2 * kSecond / 10);
  EXPECT_NEAR(this->filter.state().mean(kAx), -0.13, 1e-6);
}

TEST(LocalizationMotion, HasTheDerivativeOfItsMotion) {
  State state;
  state << 1, 2, 3, 0.4, -0.5, 2.6, 1.1, -0.7, 0.3, 0.2, -0.4, 0.9, 0.5, -0.6, 0.8;
  const double dt = 0.1;
  const double step = 1e-6;
  Covariance numeric;
  for (int i = 0; i < kStateSize; ++i) {
    const State offset = State::Unit(i) * step;
    numeric.col(i) = (advanced(state + offset, dt) - advanced(state - offset, dt)) / (2.0 * step);
  }
  EXPECT_LT((numeric - advance_jacobian(state, dt)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(LocalizationUkf, AgreesWithTheEkfOnACircle) {
  Ekf ekf;
  Ukf ukf;
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  const double turn = 0.5;
  for (int step = 0; step <= 600; ++step) {
    const double time = step / 30.0;
    const int64_t time_ns = step * kSecond / 30;
    Measurement odometry =
        measured({{kVx, 1.0 + 0.05 * noise(random)}, {kVy, 0.0}}, 0.0025, time_ns);
    const Measurement imu = measured(
        {{kYaw, wrapped(turn * time + 0.02 * noise(random))}, {kVyaw, turn + 0.02 * noise(random)}},
        0.0004, time_ns);
    for (Filter* filter : {static_cast<Filter*>(&ekf), static_cast<Filter*>(&ukf)}) {
      force_two_d(odometry);
      filter->process(odometry);
      filter->process(imu);
    }
    EXPECT_LT((ekf.state().mean - ukf.state().mean).head<2>().norm(), 0.02) << time;
  }
  // The truth is a circle of 2 m.
  const double angle = turn * 20.0;
  EXPECT_NEAR(ekf.state().mean(kX), 2.0 * std::sin(angle), 0.1);
  EXPECT_NEAR(ekf.state().mean(kY), 2.0 - 2.0 * std::cos(angle), 0.1);
  EXPECT_NEAR(wrapped(ekf.state().mean(kYaw) - angle), 0.0, 0.05);
  EXPECT_NEAR(wrapped(ukf.state().mean(kYaw) - angle), 0.0, 0.05);
  EXPECT_NEAR(ekf.state().covariance(kX, kX) / ukf.state().covariance(kX, kX), 1.0, 0.02);
}

TEST(LocalizationUkf, ShortensAWayWhoseDirectionIsUncertain) {
  // The mean of cos(yaw) is exp(-variance / 2); an EKF has 1 there.
  Ukf ukf;
  ukf.process(measured({{kX, 0.0}, {kYaw, 0.0}, {kVx, 1.0}}, 1e-9, 0));
  FilterState state = ukf.state();
  state.covariance(kYaw, kYaw) = 0.04;
  ukf.restore(state);
  ukf.predict(kSecond);
  EXPECT_NEAR(ukf.state().mean(kX), std::exp(-0.02), 5e-4);
}

TEST(LocalizationUkf, RefusesPointsWithoutASpread) {
  Ukf ukf;
  EXPECT_TRUE(ukf.set_constants(0.001, 0.0, 2.0));
  EXPECT_FALSE(ukf.set_constants(0.0, 0.0, 2.0));
  EXPECT_FALSE(ukf.set_constants(0.1, -15.0, 2.0));
  EXPECT_FALSE(ukf.set_constants(std::nan(""), 0.0, 2.0));
}

}  // namespace
}  // namespace robot_localization
