// The order of measurements, and what readings of sensors become in the frames of a filter.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "filter/ekf.hpp"
#include "filter/estimator.hpp"
#include "filter/readings.hpp"
#include "geo/world_frame.hpp"

namespace robot_localization {
namespace {

constexpr int64_t kMillisecond = 1'000'000;

Measurement speed_at(int64_t time_ns, double forward, double turning) {
  Measurement result;
  result.time_ns = time_ns;
  result.values(kVx) = forward;
  result.values(kVyaw) = turning;
  for (const int member : {kVx, kVyaw}) {
    result.update.set(member);
    result.covariance(member, member) = 0.01;
  }
  return result;
}

/// Measurements every 20 ms for two seconds.
std::vector<Measurement> drive() {
  std::mt19937 random(11);
  std::normal_distribution<double> noise;
  std::vector<Measurement> result;
  for (int i = 0; i < 100; ++i) {
    result.push_back(speed_at((20 * i + 20) * kMillisecond, 1.0 + 0.1 * noise(random),
                              0.4 + 0.1 * noise(random)));
  }
  return result;
}

EstimatorSettings smoothing() {
  return {.smooth_lagged_data = true, .history_length_ns = 1000 * kMillisecond};
}

TEST(LocalizationEstimator, TakesLateMeasurementsAsIfTheyHadComeInOrder) {
  Estimator ordered(std::make_unique<Ekf>());
  Estimator delayed(std::make_unique<Ekf>());
  Estimator without_history(std::make_unique<Ekf>());
  for (Estimator* estimator : {&ordered, &delayed}) estimator->set_settings(smoothing());
  const std::vector<Measurement> measurements = drive();
  for (const Measurement& measurement : measurements) {
    ordered.add(measurement);
    ordered.integrate(measurement.time_ns);
  }
  // Every third comes 140 ms late.
  std::vector<std::pair<int64_t, Measurement>> arrivals;
  for (size_t i = 0; i < measurements.size(); ++i) {
    const bool is_late = i % 3 == 1 && i + 8 < measurements.size();
    arrivals.emplace_back(measurements[i].time_ns + (is_late ? 140 : 0) * kMillisecond,
                          measurements[i]);
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const auto& left, const auto& right) { return left.first < right.first; });
  for (const auto& [now_ns, measurement] : arrivals) {
    for (Estimator* estimator : {&delayed, &without_history}) {
      estimator->add(measurement);
      estimator->integrate(now_ns);
    }
  }
  EXPECT_EQ(delayed.state().time_ns, ordered.state().time_ns);
  EXPECT_EQ(delayed.state().mean, ordered.state().mean);
  EXPECT_EQ(delayed.state().covariance, ordered.state().covariance);
  EXPECT_NE(without_history.state().mean, ordered.state().mean);
}

TEST(LocalizationEstimator, GoesBackToTheOldestStateOfAShortHistory) {
  Estimator estimator(std::make_unique<Ekf>());
  estimator.set_settings({.smooth_lagged_data = true, .history_length_ns = 100 * kMillisecond});
  for (const Measurement& measurement : drive()) {
    estimator.add(measurement);
    estimator.integrate(measurement.time_ns);
  }
  const State before = estimator.state().mean;
  estimator.add(speed_at(5 * kMillisecond, 1.0, 0.4));
  estimator.integrate(2001 * kMillisecond);
  EXPECT_EQ(estimator.state().time_ns, 2000 * kMillisecond);
  EXPECT_LT((estimator.state().mean - before).norm(), 0.1);
  EXPECT_NE(estimator.state().mean, before);
}

TEST(LocalizationEstimator, WaitsForTheTimeOfAMeasurement) {
  Estimator estimator(std::make_unique<Ekf>());
  estimator.add(speed_at(50 * kMillisecond, 1.0, 0.0));
  estimator.integrate(49 * kMillisecond);
  EXPECT_FALSE(estimator.state().is_initialized);
  estimator.integrate(50 * kMillisecond);
  EXPECT_TRUE(estimator.state().is_initialized);
}

TEST(LocalizationEstimator, PredictsAfterTheTimeoutOrAlways) {
  Estimator estimator(std::make_unique<Ekf>());
  estimator.set_settings({.sensor_timeout_ns = 100 * kMillisecond});
  estimator.add(speed_at(10 * kMillisecond, 2.0, 0.0));
  estimator.integrate(20 * kMillisecond);
  EXPECT_EQ(estimator.state().time_ns, 10 * kMillisecond);
  estimator.integrate(109 * kMillisecond);
  EXPECT_EQ(estimator.state().time_ns, 10 * kMillisecond);
  estimator.integrate(110 * kMillisecond);
  EXPECT_EQ(estimator.state().time_ns, 110 * kMillisecond);
  EXPECT_NEAR(estimator.state().mean(kX), 0.2, 1e-9);
  estimator.set_settings({.predict_to_current_time = true});
  estimator.integrate(111 * kMillisecond);
  EXPECT_EQ(estimator.state().time_ns, 111 * kMillisecond);
}

TEST(LocalizationEstimator, ReplaysTheControlOfThatTime) {
  ControlModel model;
  model.axes.set(0);
  model.timeout_ns = 10'000 * kMillisecond;
  model.acceleration_limits[0] = model.deceleration_limits[0] = 100.0;
  model.acceleration_gains[0] = model.deceleration_gains[0] = 1.0;
  const auto run = [&model](bool is_second_late) {
    Estimator estimator(std::make_unique<Ekf>());
    estimator.set_settings(smoothing());
    estimator.filter().set_control_model(model);
    std::vector<Measurement> all;
    for (int i = 1; i <= 3; ++i) {
      Measurement measurement = speed_at(i * 100 * kMillisecond, 0.0, 0.0);
      measurement.update.reset(kVx);
      measurement.control.velocity(0) = i;
      all.push_back(measurement);
    }
    if (is_second_late) std::swap(all[1], all[2]);
    int64_t now_ns = 0;
    for (const Measurement& measurement : all) {
      now_ns = std::max(now_ns, measurement.time_ns);
      estimator.filter().set_control(measurement.control);
      estimator.add(measurement);
      estimator.integrate(now_ns);
    }
    EXPECT_EQ(estimator.state().control.velocity(0), all.back().control.velocity(0));
    return estimator.state().mean;
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(LocalizationEstimator, BoundsItsMemory) {
  Estimator estimator(std::make_unique<Ekf>());
  for (size_t i = 0; i < Estimator::kMostEntries; ++i) {
    EXPECT_TRUE(estimator.add(speed_at(int64_t{1} << 60, 1.0, 0.0)));
  }
  // The one that is furthest ahead is dropped, so that a clock that is wrong stops no others.
  EXPECT_FALSE(estimator.add(speed_at(1, 1.0, 0.0)));
  estimator.integrate(2);
  EXPECT_EQ(estimator.state().time_ns, 1);
  EXPECT_EQ(estimator.state().mean(kVx), 1.0);
  EXPECT_TRUE(estimator.add(speed_at(3, 1.0, 0.0)));
  EXPECT_FALSE(estimator.add(speed_at(4, 1.0, 0.0)));
  estimator.clear();
  EXPECT_TRUE(estimator.add(speed_at(1, 1.0, 0.0)));
}

TEST(LocalizationEstimator, PredictsWhileMeasurementsOfTheFutureWait) {
  Estimator estimator(std::make_unique<Ekf>());
  estimator.set_settings({.sensor_timeout_ns = 100 * kMillisecond});
  estimator.add(speed_at(10 * kMillisecond, 2.0, 0.0));
  estimator.add(speed_at(int64_t{1} << 60, 2.0, 0.0));
  estimator.integrate(10 * kMillisecond);
  estimator.integrate(510 * kMillisecond);
  EXPECT_EQ(estimator.state().time_ns, 510 * kMillisecond);
  EXPECT_NEAR(estimator.state().mean(kX), 1.0, 1e-9);
}

Eigen::Isometry3d pose_of(double x, double y, double yaw) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << x, y, 0.0;
  result.linear() = quaternion_of(0, 0, yaw).toRotationMatrix();
  return result;
}

Measurement with(std::initializer_list<int> members, int64_t time_ns = 0) {
  Measurement result;
  result.time_ns = time_ns;
  for (const int member : members) result.update.set(member);
  return result;
}

TEST(LocalizationReadings, TurnsAPoseIntoTheWorld) {
  PoseReading reading;
  reading.pose = pose_of(1.0, 0.0, 0.1);
  reading.covariance.diagonal() << 1, 2, 3, 4, 5, 6;
  reading.target_from_message = pose_of(10.0, 20.0, M_PI / 2);
  Measurement measurement = with({kX, kYaw});
  PoseSource source;
  ASSERT_TRUE(source.take(reading, {}, measurement));
  EXPECT_NEAR(measurement.values(kX), 10.0, 1e-12);
  EXPECT_NEAR(measurement.values(kY), 21.0, 1e-12);
  EXPECT_NEAR(measurement.values(kYaw), M_PI / 2 + 0.1, 1e-12);
  // The x of the sensor is the y of the world.
  EXPECT_FALSE(measurement.update[kX]);
  EXPECT_TRUE(measurement.update[kY]);
  EXPECT_TRUE(measurement.update[kYaw]);
  EXPECT_NEAR(measurement.covariance(kY, kY), 1.0, 1e-12);
  EXPECT_NEAR(measurement.covariance(kYaw, kYaw), 6.0, 1e-12);
}

TEST(LocalizationReadings, TakesTheFirstPoseAsZero) {
  PoseSource source;
  PoseReading reading;
  reading.is_relative = true;
  reading.pose = pose_of(5.0, 5.0, M_PI / 2);
  Measurement first = with({kX, kY, kYaw});
  ASSERT_TRUE(source.take(reading, {}, first));
  EXPECT_LT(first.values.norm(), 1e-12);
  reading.pose = pose_of(5.0, 7.0, M_PI);
  Measurement second = with({kX, kY, kYaw});
  ASSERT_TRUE(source.take(reading, {}, second));
  EXPECT_NEAR(second.values(kX), 2.0, 1e-12);
  EXPECT_NEAR(second.values(kY), 0.0, 1e-12);
  EXPECT_NEAR(second.values(kYaw), M_PI / 2, 1e-12);
}

TEST(LocalizationReadings, MakesVelocitiesOfDifferences) {
  PoseSource source;
  PoseReading reading;
  reading.is_differential = true;
  reading.covariance.diagonal().setConstant(0.5);
  reading.pose = pose_of(1.0, 1.0, M_PI / 2);
  Measurement first = with({kX, kY, kYaw}, 0);
  EXPECT_FALSE(source.take(reading, {}, first));
  reading.pose = pose_of(1.0, 1.2, M_PI / 2 + 0.05);
  Measurement second = with({kX, kYaw}, 100 * kMillisecond);
  ASSERT_TRUE(source.take(reading, {}, second));
  EXPECT_NEAR(second.values(kVx), 2.0, 1e-9);
  EXPECT_NEAR(second.values(kVy), 0.0, 1e-9);
  EXPECT_NEAR(second.values(kVyaw), 0.5, 1e-9);
  EXPECT_NEAR(second.covariance(kVx, kVx), 0.1, 1e-12);
  EXPECT_EQ(second.update, with({kVx, kVyaw}).update);
  Measurement same_time = with({kX}, 100 * kMillisecond);
  EXPECT_FALSE(source.take(reading, {}, same_time)) << "no velocity without a time between";
}

TEST(LocalizationReadings, FollowsTheFrameThatAPoseIsOf) {
  // A camera 0.5 m in front of the base, which looks back.
  PoseReading reading;
  reading.child_from_base = pose_of(0.5, 0.0, M_PI).inverse();
  reading.pose = pose_of(3.0, 0.0, M_PI);
  Measurement measurement = with({kX, kY, kYaw});
  PoseSource source;
  ASSERT_TRUE(source.take(reading, {}, measurement));
  EXPECT_NEAR(measurement.values(kX), 2.5, 1e-12);
  EXPECT_NEAR(measurement.values(kYaw), 0.0, 1e-12);
}

TEST(LocalizationReadings, TakesOffTheMountingOfAnImu) {
  PoseReading reading;
  reading.is_imu = true;
  reading.target_from_message = pose_of(0.3, 0.0, M_PI / 2);
  // Mounted a quarter turn to the left: its pitch is the roll of the robot.
  reading.pose.linear() = quaternion_of(0.0, -0.1, 1.0 + M_PI / 2).toRotationMatrix();
  Measurement measurement = with({kPitch, kYaw});
  PoseSource source;
  ASSERT_TRUE(source.take(reading, {}, measurement));
  EXPECT_NEAR(measurement.values(kRoll), 0.1, 1e-12);
  EXPECT_NEAR(measurement.values(kPitch), 0.0, 1e-12);
  EXPECT_NEAR(measurement.values(kYaw), 1.0, 1e-12);
  EXPECT_EQ(measurement.update, with({kRoll, kYaw}).update);
}

TEST(LocalizationReadings, TakesOffWhatATurnAddsToAnOffsetSensor) {
  TwistReading twist;
  twist.base_from_sensor = pose_of(0.0, 0.5, 0.0);
  // On a base that turns on the spot, this sensor moves backwards.
  twist.linear << -1.0, 0.0, 0.0;
  twist.angular << 0.0, 0.0, 2.0;
  Turning turning;
  turning.velocity << 0.0, 0.0, 2.0;
  Measurement measurement = with({kVx, kVyaw});
  take_twist(twist, turning, measurement);
  EXPECT_NEAR(measurement.values(kVx), 0.0, 1e-12);
  EXPECT_NEAR(measurement.values(kVyaw), 2.0, 1e-12);

  AccelerationReading acceleration;
  acceleration.base_from_sensor = twist.base_from_sensor;
  turning.acceleration << 0.0, 0.0, 3.0;
  // Towards the centre by the square of the turn, and along the circle by its change.
  acceleration.acceleration << -1.5, -2.0, 9.8;
  acceleration.gravity = gravity_in(Eigen::Matrix3d::Identity(), 9.8);
  Measurement accelerated = with({kAx, kAy, kAz});
  take_acceleration(acceleration, turning, accelerated);
  EXPECT_LT(accelerated.values.norm(), 1e-12);
}

TEST(LocalizationReadings, RemovesGravityOfATiltedImu) {
  const Eigen::Matrix3d base_from_sensor = quaternion_of(0.0, M_PI / 2, 0.0).toRotationMatrix();
  const Eigen::Matrix3d world_from_base = quaternion_of(0.2, -0.3, 1.0).toRotationMatrix();
  AccelerationReading reading;
  reading.base_from_sensor.linear() = base_from_sensor;
  reading.gravity = gravity_in(world_from_base * base_from_sensor, 9.8);
  const Eigen::Vector3d own(0.5, 0.0, 0.1);  // of the base
  reading.acceleration = base_from_sensor.transpose() *
                         (own + world_from_base.transpose() * Eigen::Vector3d(0, 0, 9.8));
  Measurement measurement = with({kAx, kAy, kAz});
  take_acceleration(reading, {}, measurement);
  EXPECT_LT((measurement.values.segment<3>(kAx) - own).norm(), 1e-12);
}

TEST(LocalizationReadings, LeavesOutWhatIsNotFinite) {
  const double nan = std::nan("");
  TwistReading twist;
  twist.linear << 1.0, nan, 2.0;
  twist.covariance.diagonal() << 1, 1, nan, 1, 1, 1;
  twist.covariance(0, 5) = nan;
  twist.base_from_sensor = pose_of(0.0, 0.0, 0.5);
  Measurement measurement = with({kVx, kVy, kVz, kVyaw});
  take_twist(twist, {}, measurement);
  EXPECT_TRUE(measurement.values.allFinite());
  EXPECT_TRUE(measurement.covariance.allFinite());
  EXPECT_FALSE(measurement.update[kVz]);
  EXPECT_TRUE(measurement.update[kVyaw]);

  // A first pose that has no direction must not spoil those after it.
  PoseSource source;
  PoseReading pose;
  pose.is_relative = true;
  pose.pose.linear().setConstant(nan);
  Measurement first = with({kX, kYaw});
  EXPECT_FALSE(source.take(pose, {}, first));
  pose.pose = pose_of(1.0, 0.0, 0.2);
  Measurement second = with({kX, kYaw});
  ASSERT_TRUE(source.take(pose, {}, second));
  EXPECT_LT(second.values.norm(), 1e-12);
  pose.pose = pose_of(1.0, 0.0, 0.5);
  Measurement third = with({kX, kYaw});
  ASSERT_TRUE(source.take(pose, {}, third));
  EXPECT_NEAR(third.values(kX), 0.0, 1e-12);
  EXPECT_NEAR(third.values(kYaw), 0.3, 1e-12);
}

TEST(LocalizationReadings, SkipsTheAnglesOfARotationThatIsNotFinite) {
  PoseReading pose;
  pose.pose = pose_of(1.0, 2.0, 0.0);
  pose.pose.linear().setConstant(std::nan(""));
  Measurement measurement = with({kX, kY, kRoll, kPitch, kYaw});
  PoseSource source;
  ASSERT_TRUE(source.take(pose, {}, measurement));
  EXPECT_EQ(measurement.update, with({kX, kY}).update);
  EXPECT_EQ(measurement.values(kY), 2.0);
}

TEST(LocalizationReadings, TakesNoDifferenceFromAPoseWithAGap) {
  // A camera that loses track for one message; the variance may say so, too.
  for (const bool by_variance : {false, true}) {
    PoseSource source;
    PoseReading reading;
    reading.is_differential = true;
    const auto take = [&](double x, double yaw, int64_t time_ms) -> std::optional<Measurement> {
      reading.pose = pose_of(std::isfinite(x) || !by_variance ? x : 10.0, 0.0, yaw);
      reading.covariance.diagonal().setConstant(0.5);
      if (by_variance && !std::isfinite(x)) {
        reading.covariance(0, 0) = std::numeric_limits<double>::infinity();
      }
      Measurement result = with({kX, kY, kYaw}, time_ms * kMillisecond);
      return source.take(reading, {}, result) ? std::optional(result) : std::nullopt;
    };
    EXPECT_FALSE(take(10.0, 0.0, 0));
    for (const auto& [x, time_ms] : {std::pair{std::nan(""), 100}, std::pair{10.02, 200}}) {
      const auto measurement = take(x, 0.01 * time_ms / 100, time_ms);
      ASSERT_TRUE(measurement);
      EXPECT_EQ(measurement->update, with({kVyaw}).update);
      EXPECT_NEAR(measurement->values(kVyaw), 0.1, 1e-9);
    }
    const auto measurement = take(10.04, 0.03, 300);
    ASSERT_TRUE(measurement);
    EXPECT_EQ(measurement->update, with({kVx, kVy, kVyaw}).update);
    EXPECT_NEAR(measurement->values(kVx), 0.2, 1e-3);
  }
}

TEST(LocalizationReadings, TakesNoDifferenceWithoutARotation) {
  PoseSource source;
  PoseReading reading;
  reading.is_differential = true;
  for (int64_t i = 0; i < 3; ++i) {
    reading.pose = pose_of(1.0, 0.1 * static_cast<double>(i), M_PI / 2);
    reading.pose.linear().setConstant(std::nan(""));
    Measurement measurement = with({kX, kY}, i * 100 * kMillisecond);
    EXPECT_FALSE(source.take(reading, {}, measurement)) << "sideways, for all that it knows";
  }
  // A pose that lacks it does not stand between two others.
  reading.pose = pose_of(1.0, 1.0, M_PI / 2);
  Measurement first = with({kX, kY}, 300 * kMillisecond);
  EXPECT_FALSE(source.take(reading, {}, first));
  reading.pose.linear().setConstant(std::nan(""));
  Measurement second = with({kX, kY}, 400 * kMillisecond);
  EXPECT_FALSE(source.take(reading, {}, second));
  reading.pose = pose_of(1.0, 1.4, M_PI / 2);
  Measurement third = with({kX, kY}, 500 * kMillisecond);
  ASSERT_TRUE(source.take(reading, {}, third));
  EXPECT_NEAR(third.values(kVx), 2.0, 1e-9);
  EXPECT_NEAR(third.values(kVy), 0.0, 1e-9);
}

TEST(LocalizationReadings, CountsFromAPoseWhoseVarianceIsInfinite) {
  PoseSource source;
  PoseReading reading;
  reading.is_relative = true;
  reading.covariance.setIdentity();
  // A camera that does not know its yaw, ever, and its x not at first.
  reading.covariance(5, 5) = std::numeric_limits<double>::infinity();
  reading.covariance(0, 0) = std::numeric_limits<double>::infinity();
  reading.pose = pose_of(5.0, 3.0, 0.0);
  Measurement first = with({kX, kY, kYaw});
  ASSERT_TRUE(source.take(reading, {}, first));
  EXPECT_EQ(first.update, with({kY}).update);
  reading.covariance(0, 0) = 1.0;
  reading.pose = pose_of(5.5, 3.25, 0.0);
  Measurement second = with({kX, kY, kYaw});
  ASSERT_TRUE(source.take(reading, {}, second));
  EXPECT_EQ(second.update, with({kX, kY}).update);
  EXPECT_NEAR(second.values(kX), 0.5, 1e-12);
  EXPECT_NEAR(second.values(kY), 0.25, 1e-12);
  // A first pose without a rotation is not one to count from, also when only x is wanted.
  PoseSource other;
  reading.pose.linear().setConstant(std::nan(""));
  Measurement third = with({kX});
  EXPECT_FALSE(other.take(reading, {}, third));
}

TEST(LocalizationReadings, PlacesTheWorldOnTheGlobe) {
  // The robot is 3 m ahead of the origin of its world and looks north: its world looks north, too.
  const Eigen::Isometry3d world = world_from_cartesian(
      pose_of(3.0, 0.0, 0.0), Eigen::Vector3d(500'000, 6'000'000, 40), M_PI / 2);
  EXPECT_LT((world * Eigen::Vector3d(500'000, 6'000'000, 40) - Eigen::Vector3d(3, 0, 0)).norm(),
            1e-8);
  EXPECT_LT((world * Eigen::Vector3d(500'000, 6'000'010, 40) - Eigen::Vector3d(13, 0, 0)).norm(),
            1e-8);
}

TEST(LocalizationReadings, StaysInThePlane) {
  Measurement measurement = with({kX, kVz});
  measurement.values.setConstant(7.0);
  force_two_d(measurement);
  EXPECT_EQ(measurement.update, with({kX, kZ, kRoll, kPitch, kVz, kVroll, kVpitch, kAz}).update);
  EXPECT_EQ(measurement.values(kX), 7.0);
  for (const int member : {kZ, kRoll, kPitch, kVz, kVroll, kVpitch, kAz}) {
    EXPECT_EQ(measurement.values(member), 0.0);
    EXPECT_EQ(measurement.covariance(member, member), 1e-6);
  }
  // A filter that gets nothing else stays there, too.
  Ekf ekf;
  for (int i = 0; i < 200; ++i) {
    Measurement speed = speed_at(i * 20 * kMillisecond, 1.0, 0.5);
    speed.values(kVz) = 1.0;
    speed.update.set(kVz);
    force_two_d(speed);
    ekf.process(speed);
  }
  EXPECT_LT(std::abs(ekf.state().mean(kZ)), 1e-9);
  EXPECT_LT(std::abs(ekf.state().mean(kRoll)), 1e-9);
  EXPECT_GT(std::abs(ekf.state().mean(kX)), 1.0);
}

}  // namespace
}  // namespace robot_localization
