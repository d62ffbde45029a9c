// Fetching, counting and keeping what comes.
#include "rclcpp/detail/inbox.hpp"

#include <utility>

#include "rclcpp/detail/executable.hpp"
#include "rclcpp/detail/listeners.hpp"

namespace rclcpp {
namespace detail {

Inbox::Inbox(std::shared_ptr<ros2wasm::Endpoint> endpoint, size_t depth, Accepts accepts)
    : endpoint_(std::move(endpoint)), depth_(depth), accepts_(std::move(accepts)) {}

bool Inbox::take(ros2wasm::Bytes& bytes, ros2wasm::SampleInfo& info) {
  if (listens_) {
    look();
  }
  return take_kept(bytes, info) || (!listens_ && endpoint_->take(bytes, info));
}

bool Inbox::take_kept(ros2wasm::Bytes& bytes, ros2wasm::SampleInfo& info) {
  if (kept_count_ == 0) {
    return false;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (kept_.empty()) {
    return false;
  }
  bytes = std::move(kept_.front().bytes);
  info = kept_.front().info;
  kept_.pop_front();
  kept_count_ = kept_.size();
  return true;
}

size_t Inbox::fetch() {
  size_t count = 0;
  while (true) {
    // A new one each time: its bytes are given away.
    Arrival arrival{};
    if (!endpoint_->take(arrival.bytes, arrival.info)) {
      return count;
    }
    if (accepts_ && !accepts_(arrival.bytes, arrival.info)) {
      continue;
    }
    ++count;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (depth_ > 0 && kept_.size() >= depth_) {
      kept_.pop_front();
    }
    kept_.push_back(std::move(arrival));
    kept_count_ = kept_.size();
  }
}

void Inbox::look() {
  const std::lock_guard<std::recursive_mutex> lock(callback_mutex_);
  if (!callback_) {
    return;
  }
  const size_t count = fetch();
  if (count == 0) {
    return;
  }
  // Executors that rest see it only now.
  ros2wasm::wake();
  // A copy: it may be cleared meanwhile.
  const auto callback = callback_;
  callback(count);
}

void Inbox::listen(std::function<void(size_t)> callback) {
  {
    const std::lock_guard<std::recursive_mutex> lock(callback_mutex_);
    callback_ = std::move(callback);
    listens_ = true;
    fetch();
    if (const size_t waiting = kept_count_; waiting > 0) {
      const auto told = callback_;
      told(waiting);
    }
  }
  if (!listener_) {
    listener_ = add_listener([this] { look(); });
  }
  bump_entities_version();
}

void Inbox::stop_listening() {
  if (!listens_) {
    return;
  }
  listener_.reset();
  {
    const std::lock_guard<std::recursive_mutex> lock(callback_mutex_);
    callback_ = nullptr;
    listens_ = false;
  }
  bump_entities_version();
}

}  // namespace detail
}  // namespace rclcpp
