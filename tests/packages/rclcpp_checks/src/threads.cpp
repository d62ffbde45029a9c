// Threads: a multi-threaded executor with both kinds of groups, publishing from a thread.

// Compatibility, differs: affinity and priority of threads (`pthread_setaffinity_np`,
// `pthread_setschedparam`, `sched_setscheduler` ...) -> refused with `ENOSYS`, as where a system
// has none; the policy that every thread has (SCHED_OTHER, priority 0) may be set and asked for

// Compatibility, differs: CPU time of a process or a thread (`CLOCK_THREAD_CPUTIME_ID`,
// `pthread_getcpuclockid`) -> the time that goes by: a browser counts no other

#include <errno.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <future>
#include <mutex>
#include <set>
#include <thread>

#include "checks.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;
using namespace std::chrono_literals;

namespace {

// Programs that ask for a CPU or a priority are told that there is none, and go on.
void check_scheduling(Checks& checks) {
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  CPU_SET(0, &cpus);
  CHECK(pthread_setaffinity_np(pthread_self(), sizeof(cpus), &cpus) == ENOSYS);
  CHECK(pthread_getaffinity_np(pthread_self(), sizeof(cpus), &cpus) == ENOSYS);
  CHECK(sched_setaffinity(0, sizeof(cpus), &cpus) == -1 && errno == ENOSYS);
  sched_param parameters{};
  CHECK(sched_setscheduler(0, SCHED_FIFO, &parameters) == -1 && errno == ENOSYS);
  // With the reason in errno, which programs print although the functions of threads return it.
  errno = 0;
  parameters.sched_priority = 10;
  CHECK(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == ENOSYS && errno == ENOSYS);
  errno = 0;
  CHECK(pthread_setaffinity_np(pthread_self(), sizeof(cpus), &cpus) == ENOSYS && errno == ENOSYS);
  int policy = SCHED_FIFO;
  CHECK(pthread_getschedparam(pthread_self(), &policy, &parameters) == 0 && policy == SCHED_OTHER);
  CHECK(parameters.sched_priority == 0);
  CHECK(pthread_setschedparam(pthread_self(), SCHED_OTHER, &parameters) == 0);
  CHECK(sched_get_priority_max(SCHED_FIFO) == 99 && sched_get_priority_min(SCHED_FIFO) == 1);
  CHECK(pthread_setname_np(pthread_self(), "planner") == 0);
  CHECK(pthread_setname_np(pthread_self(), "sixteen_letters_") == ERANGE);
  // What stands for a thread's CPU time goes on.
  clockid_t clock = -1;
  timespec before{};
  timespec after{};
  CHECK(pthread_getcpuclockid(pthread_self(), &clock) == 0);
  CHECK(clock_gettime(clock, &before) == 0);
  const clock_t ticks = ::clock();
  std::this_thread::sleep_for(2ms);
  CHECK(::clock() - ticks >= 2 * CLOCKS_PER_SEC / 1000);
  CHECK(clock_gettime(clock, &after) == 0);
  CHECK(after.tv_sec * 1000000000LL + after.tv_nsec >
        before.tv_sec * 1000000000LL + before.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("threads");
  check_scheduling(checks);
  auto node = std::make_shared<rclcpp::Node>("threads_node");
  auto free_group = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  auto one_group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);

  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 3);
  std::atomic<int> inside{0};
  std::atomic<int> most_inside{0};
  std::atomic<int> alone{0};
  std::atomic<int> most_alone{0};
  std::atomic<int> heard{0};
  std::mutex mutex;
  std::set<std::thread::id> ids;
  const auto enter = [](std::atomic<int>& count, std::atomic<int>& most) {
    const int now = ++count;
    int seen = most;
    while (now > seen && !most.compare_exchange_weak(seen, now)) {
    }
  };
  auto parallel = node->create_wall_timer(
      1ms,
      [&] {
        enter(inside, most_inside);
        {
          const std::lock_guard<std::mutex> lock(mutex);
          ids.insert(std::this_thread::get_id());
        }
        std::this_thread::sleep_for(10ms);
        --inside;
      },
      free_group);
  const auto exclusive = [&] {
    enter(alone, most_alone);
    std::this_thread::sleep_for(1ms);
    --alone;
  };
  auto first = node->create_wall_timer(1ms, exclusive, one_group);
  auto second = node->create_wall_timer(1ms, exclusive, one_group);
  rclcpp::SubscriptionOptions options;
  options.callback_group = free_group;
  auto subscription = node->create_subscription<String>(
      "crowd", 100, [&](const String&) { ++heard; }, options);
  auto publisher = node->create_publisher<String>("crowd", 100);
  constexpr int kMessages = 20;
  std::thread feeder([&] {
    for (int i = 0; i < kMessages; ++i) {
      publisher->publish(String());
      std::this_thread::sleep_for(2ms);
    }
  });
  auto caught = std::async(std::launch::async, [] {
    try {
      throw std::out_of_range("in a thread");
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
  });
  std::thread stopper([&] {
    while (heard < kMessages || most_inside < 2) {
      std::this_thread::sleep_for(1ms);
    }
    executor.cancel();
  });
  executor.add_node(node);
  executor.spin();
  stopper.join();
  feeder.join();
  CHECK(heard == kMessages);
  CHECK(most_inside > 1);
  CHECK(most_alone == 1);
  CHECK(ids.size() > 1);
  CHECK(caught.get() == "in a thread");
  return checks.finish();
}
