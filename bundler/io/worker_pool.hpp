// A few threads that work off a queue. Tasks must not throw and take care of their own results.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ros2wasm {

class WorkerPool {
 public:
  /// As many threads as the machine has processors, at most 8.
  WorkerPool();
  ~WorkerPool();  ///< waits for all tasks
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  void add(std::function<void()> task);
  /// True when all tasks are done; waits for that at most `timeout_ms`.
  [[nodiscard]] bool wait(int timeout_ms);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  std::size_t open_ = 0;  ///< tasks that are not done
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace ros2wasm
