// Measures round trips of several sizes, one message under way at a time, and of each the way there: from `publish` to
// the callback in the ponger, whose steady clock is the same. One JSON line per size: bytes of the payload, round trips,
// medians, means and 99th percentiles in microseconds; the mean is exact where the clock has steps. Parameter `largest`: sizes above it are skipped.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;
using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration time) {return std::chrono::duration<double, std::micro>(time).count();}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("pinger");
  auto ping = node->create_publisher<Bytes>("ping", 10);
  std::size_t heard = 0;
  Clock::time_point came;
  auto pong = node->create_subscription<Bytes>("pong", 10, [&](const Bytes & bytes) {
    std::memcpy(&came, bytes.data.data(), sizeof came);
    ++heard;
  });
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (rclcpp::ok() && (ping->get_subscription_count() == 0 || pong->get_publisher_count() == 0)) {
    executor.spin_once(std::chrono::milliseconds(10));
  }
  // A page that has just started is busy with itself: it keeps the site for visits without a network.
  const Clock::time_point busy_until = Clock::now() + std::chrono::seconds(4);
  constexpr std::size_t warm_up = 100;
  const std::pair<std::size_t, std::size_t> cases[] = {{8, 4000}, {1000, 4000}, {64000, 1000}, {1000000, 200}};
  const auto largest = static_cast<std::size_t>(node->declare_parameter("largest", 1000000));
  for (const auto & [size, count] : cases) {
    if (size > largest) {break;}
    Bytes bytes;
    bytes.data.assign(size, 42);
    std::vector<double> trips;
    std::vector<double> ways;
    std::size_t uncounted = warm_up;
    for (std::size_t i = 0; rclcpp::ok() && i < uncounted + count; ++i) {
      const std::size_t before = heard;
      const auto begin = Clock::now();
      ping->publish(bytes);
      while (rclcpp::ok() && heard == before) {executor.spin_once();}
      if (begin < busy_until) {
        uncounted = i + 1;
      } else if (i >= uncounted) {
        trips.push_back(microseconds(Clock::now() - begin));
        ways.push_back(microseconds(came - begin));
      }
    }
    if (trips.empty()) {break;}
    std::sort(trips.begin(), trips.end());
    std::sort(ways.begin(), ways.end());
    const std::size_t half = trips.size() / 2;
    const std::size_t most = trips.size() * 99 / 100;
    std::printf(
      "{\"bytes\": %zu, \"round_trips\": %zu, \"mean_us\": %.2f, \"p50_us\": %.2f, \"p99_us\": %.2f, \"way_p50_us\": %.2f, \"way_p99_us\": %.2f}\n",
      size, trips.size(), std::accumulate(trips.begin(), trips.end(), 0.0) / static_cast<double>(trips.size()), trips[half], trips[most],
      ways[half], ways[most]);
    std::fflush(stdout);
  }
  std::puts("pinger: done");
  rclcpp::shutdown();
  return 0;
}
