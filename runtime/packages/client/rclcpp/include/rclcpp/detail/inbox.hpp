// The source from which a subscription, service or client takes its messages. While a callback
// listens for new messages, they are fetched from the bus to be counted, and stored here until they
// are taken.
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace detail {

class Inbox {
 public:
  using Accepts = std::function<bool(const ros2wasm::Bytes&, const ros2wasm::SampleInfo&)>;

  /// `depth`: how many are kept, the newest; 0: all. Those that `accepts` refuses are not counted.
  Inbox(std::shared_ptr<ros2wasm::Endpoint> endpoint, size_t depth, Accepts accepts = nullptr);
  ~Inbox() { stop_listening(); }
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  /// False when there is nothing.
  bool take(ros2wasm::Bytes& bytes, ros2wasm::SampleInfo& info);
  /// `callback` is told how many came, at once of those that wait to be taken.
  void listen(std::function<void(size_t)> callback);
  /// Returns after the last call of the callback.
  void stop_listening();
  /// For executors: none while it listens, for then what has come is here.
  int32_t ready_endpoint() const { return listens_ ? -1 : endpoint_->id(); }
  bool polls() const { return listens_ || kept_count_ > 0; }
  bool has_kept() const { return kept_count_ > 0; }

 private:
  struct Arrival {
    ros2wasm::Bytes bytes;
    ros2wasm::SampleInfo info;
  };
  void look();
  /// Returns how many came.
  size_t fetch();
  bool take_kept(ros2wasm::Bytes& bytes, ros2wasm::SampleInfo& info);

  const std::shared_ptr<ros2wasm::Endpoint> endpoint_;
  const size_t depth_;
  const Accepts accepts_;
  std::mutex mutex_;  // of kept_
  std::deque<Arrival> kept_;
  std::atomic<size_t> kept_count_{0};
  std::recursive_mutex callback_mutex_;
  std::function<void(size_t)> callback_;
  std::atomic<bool> listens_{false};
  std::shared_ptr<void> listener_;
};

}  // namespace detail
}  // namespace rclcpp
