// Filters that are given messages by hand: what passes, in which form, and what belongs together.

// Compatibility, differs: message_filters::TimeSequencer -> how old a message is it tells by the
// node's clock, so it follows simulated time; that of ROS 2 throws for messages with a header
//
// Compatibility, works: message_filters with all its policies, callbacks in every form;
// `tf2_ros::MessageFilter`

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/vector3_stamped.hpp"
#include "message_filters/cache.h"
#include "message_filters/chain.h"
#include "message_filters/pass_through.h"
#include "message_filters/subscriber.h"
#include "message_filters/sync_policies/approximate_epsilon_time.h"
#include "message_filters/sync_policies/approximate_time.h"
#include "message_filters/sync_policies/exact_time.h"
#include "message_filters/sync_policies/latest_time.h"
#include "message_filters/synchronizer.h"
#include "message_filters/time_sequencer.h"
#include "message_filters/time_synchronizer.h"

using geometry_msgs::msg::PointStamped;
using geometry_msgs::msg::Vector3Stamped;
using std::placeholders::_1;
using std::placeholders::_2;
namespace mf = message_filters;

namespace {

template <typename M>
std::shared_ptr<const M> at(int seconds) {
  auto message = std::make_shared<M>();
  message->header.stamp.sec = seconds;
  return message;
}
PointStamped::ConstSharedPtr point(int seconds) {
  return at<PointStamped>(seconds);
}
Vector3Stamped::ConstSharedPtr vector(int seconds) {
  return at<Vector3Stamped>(seconds);
}
rclcpp::Time time(int seconds) {
  return rclcpp::Time(seconds, 0, RCL_ROS_TIME);
}

int heard_by_function = 0;
void function_of_pointer(const PointStamped::ConstSharedPtr& message) {
  heard_by_function += message->header.stamp.sec;
}
void function_of_message(const PointStamped& message) {
  heard_by_function += message.header.stamp.sec;
}

struct Hearer {
  int heard = 0;
  PointStamped::SharedPtr own;
  void pointer(PointStamped::ConstSharedPtr message) { heard += message->header.stamp.sec; }
  void changeable(PointStamped::SharedPtr message) {
    message->point.x = 1;
    own = message;
  }
  void event(const mf::MessageEvent<PointStamped const>& event) {
    heard += event.getMessage()->header.stamp.sec;
  }
  void pair(const PointStamped::ConstSharedPtr& a, const Vector3Stamped::ConstSharedPtr& b) {
    heard += a->header.stamp.sec + b->header.stamp.sec;
  }
};

void callbacks(Checks& checks) {
  mf::PassThrough<PointStamped> filter;
  Hearer hearer;
  int by_lambda = 0;
  filter.registerCallback(function_of_pointer);
  filter.registerCallback(&function_of_message);
  filter.registerCallback(&Hearer::pointer, &hearer);
  filter.registerCallback(&Hearer::changeable, &hearer);
  filter.registerCallback(&Hearer::event, &hearer);
  filter.registerCallback(std::bind(&Hearer::pointer, &hearer, _1));
  filter.registerCallback(
      [&](const PointStamped::ConstSharedPtr& m) { by_lambda += m->header.stamp.sec; });
  filter.registerCallback([&](const PointStamped& m) { by_lambda += m.header.stamp.sec; });
  filter.registerCallback([&](const auto& m) { by_lambda += m->header.stamp.sec; });
  filter.registerCallback<PointStamped::SharedPtr>(
      [&](const PointStamped::SharedPtr& m) { by_lambda += m->header.stamp.sec; });
  const std::function<void(PointStamped)> by_value = [&](PointStamped m) {
    by_lambda += m.header.stamp.sec;
  };
  auto connection = filter.registerCallback(by_value);
  const auto message = point(1);
  filter.add(message);
  CHECK(heard_by_function == 2);
  CHECK(hearer.heard == 3);
  CHECK(by_lambda == 5);
  // The one that changes it has its own.
  CHECK(hearer.own->point.x == 1 && message->point.x == 0);
  connection.disconnect();
  connection.disconnect();
  filter.add(message);
  CHECK(by_lambda == 9);

  // One that goes when it has been called, and takes another along.
  mf::PassThrough<PointStamped> source;
  int once = 0;
  mf::Connection own;
  mf::Connection next;
  own = source.registerCallback([&](const PointStamped&) {
    ++once;
    own.disconnect();
    next.disconnect();
  });
  next = source.registerCallback([&](const PointStamped&) { once += 10; });
  source.add(message);
  source.add(message);
  CHECK(once == 1);

  mf::Connection orphan;
  {
    mf::PassThrough<PointStamped> gone;
    orphan = gone.registerCallback(function_of_pointer);
    gone.setName("gone");
    CHECK(gone.getName() == "gone");
  }
  orphan.disconnect();
}

void chains(Checks& checks) {
  mf::Chain<PointStamped> chain;
  int heard = 0;
  chain.registerCallback([&](const PointStamped& m) { heard += m.header.stamp.sec; });
  chain.add(point(1));
  CHECK(heard == 0);
  auto cache = std::make_shared<mf::Cache<PointStamped>>(2);
  mf::PassThrough<PointStamped> last;
  CHECK(chain.addFilter(cache) == 0);
  CHECK(chain.addFilter(&last) == 1);
  CHECK(chain.getFilter<mf::Cache<PointStamped>>(0) == cache);
  CHECK(chain.getFilter<mf::Cache<PointStamped>>(2) == nullptr);
  mf::PassThrough<PointStamped> source;
  chain.connectInput(source);
  source.add(point(5));
  chain.add(point(2));
  CHECK(heard == 7);
  CHECK(cache->getLatestTime() == time(5));
}

void caches(Checks& checks) {
  mf::Cache<PointStamped> cache(4);
  CHECK(cache.getLatestTime() == rclcpp::Time());
  CHECK(cache.getInterval(time(0), time(100)).empty());
  CHECK(cache.getSurroundingInterval(time(0), time(100)).empty());
  for (const int each : {10, 30, 20, 40, 50}) {
    cache.add(point(each));
  }
  // 10 had to go; the others are in order.
  CHECK(cache.getOldestTime() == time(20) && cache.getLatestTime() == time(50));
  const auto seconds = [](const std::vector<PointStamped::ConstSharedPtr>& messages) {
    std::vector<int> result;
    for (const auto& message : messages) {
      result.push_back(message->header.stamp.sec);
    }
    return result;
  };
  CHECK((seconds(cache.getInterval(time(20), time(40))) == std::vector<int>{20, 30, 40}));
  CHECK(cache.getInterval(time(31), time(39)).empty());
  CHECK((seconds(cache.getSurroundingInterval(time(31), time(39))) == std::vector<int>{30, 40}));
  CHECK((seconds(cache.getSurroundingInterval(time(30), time(40))) == std::vector<int>{30, 40}));
  CHECK((seconds(cache.getSurroundingInterval(time(0), time(99))) ==
         std::vector<int>{20, 30, 40, 50}));
  CHECK(cache.getElemBeforeTime(time(30))->header.stamp.sec == 20);
  CHECK(cache.getElemBeforeTime(time(20)) == nullptr);
  CHECK(cache.getElemAfterTime(time(30))->header.stamp.sec == 40);
  CHECK(cache.getElemAfterTime(time(50)) == nullptr);
}

using Pairs = std::vector<std::pair<int, int>>;
template <typename SyncT>
void write_down(SyncT& sync, Pairs& pairs) {
  sync.registerCallback([&pairs](const PointStamped& a, const Vector3Stamped& b) {
    pairs.emplace_back(a.header.stamp.sec, b.header.stamp.sec);
  });
}

void exact(Checks& checks) {
  mf::PassThrough<PointStamped> points;
  mf::PassThrough<Vector3Stamped> vectors;
  mf::TimeSynchronizer<PointStamped, Vector3Stamped> sync(points, vectors, 2);
  Pairs pairs;
  write_down(sync, pairs);
  Hearer hearer;
  sync.registerCallback(&Hearer::pair, &hearer);
  sync.registerCallback(std::bind(&Hearer::pair, &hearer, _1, _2));
  std::vector<int> dropped;
  sync.registerDropCallback(
      [&](const PointStamped::ConstSharedPtr& a, const Vector3Stamped::ConstSharedPtr& b) {
        dropped.push_back(a ? a->header.stamp.sec : -b->header.stamp.sec);
      });
  CHECK(sync.getLastSignalTime() == rclcpp::Time());
  points.add(point(1));
  vectors.add(vector(2));
  CHECK(pairs.empty());
  points.add(point(2));
  CHECK((pairs == Pairs{{2, 2}}));
  CHECK(hearer.heard == 8);
  CHECK((dropped == std::vector<int>{1}));
  CHECK(sync.getLastSignalTime() == time(2));
  for (const int each : {3, 4, 5}) {
    vectors.add(vector(each));
  }
  CHECK((dropped == std::vector<int>{1, -3}));
  points.add(point(3));
  points.add(point(5));
  CHECK((pairs == Pairs{{2, 2}, {5, 5}}));
}

using Near = mf::sync_policies::ApproximateTime<PointStamped, Vector3Stamped>;

void approximate(Checks& checks) {
  mf::PassThrough<PointStamped> points;
  mf::PassThrough<Vector3Stamped> vectors;
  mf::Synchronizer<Near> sync(Near(10), points, vectors);
  Pairs pairs;
  write_down(sync, pairs);
  points.add(point(0));
  points.add(point(9));
  vectors.add(vector(10));
  // 9 is nearer to 10 than 0, and 11 may be yet to come.
  CHECK(pairs.empty());
  points.add(point(20));
  CHECK((pairs == Pairs{{9, 10}}));
  vectors.add(vector(22));
  vectors.add(vector(32));
  points.add(point(30));
  CHECK((pairs == Pairs{{9, 10}, {20, 22}}));

  // Who knows that nothing comes sooner need not wait.
  mf::Synchronizer<Near> patient(Near(10), points, vectors);
  patient.setInterMessageLowerBound(0, rclcpp::Duration(5, 0));
  patient.getPolicy()->setInterMessageLowerBound(1, rclcpp::Duration(5, 0));
  Pairs at_once;
  write_down(patient, at_once);
  points.add(point(100));
  vectors.add(vector(101));
  CHECK((at_once == Pairs{{100, 101}}));

  mf::Synchronizer<Near> strict(Near(10), points, vectors);
  strict.setMaxIntervalDuration(rclcpp::Duration(1, 0));
  Pairs close;
  write_down(strict, close);
  for (const int each : {200, 210}) {
    points.add(point(each));
    vectors.add(vector(each + 2));
  }
  points.add(point(220));
  vectors.add(vector(220));
  points.add(point(230));
  CHECK((close == Pairs{{220, 220}}));

  // A topic that is silent costs no memory: 10 messages wait, the newest.
  mf::Synchronizer<Near> full(Near(10), points, vectors);
  Pairs late;
  write_down(full, late);
  for (int each = 1000; each < 1100; ++each) {
    points.add(point(each));
  }
  for (const int each : {1091, 1095, 1099}) {
    vectors.add(vector(each));
  }
  points.add(point(1100));
  CHECK((late == Pairs{{1091, 1091}, {1095, 1095}, {1099, 1099}}));
}

void other_policies(Checks& checks) {
  mf::PassThrough<PointStamped> points;
  mf::PassThrough<Vector3Stamped> vectors;
  using Epsilon = mf::sync_policies::ApproximateEpsilonTime<PointStamped, Vector3Stamped>;
  mf::Synchronizer<Epsilon> sync(Epsilon(10, rclcpp::Duration(2, 0)), points, vectors);
  Pairs pairs;
  write_down(sync, pairs);
  points.add(point(1));
  points.add(point(7));
  vectors.add(vector(8));
  CHECK((pairs == Pairs{{7, 8}}));

  using Latest = mf::sync_policies::LatestTime<PointStamped, Vector3Stamped>;
  const auto clock = std::make_shared<rclcpp::Clock>(RCL_STEADY_TIME);
  mf::Synchronizer<Latest> latest(Latest(clock), points, vectors);
  Pairs newest;
  write_down(latest, newest);
  for (int i = 0; i < 4; ++i) {
    points.add(point(i));
    if (i == 0) {
      vectors.add(vector(50));
    }
    rclcpp::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK((newest == Pairs{{1, 50}, {2, 50}, {3, 50}}));
}

void nine(Checks& checks) {
  using P = PointStamped;
  mf::PassThrough<P> f[9];
  mf::TimeSynchronizer<P, P, P, P, P, P, P, P, P> sync(f[0], f[1], f[2], f[3], f[4], f[5], f[6],
                                                       f[7], f[8], 1);
  int heard = 0;
  sync.registerCallback([&](const P& a, const P&, const P&, const P&, const P&, const P&, const P&,
                            const P&,
                            const P& i) { heard += a.header.stamp.sec + i.header.stamp.sec; });
  for (auto& each : f) {
    CHECK(heard == 0);
    each.add(point(4));
  }
  CHECK(heard == 8);
}

void sequence(Checks& checks) {
  auto node = rclcpp::Node::make_shared("sequence");
  mf::TimeSequencer<PointStamped> sequencer(rclcpp::Duration::from_seconds(0.01),
                                            rclcpp::Duration::from_seconds(0.005), 10, node);
  std::vector<int> heard;
  sequencer.registerCallback([&](const PointStamped& m) { heard.push_back(m.header.stamp.sec); });
  for (const int each : {30, 10, 20}) {
    sequencer.add(point(each));
  }
  CHECK(heard.empty());
  while (rclcpp::ok() && heard.size() < 3) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK((heard == std::vector<int>{10, 20, 30}));
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("filters");
  callbacks(checks);
  chains(checks);
  caches(checks);
  exact(checks);
  approximate(checks);
  other_policies(checks);
  nine(checks);
  sequence(checks);
  return checks.finish();
}
