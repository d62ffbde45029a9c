// A value that several sides read and write, waiting for each other or not.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <utility>

namespace realtime_tools {

template <class T, typename mutex_type = std::mutex>
class RealtimeThreadSafeBox {
 public:
  using mutex_t = mutex_type;
  using type = T;

  explicit RealtimeThreadSafeBox(const T& init = T{}) : value_(init) {}
  RealtimeThreadSafeBox(const RealtimeThreadSafeBox& other) : value_(other.get()) {}
  RealtimeThreadSafeBox& operator=(const RealtimeThreadSafeBox& other) {
    if (this != &other) set(other.get());
    return *this;
  }
  RealtimeThreadSafeBox& operator=(const T& value) {
    set(value);
    return *this;
  }
  operator T() const { return get(); }

  void set(const T& value) {
    const std::lock_guard<mutex_t> lock(mutex_);
    value_ = value;
  }
  void set(const std::function<void(T&)>& change) {
    const std::lock_guard<mutex_t> lock(mutex_);
    change(value_);
  }
  /// False when it is held just now, as the others below.
  bool try_set(const T& value) {
    return if_free([&] { value_ = value; });
  }
  bool try_set(const std::function<void(T&)>& change) {
    return if_free([&] { change(value_); });
  }
  bool trySet(const T& value) { return try_set(value); }
  bool trySet(const std::function<void(T&)>& change) { return try_set(change); }

  [[nodiscard]] T get() const {
    const std::lock_guard<mutex_t> lock(mutex_);
    return value_;
  }
  void get(T& into) const { into = get(); }
  void get(const std::function<void(const T&)>& look) const {
    const std::lock_guard<mutex_t> lock(mutex_);
    look(value_);
  }
  [[nodiscard]] std::optional<T> try_get() const {
    std::optional<T> found;
    if_free([&] { found = value_; });
    return found;
  }
  bool try_get(const std::function<void(const T&)>& look) const {
    return if_free([&] { look(value_); });
  }
  [[nodiscard]] std::optional<T> tryGet() const { return try_get(); }
  bool tryGet(const std::function<void(const T&)>& look) const { return try_get(look); }
  [[nodiscard]] mutex_t& get_mutex() const { return mutex_; }

 private:
  template <typename ActionT>
  bool if_free(const ActionT& act) const {
    const std::unique_lock<mutex_t> lock(mutex_, std::try_to_lock);
    if (lock.owns_lock()) act();
    return lock.owns_lock();
  }

  mutable mutex_t mutex_;
  T value_;
};

}  // namespace realtime_tools
