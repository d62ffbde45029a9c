// A value that one side writes and the other reads without ever waiting.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace realtime_tools {

template <class T>
class RealtimeBuffer {
 public:
  RealtimeBuffer() : RealtimeBuffer(T()) {}
  explicit RealtimeBuffer(const T& data)
      : realtime_(std::make_unique<T>(data)), other_(std::make_unique<T>(data)) {}
  RealtimeBuffer(const RealtimeBuffer& source) : RealtimeBuffer(*source.readFromNonRT()) {}
  RealtimeBuffer& operator=(const RealtimeBuffer& source) {
    if (this != &source) writeFromNonRT(*source.readFromNonRT());
    return *this;
  }

  /// The value that was written last, or the one before while a write is under way. It does not
  /// change until the next call.
  T* readFromRT() {
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (lock.owns_lock() && is_newer_) {
      std::swap(realtime_, other_);
      is_newer_ = false;
    }
    return realtime_.get();
  }
  T* readFromNonRT() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return (is_newer_ ? other_ : realtime_).get();
  }
  void writeFromNonRT(const T& data) {
    const std::lock_guard<std::mutex> lock(mutex_);
    *other_ = data;
    is_newer_ = true;
  }
  /// Both sides, before anybody reads.
  void initRT(const T& data) {
    *realtime_ = data;
    *other_ = data;
  }
  void reset() {
    const std::lock_guard<std::mutex> lock(mutex_);
    realtime_ = std::make_unique<T>();
    other_ = std::make_unique<T>();
    is_newer_ = false;
  }

 private:
  mutable std::mutex mutex_;
  std::unique_ptr<T> realtime_;
  std::unique_ptr<T> other_;
  bool is_newer_ = false;  ///< what the other one has
};

}  // namespace realtime_tools
