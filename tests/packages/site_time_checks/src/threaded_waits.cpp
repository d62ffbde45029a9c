// The ways in which threads wait for a time in the program's own memory.
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "waiting.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  std::mutex mutex;
  std::condition_variable condition;

  std::thread([] {
    wait_by("thread's sleep_for", [] { std::this_thread::sleep_for(kWhile); });
  }).join();
  wait_by("condition_variable", [&] {
    std::unique_lock<std::mutex> lock(mutex);
    condition.wait_for(lock, kWhile, [] { return false; });
  });
  std::thread([&] {
    wait_by("thread's condition_variable", [&] {
      std::unique_lock<std::mutex> lock(mutex);
      condition.wait_until(lock, std::chrono::steady_clock::now() + kWhile, [] { return false; });
    });
  }).join();
  std::vector<std::thread> threads;
  int waiting = 0;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
      std::unique_lock<std::mutex> lock(mutex);
      ++waiting;
      condition.notify_all();
      const auto until = std::chrono::steady_clock::now() + kWhile;
      condition.wait_until(lock, until, [] { return false; });
    });
  }
  {
    std::unique_lock<std::mutex> lock(mutex);
    condition.wait(lock, [&] { return waiting == 3; });
  }
  wait_by("three at once", [&] {
    for (std::thread& thread : threads) {
      thread.join();
    }
  });
  std::timed_mutex taken;
  taken.lock();
  std::thread([&] { wait_by("timed mutex", [&] { taken.try_lock_for(kWhile); }); }).join();
  taken.unlock();
  wait_by("future of a thread", [&] {
    bool go = false;
    auto future = std::async(std::launch::async, [&] {
      std::unique_lock<std::mutex> lock(mutex);
      condition.wait(lock, [&] { return go; });
    });
    future.wait_for(kWhile);
    {
      const std::lock_guard<std::mutex> lock(mutex);
      go = true;
    }
    condition.notify_all();
  });

  rclcpp::shutdown();
  return 0;
}
