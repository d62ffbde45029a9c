// The executor of events: each piece of work passes the queue.
#include "rclcpp/experimental/executors/events_executor/events_executor.hpp"

#include <stdexcept>
#include <utility>

#include "rclcpp/client.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp {
namespace experimental {
namespace executors {
namespace {

ExecutorEventType type_of(const detail::Executable& entity) {
  if (dynamic_cast<const SubscriptionBase*>(&entity) != nullptr) {
    return SUBSCRIPTION_EVENT;
  }
  if (dynamic_cast<const TimerBase*>(&entity) != nullptr) {
    return TIMER_EVENT;
  }
  if (dynamic_cast<const ServiceBase*>(&entity) != nullptr) {
    return SERVICE_EVENT;
  }
  return dynamic_cast<const ClientBase*>(&entity) != nullptr ? CLIENT_EVENT : WAITABLE_EVENT;
}

}  // namespace

EventsExecutor::EventsExecutor(EventsQueue::UniquePtr events_queue, bool,
                               const rclcpp::ExecutorOptions& options)
    : rclcpp::Executor(options), events_queue_(std::move(events_queue)) {
  if (!events_queue_) {
    throw std::invalid_argument("events_queue can't be a null pointer");
  }
}

void EventsExecutor::spin() {
  if (spinning.exchange(true)) {
    throw std::runtime_error("spin() called while already spinning");
  }
  struct Reset {
    std::atomic_bool& flag;
    ~Reset() { flag = false; }
  } reset{spinning};
  while (rclcpp::ok(context_) && spinning) {
    AnyExecutable any_executable;
    if (get_next_executable(any_executable)) {
      execute_any_executable(any_executable);
    }
  }
}

bool EventsExecutor::run_executable(AnyExecutable& any_executable) {
  // The queue may keep it for longer than the caller.
  auto work = std::make_shared<AnyExecutable>();
  work->entity = std::move(any_executable.entity);
  work->data = std::move(any_executable.data);
  work->callback_group = std::move(any_executable.callback_group);
  work->seekers = any_executable.seekers;
  events_queue_->enqueue({work->entity.get(), work, -1, type_of(*work->entity), 1});
  work.reset();
  bool done = false;
  while (!events_queue_->empty()) {
    ExecutorEvent event{};
    if (!events_queue_->dequeue(event, std::chrono::nanoseconds(0))) {
      break;
    }
    if (event.data) {
      auto& next = *static_cast<AnyExecutable*>(event.data.get());
      done = Executor::run_executable(next) || done;
    }
  }
  return done;
}

}  // namespace executors
}  // namespace experimental
}  // namespace rclcpp
