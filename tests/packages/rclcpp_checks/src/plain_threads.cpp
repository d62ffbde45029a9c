// A program with threads that links no ROS library: the link brings what the loader asks of it.
#include <cstdio>
#include <thread>
#include <vector>

int main() {
  constexpr int kThreads = 3;
  std::vector<int> squares(kThreads);
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&squares, i] { squares[i] = i * i; });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  const bool holds = squares == std::vector<int>{0, 1, 4};
  std::puts(holds ? "all 1 checks hold" : "the threads did not run");
  return holds ? 0 : 1;
}
