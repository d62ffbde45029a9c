// The result of a wait: what is ready, while it is held.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

#include "rclcpp/client.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/wait_result_kind.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp {

template <class WaitSetT>
class WaitResult final {
 public:
  static WaitResult from_ready_wait_result_kind(WaitSetT& wait_set) {
    return WaitResult(WaitResultKind::Ready, &wait_set);
  }
  static WaitResult from_timeout_wait_result_kind() {
    return WaitResult(WaitResultKind::Timeout, nullptr);
  }
  static WaitResult from_empty_wait_result_kind() {
    return WaitResult(WaitResultKind::Empty, nullptr);
  }

  WaitResultKind kind() const { return kind_; }
  /// Throws std::runtime_error unless the result is Ready.
  const WaitSetT& get_wait_set() const { return checked(); }
  WaitSetT& get_wait_set() { return checked(); }

  WaitResult(WaitResult&& other) noexcept
      : kind_(other.kind_), wait_set_(std::exchange(other.wait_set_, nullptr)) {}
  ~WaitResult() {
    if (wait_set_ != nullptr) {
      wait_set_->wait_result_release();
    }
  }

  /// The next ready timer at or after the index, and its index; it stays ready until cleared.
  std::pair<std::shared_ptr<rclcpp::TimerBase>, size_t> peek_next_ready_timer(
      size_t start_index = 0) {
    size_t index = start_index;
    if (kind_ == WaitResultKind::Ready) {
      for (; index < wait_set_->size_of_timers(); ++index) {
        if (wait_set_->get_rcl_wait_set().timers[index] != nullptr) {
          return {wait_set_->timers(index), index};
        }
      }
    }
    return {nullptr, index};
  }
  void clear_timer_with_index(size_t index) {
    if (index >= checked().size_of_timers()) {
      throw std::out_of_range("given timer index is out of range");
    }
    wait_set_->ready_view().timers[index] = nullptr;
  }
  /// Each gives a ready entity once; null when there is no more.
  std::shared_ptr<rclcpp::SubscriptionBase> next_ready_subscription() {
    return next(&WaitSetT::size_of_subscriptions, &WaitSetT::subscriptions,
                [](auto& view) { return view.subscriptions; });
  }
  std::shared_ptr<rclcpp::ServiceBase> next_ready_service() {
    return next(&WaitSetT::size_of_services, &WaitSetT::services,
                [](auto& view) { return view.services; });
  }
  std::shared_ptr<rclcpp::ClientBase> next_ready_client() {
    return next(&WaitSetT::size_of_clients, &WaitSetT::clients,
                [](auto& view) { return view.clients; });
  }
  std::shared_ptr<rclcpp::Waitable> next_ready_waitable() {
    while (kind_ == WaitResultKind::Ready && next_waitable_ < wait_set_->size_of_waitables()) {
      const size_t i = next_waitable_++;
      if (wait_set_->take_waitable(i)) {
        return wait_set_->waitables(i);
      }
    }
    return nullptr;
  }

 private:
  RCLCPP_DISABLE_COPY(WaitResult)
  WaitResult(WaitResultKind kind, WaitSetT* wait_set) : kind_(kind), wait_set_(wait_set) {
    if (wait_set_ != nullptr) {
      wait_set_->wait_result_acquire();
    }
  }
  WaitSetT& checked() const {
    if (kind_ != WaitResultKind::Ready) {
      throw std::runtime_error("cannot access wait set when the result was not ready");
    }
    return *wait_set_;
  }
  template <typename EntityT, typename FlagsT>
  std::shared_ptr<EntityT> next(size_t (WaitSetT::*size)() const,
                                std::shared_ptr<EntityT> (WaitSetT::*get)(size_t) const,
                                FlagsT flags) {
    if (kind_ == WaitResultKind::Ready) {
      auto* ready = flags(wait_set_->ready_view());
      for (size_t i = 0; i < (wait_set_->*size)(); ++i) {
        if (ready[i] != nullptr) {
          ready[i] = nullptr;
          return (wait_set_->*get)(i);
        }
      }
    }
    return nullptr;
  }

  WaitResultKind kind_;
  WaitSetT* wait_set_;
  size_t next_waitable_ = 0;
};

}  // namespace rclcpp
