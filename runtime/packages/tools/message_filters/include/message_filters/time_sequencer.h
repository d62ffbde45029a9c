// Hands messages on in the order of their times, when they are old enough.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "message_filters/connection.h"
#include "message_filters/message_traits.h"
#include "message_filters/simple_filter.h"
#include "rclcpp/rclcpp.hpp"

namespace message_filters {

template <class M>
class TimeSequencer : public SimpleFilter<M> {
 public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<const M>;

  /// Every `update_rate` (a period) it hands on what is `delay` old by the node's clock. Of more
  /// than `queue_size` messages the oldest are dropped; 0: none.
  template <class F>
  TimeSequencer(F& f, rclcpp::Duration delay, rclcpp::Duration update_rate, uint32_t queue_size,
                rclcpp::Node::SharedPtr node)
      : TimeSequencer(delay, update_rate, queue_size, std::move(node)) {
    connectInput(f);
  }
  TimeSequencer(rclcpp::Duration delay, rclcpp::Duration update_rate, uint32_t queue_size,
                rclcpp::Node::SharedPtr node)
      : delay_(delay.nanoseconds()), queue_size_(queue_size), node_(std::move(node)) {
    timer_ = node_->create_wall_timer(std::chrono::nanoseconds(update_rate.nanoseconds()),
                                      [this] { dispatch(); });
  }
  ~TimeSequencer() {
    timer_->cancel();
    incoming_.disconnect();
  }

  template <class F>
  void connectInput(F& f) {
    incoming_.disconnect();
    incoming_ = f.registerCallback([this](const EventType& event) { add(event); });
  }

  /// A message older than what was handed on last is dropped.
  void add(const EventType& evt) {
    const int64_t stamp = message_traits::TimeStamp<M>::value(*evt.getConstMessage()).nanoseconds();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (last_ && stamp < *last_) {
      return;
    }
    waiting_.emplace(stamp, evt);
    if (queue_size_ != 0 && waiting_.size() > queue_size_) {
      waiting_.erase(waiting_.begin());
    }
  }
  void add(const MConstPtr& msg) { add(EventType(msg)); }

 private:
  void dispatch() {
    std::vector<EventType> due;
    {
      const int64_t now = node_->get_clock()->now().nanoseconds();
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto end = waiting_.upper_bound(now - delay_);
      for (auto at = waiting_.begin(); at != end; ++at) {
        due.push_back(at->second);
        last_ = at->first;
      }
      waiting_.erase(waiting_.begin(), end);
    }
    for (const EventType& event : due) {
      this->signalMessage(event);
    }
  }

  const int64_t delay_;
  const uint32_t queue_size_;
  const rclcpp::Node::SharedPtr node_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::mutex mutex_;
  std::multimap<int64_t, EventType> waiting_;
  std::optional<int64_t> last_;
  Connection incoming_;
};

}  // namespace message_filters
