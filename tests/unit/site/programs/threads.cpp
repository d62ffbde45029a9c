// Throws and catches in four threads at once, and across a future.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

std::atomic<int> caught{0};

int main() {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([t] {
      for (int i = 0; i < 1000; ++i) {
        try {
          if (i & 1) throw std::runtime_error("x");
          throw t;
        } catch (const std::runtime_error&) {
          ++caught;
        } catch (int x) {
          if (x == t) ++caught;
        }
      }
    });
  }
  for (auto& thread : threads) thread.join();
  auto future = std::async(std::launch::async, []() -> int { throw std::out_of_range("r"); });
  try {
    future.get();
  } catch (const std::out_of_range&) {
    std::puts("async ok");
  }
  for (int i = 0; i < 4; ++i) std::thread([] { ++caught; }).detach();
  while (caught.load() < 4004) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::printf("%d\n", caught.load() - 4);
}
