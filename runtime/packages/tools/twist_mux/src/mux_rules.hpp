// Which velocities go out: priorities, ages and locks. Pure; times are seconds of the node.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace twist_mux {

constexpr int kLowestPriority = 0;
constexpr int kHighestPriority = 255;

/// A topic with velocities, or one with a lock.
struct Input {
  Input(std::string given_name, std::string given_topic, double given_timeout_s, int given_priority)
      : name(std::move(given_name)),
        topic(std::move(given_topic)),
        timeout_s(given_timeout_s),
        priority(std::clamp(given_priority, kLowestPriority, kHighestPriority)) {}

  std::string name;  ///< its prefix among the parameters, as `topics.joystick`
  std::string topic;
  double timeout_s;  ///< 0 or less: it never expires
  int priority;
  double stamp_s = 0;   ///< of the last message; 0 before the first, so that it has expired then
  bool is_set = false;  ///< what the last message of a lock says

  bool has_expired(double now_s) const { return timeout_s > 0.0 && now_s - stamp_s > timeout_s; }
  bool is_locked(double now_s) const { return has_expired(now_s) || is_set; }
  bool is_masked(int lock_priority, double now_s) const {
    return has_expired(now_s) || priority < lock_priority;
  }
};

class MuxRules {
 public:
  MuxRules() = default;
  MuxRules(std::vector<Input> topics, std::vector<Input> locks)
      : topics_(std::move(topics)), locks_(std::move(locks)) {}

  const std::vector<Input>& topics() const { return topics_; }
  const std::vector<Input>& locks() const { return locks_; }

  /// Notes a velocity, and returns whether it goes out.
  bool receive(std::size_t topic, double now_s) {
    topics_.at(topic).stamp_s = now_s;
    return &topics_.at(topic) == winner(now_s);
  }

  void receive_lock(std::size_t lock, bool is_set, double now_s) {
    locks_.at(lock).is_set = is_set;
    locks_.at(lock).stamp_s = now_s;
  }

  /// The highest one of the locks that are active; 0 when none is.
  int lock_priority(double now_s) const {
    int result = kLowestPriority;
    for (const Input& lock : locks_) {
      if (lock.is_locked(now_s)) result = std::max(result, lock.priority);
    }
    return result;
  }

 private:
  /// The first of those with the highest priority that are not masked. Priority 0 never wins.
  const Input* winner(double now_s) const {
    const int lock = lock_priority(now_s);
    const Input* result = nullptr;
    int highest = kLowestPriority;
    for (const Input& topic : topics_) {
      if (topic.is_masked(lock, now_s) || topic.priority <= highest) continue;
      highest = topic.priority;
      result = &topic;
    }
    return result;
  }

  std::vector<Input> topics_;
  std::vector<Input> locks_;
};

}  // namespace twist_mux
