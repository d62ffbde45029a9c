// Keeps the newest messages by their time; everything passes.
#pragma once

#include <algorithm>
#include <deque>
#include <iterator>
#include <memory>
#include <mutex>
#include <vector>

#include "message_filters/connection.h"
#include "message_filters/message_traits.h"
#include "message_filters/simple_filter.h"
#include "rclcpp/rclcpp.hpp"

namespace message_filters {

template <class M>
class Cache : public SimpleFilter<M> {
 public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<const M>;

  template <class F>
  explicit Cache(F& f, unsigned int cache_size = 1) : Cache(cache_size) {
    connectInput(f);
  }
  explicit Cache(unsigned int cache_size = 1) { setCacheSize(cache_size); }
  ~Cache() { incoming_.disconnect(); }

  template <class F>
  void connectInput(F& f) {
    incoming_.disconnect();
    incoming_ = f.registerCallback([this](const EventType& event) { add(event); });
  }

  /// How many messages it keeps. Zero is ignored.
  void setCacheSize(unsigned int cache_size) {
    if (cache_size > 0) {
      size_ = cache_size;
    }
  }

  void add(const MConstPtr& msg) { add(EventType(msg)); }
  void add(const EventType& evt) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      while (kept_.size() >= size_) {
        kept_.pop_front();
      }
      kept_.insert(first_after(stamp(evt)), evt);
    }
    this->signalMessage(evt);
  }

  /// The messages from `start` to `end`, both included.
  std::vector<MConstPtr> getInterval(const rclcpp::Time& start, const rclcpp::Time& end) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto begin = first_from(start);
    return messages(begin, std::max(begin, first_after(end)));
  }

  /// The same, and the nearest ones outside of it when none is just at `start` or `end`.
  std::vector<MConstPtr> getSurroundingInterval(const rclcpp::Time& start,
                                                const rclcpp::Time& end) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (kept_.empty()) {
      return {};
    }
    auto begin = first_after(start);
    begin -= begin == kept_.begin() ? 0 : 1;
    auto last = std::max(begin, first_from(end));
    last -= last == kept_.end() ? 1 : 0;
    return messages(begin, std::next(last));
  }

  /// The newest message before a time; null when there is none.
  MConstPtr getElemBeforeTime(const rclcpp::Time& time) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto at = first_from(time);
    return at == kept_.begin() ? nullptr : std::prev(at)->getMessage();
  }
  /// The oldest message after a time; null when there is none.
  MConstPtr getElemAfterTime(const rclcpp::Time& time) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto at = first_after(time);
    return at == kept_.end() ? nullptr : at->getMessage();
  }

  /// Zero when nothing is kept.
  rclcpp::Time getLatestTime() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return kept_.empty() ? rclcpp::Time() : stamp(kept_.back());
  }
  rclcpp::Time getOldestTime() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return kept_.empty() ? rclcpp::Time() : stamp(kept_.front());
  }

 private:
  using Iterator = typename std::deque<EventType>::const_iterator;

  static rclcpp::Time stamp(const EventType& event) {
    return message_traits::TimeStamp<M>::value(*event.getConstMessage());
  }
  Iterator first_from(const rclcpp::Time& time) const {
    return std::lower_bound(
        kept_.begin(), kept_.end(), time,
        [](const EventType& event, const rclcpp::Time& wanted) { return stamp(event) < wanted; });
  }
  Iterator first_after(const rclcpp::Time& time) const {
    return std::upper_bound(
        kept_.begin(), kept_.end(), time,
        [](const rclcpp::Time& wanted, const EventType& event) { return wanted < stamp(event); });
  }
  static std::vector<MConstPtr> messages(Iterator begin, Iterator end) {
    std::vector<MConstPtr> result;
    std::transform(begin, end, std::back_inserter(result),
                   [](const EventType& event) { return event.getMessage(); });
    return result;
  }

  mutable std::mutex mutex_;
  /// By time, the oldest first.
  std::deque<EventType> kept_;
  unsigned int size_ = 1;
  Connection incoming_;
};

}  // namespace message_filters
