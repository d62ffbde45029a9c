// The transforms of one frame over time, and times as text.

// Compatibility, works: tf2: linear algebra, the buffer with its interpolation, static frames, new
// parents, requests, errors with the texts of ROS 2

#include <gtest/gtest.h>

#include <stdexcept>

#include "tf2/time_cache.hpp"

namespace {

using tf2::TimeCache;
using tf2::TimePoint;
using tf2::TransformStorage;

TimePoint at(double seconds) {
  return tf2::timeFromSec(seconds);
}

TransformStorage stored(double seconds, double x, tf2::CompactFrameID parent = 1) {
  return TransformStorage(at(seconds), tf2::Quaternion(tf2::Vector3(0, 0, 1), x),
                          tf2::Vector3(x, 0, 0), parent, 2);
}

struct Answer {
  bool found = false;
  TransformStorage data;
  std::string error;
  tf2::TF2Error code = tf2::TF2Error::TF2_TIMEOUT_ERROR;
};

Answer ask(tf2::TimeCacheInterface& cache, double seconds) {
  Answer answer;
  answer.found = cache.getData(at(seconds), answer.data, &answer.error, &answer.code);
  return answer;
}

TEST(Tf2Time, SecondsGoRound) {
  EXPECT_EQ(tf2::durationFromSec(1.5).count(), 1500000000);
  EXPECT_EQ(tf2::durationFromSec(-0.25).count(), -250000000);
  EXPECT_EQ(tf2::durationFromSec(1700000000.123456789).count(), 1700000000123456717);
  EXPECT_DOUBLE_EQ(tf2::durationToSec(std::chrono::milliseconds(-1500)), -1.5);
  EXPECT_DOUBLE_EQ(tf2::timeToSec(at(12.75)), 12.75);
  EXPECT_EQ(tf2::displayTimePoint(at(3.25)), "3.250000");
}

TEST(Tf2Cache, InterpolatesBetweenTwo) {
  TimeCache cache;
  ASSERT_TRUE(cache.insertData(stored(1, 0)));
  ASSERT_TRUE(cache.insertData(stored(3, 1)));
  ASSERT_TRUE(cache.insertData(stored(2, 0.5)));  // out of order
  EXPECT_EQ(cache.getListLength(), 3U);
  const Answer answer = ask(cache, 2.5);
  ASSERT_TRUE(answer.found);
  EXPECT_NEAR(answer.data.translation_.x(), 0.75, 1e-12);
  EXPECT_NEAR(answer.data.rotation_.getAngle(), 0.75, 1e-9);
  EXPECT_DOUBLE_EQ(ask(cache, 3).data.translation_.x(), 1);
  EXPECT_DOUBLE_EQ(ask(cache, 1).data.translation_.x(), 0);
  EXPECT_DOUBLE_EQ(ask(cache, 0).data.translation_.x(), 1);  // the latest
  EXPECT_EQ(cache.getLatestTimestamp(), at(3));
  EXPECT_EQ(cache.getOldestTimestamp(), at(1));
}

TEST(Tf2Cache, SaysWhyItCannot) {
  TimeCache cache;
  EXPECT_EQ(ask(cache, 1).code, tf2::TF2Error::TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR);
  cache.insertData(stored(1, 0));
  Answer answer = ask(cache, 2);
  EXPECT_FALSE(answer.found);
  EXPECT_EQ(answer.code, tf2::TF2Error::TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR);
  EXPECT_EQ(answer.error,
            "Lookup would require extrapolation at time 2.000000, but only time 1.000000 is in "
            "the buffer");
  cache.insertData(stored(2, 1));
  answer = ask(cache, 2.5);
  EXPECT_EQ(answer.code, tf2::TF2Error::TF2_FORWARD_EXTRAPOLATION_ERROR);
  EXPECT_EQ(answer.error,
            "Lookup would require extrapolation into the future.  Requested time 2.500000 but the "
            "latest data is at time 2.000000");
  answer = ask(cache, 0.5);
  EXPECT_EQ(answer.code, tf2::TF2Error::TF2_BACKWARD_EXTRAPOLATION_ERROR);
  EXPECT_EQ(answer.error,
            "Lookup would require extrapolation into the past.  Requested time 0.500000 but the "
            "earliest data is at time 1.000000");
}

TEST(Tf2Cache, ForgetsWhatIsTooOld) {
  TimeCache cache(std::chrono::seconds(10));
  cache.insertData(stored(1, 0));
  cache.insertData(stored(20, 1));
  EXPECT_FALSE(cache.insertData(stored(9, 0.5)));
  EXPECT_TRUE(cache.insertData(stored(10, 0.5)));
  EXPECT_EQ(cache.getOldestTimestamp(), at(10));
  EXPECT_TRUE(cache.insertData(stored(20, 1)));  // the same again is kept once
  EXPECT_EQ(cache.getListLength(), 2U);
  cache.clearList();
  EXPECT_EQ(cache.getListLength(), 0U);
}

TEST(Tf2Cache, DoesNotInterpolateBetweenParents) {
  TimeCache cache;
  cache.insertData(stored(1, 0, 1));
  cache.insertData(stored(2, 1, 7));
  const Answer answer = ask(cache, 1.5);
  ASSERT_TRUE(answer.found);
  EXPECT_EQ(answer.data.frame_id_, 1U);
  EXPECT_DOUBLE_EQ(answer.data.translation_.x(), 0);
  EXPECT_EQ(cache.getParent(at(2)), 7U);
  EXPECT_EQ(cache.getLatestTimeAndParent(), tf2::P_TimeAndFrameID(at(2), 7));
}

TEST(Tf2StaticCache, HoldsAtAllTimes) {
  tf2::StaticCache cache;
  cache.insertData(stored(5, 0.5));
  const Answer answer = ask(cache, 1000);
  ASSERT_TRUE(answer.found);
  EXPECT_EQ(answer.data.stamp_, at(1000));
  EXPECT_DOUBLE_EQ(answer.data.translation_.x(), 0.5);
  EXPECT_EQ(cache.getLatestTimeAndParent(), tf2::P_TimeAndFrameID(TimePoint(), 1));
}

}  // namespace
