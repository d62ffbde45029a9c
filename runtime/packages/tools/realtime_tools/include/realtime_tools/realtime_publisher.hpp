// A publisher for loops that must not wait. Publishing does not wait here, so it is done at once,
// without a thread: such a node runs on every page.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "rclcpp/rclcpp.hpp"

namespace realtime_tools {

template <class MessageT>
class RealtimePublisher {
 public:
  using PublisherType = rclcpp::Publisher<MessageT>;
  using PublisherSharedPtr = typename PublisherType::SharedPtr;
  using SharedPtr = std::shared_ptr<RealtimePublisher<MessageT>>;
  using UniquePtr = std::unique_ptr<RealtimePublisher<MessageT>>;

  /// The message that unlockAndPublish() publishes.
  MessageT msg_;

  explicit RealtimePublisher(PublisherSharedPtr publisher) : publisher_(std::move(publisher)) {}
  RealtimePublisher(const RealtimePublisher&) = delete;
  RealtimePublisher& operator=(const RealtimePublisher&) = delete;

  void stop() { is_stopped_ = true; }
  bool trylock() { return mutex_.try_lock(); }
  void lock() { mutex_.lock(); }
  void unlock() { mutex_.unlock(); }
  void unlockAndPublish() {
    if (!is_stopped_) publisher_->publish(msg_);
    unlock();
  }
  [[nodiscard]] bool can_publish() const {
    return std::unique_lock<std::mutex>(mutex_, std::try_to_lock).owns_lock();
  }
  /// False when somebody holds the lock.
  bool try_publish(const MessageT& message) {
    if (!trylock()) return false;
    msg_ = message;
    unlockAndPublish();
    return true;
  }
  bool tryPublish(const MessageT& message) { return try_publish(message); }
  [[nodiscard]] const MessageT& get_msg() const { return msg_; }
  [[nodiscard]] std::mutex& get_mutex() { return mutex_; }

 private:
  PublisherSharedPtr publisher_;
  mutable std::mutex mutex_;
  bool is_stopped_ = false;
};

template <class MessageT>
using RealtimePublisherSharedPtr = std::shared_ptr<RealtimePublisher<MessageT>>;

}  // namespace realtime_tools
