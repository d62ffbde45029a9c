// Threads of C++20: they are asked to stop, and joined, when they go out of scope.
#include <atomic>
#include <thread>

#include "checks.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("newer_threads");
  std::atomic<int> rounds{0};
  std::atomic<bool> called{false};
  {
    std::jthread worker([&](const std::stop_token& stop) {
      const std::stop_callback callback(stop, [&called] { called = true; });
      while (!stop.stop_requested()) {
        ++rounds;
        std::this_thread::yield();
      }
    });
    std::jthread plain([&rounds](int more) { rounds += more; }, 1000);
    CHECK(worker.joinable() && worker.get_stop_token().stop_possible());
    while (rounds <= 1000) {
      std::this_thread::yield();
    }
  }
  CHECK(called && rounds > 1000);
  std::stop_source source;
  bool late = false;
  CHECK(source.request_stop() && !source.request_stop());
  const std::stop_callback callback(source.get_token(), [&late] { late = true; });
  CHECK(late && !std::stop_token().stop_possible());
  return checks.finish();
}
