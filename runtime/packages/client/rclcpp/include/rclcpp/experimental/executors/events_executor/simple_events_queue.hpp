// First in, first out, without a limit.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>

#include "rclcpp/experimental/executors/events_executor/events_queue.hpp"

namespace rclcpp {
namespace experimental {
namespace executors {

class SimpleEventsQueue : public EventsQueue {
 public:
  ~SimpleEventsQueue() override = default;

  /// An event that counts for several is entered as often.
  void enqueue(const ExecutorEvent& event) override {
    ExecutorEvent one = event;
    one.num_events = 1;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      events_.insert(events_.end(), event.num_events, one);
    }
    came_.notify_one();
  }

  bool dequeue(ExecutorEvent& event,
               std::chrono::nanoseconds timeout = std::chrono::nanoseconds::max()) override {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto has_event = [this] { return !events_.empty(); };
    if (timeout == std::chrono::nanoseconds::max()) {
      came_.wait(lock, has_event);
    } else if (!came_.wait_for(lock, timeout, has_event)) {
      return false;
    }
    event = std::move(events_.front());
    events_.pop_front();
    return true;
  }

  bool empty() const override { return size() == 0; }

  size_t size() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return events_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::deque<ExecutorEvent> events_;
};

}  // namespace executors
}  // namespace experimental
}  // namespace rclcpp
