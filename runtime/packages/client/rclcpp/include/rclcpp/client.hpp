// Clients of services.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rclcpp/clock.hpp"
#include "rclcpp/detail/executable.hpp"
#include "rclcpp/detail/inbox.hpp"
#include "rclcpp/detail/known_services.hpp"
#include "rclcpp/detail/message_type.hpp"
#include "rclcpp/detail/service_events.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/types.h"

namespace rclcpp {

namespace node_interfaces {
class NodeBaseInterface;
class NodeGraphInterface;
}  // namespace node_interfaces

class Context;

namespace detail {

/// A future and the number of the request that it answers.
template <typename FutureT>
struct FutureAndRequestId {
  FutureT future;
  int64_t request_id;

  FutureAndRequestId(FutureT impl, int64_t req_id) : future(std::move(impl)), request_id(req_id) {}
  FutureAndRequestId(const FutureAndRequestId& other) = delete;
  FutureAndRequestId& operator=(const FutureAndRequestId& other) = delete;
  FutureAndRequestId(FutureAndRequestId&& other) noexcept = default;
  FutureAndRequestId& operator=(FutureAndRequestId&& other) noexcept = default;
  ~FutureAndRequestId() = default;

  operator FutureT&() { return future; }  // NOLINT: conversion wanted
  auto get() { return future.get(); }
  bool valid() const noexcept { return future.valid(); }
  void wait() const { future.wait(); }
  template <class Rep, class Period>
  std::future_status wait_for(const std::chrono::duration<Rep, Period>& timeout) const {
    return future.wait_for(timeout);
  }
  template <class Clock, class Duration>
  std::future_status wait_until(
      const std::chrono::time_point<Clock, Duration>& timeout_time) const {
    return future.wait_until(timeout_time);
  }
};

}  // namespace detail

class ClientBase : public detail::Executable, public std::enable_shared_from_this<ClientBase> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(ClientBase)

  ClientBase(node_interfaces::NodeBaseInterface* node_base, const std::string& service_name,
             const rosidl_service_type_support_t& type_support, const rclcpp::QoS& qos);
  ~ClientBase() override;

  const char* get_service_name() const { return service_name_.c_str(); }
  bool service_is_ready() const;
  /// False after the timeout, or when the context is shut down. Negative: waits for ever.
  template <typename RepT = int64_t, typename RatioT = std::milli>
  bool wait_for_service(
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return wait_for_service_nanoseconds(
        std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }
  virtual std::shared_ptr<void> create_response() = 0;
  virtual std::shared_ptr<rmw_request_id_t> create_request_header() {
    return std::make_shared<rmw_request_id_t>();
  }
  virtual void handle_response(std::shared_ptr<rmw_request_id_t> request_header,
                               std::shared_ptr<void> response) = 0;
  bool take_type_erased_response(void* response_out, rmw_request_id_t& request_header_out);
  bool exchange_in_use_by_wait_set_state(bool in_use_state) {
    return in_use_by_wait_set_.exchange(in_use_state);
  }
  rclcpp::QoS get_request_publisher_actual_qos() const { return qos_; }
  rclcpp::QoS get_response_subscription_actual_qos() const { return qos_; }
  /// Called with the number of responses that came, by whoever waits next in this process; they
  /// stay to be taken.
  void set_on_new_response_callback(std::function<void(size_t)> callback);
  void clear_on_new_response_callback() { inbox_.stop_listening(); }

  /// Tells what happens here on `<service>/_service_event`: nothing, that it happens, or all of it.
  void configure_introspection(Clock::SharedPtr clock, const QoS& qos_service_event_pub,
                               rcl_service_introspection_state_t introspection_state);

  int32_t ready_endpoint() const override { return inbox_.ready_endpoint(); }
  bool polls() const override { return inbox_.polls(); }
  bool is_ready_now() override { return inbox_.has_kept(); }
  bool run(std::shared_ptr<void>& data) override;

 protected:
  bool wait_for_service_nanoseconds(std::chrono::nanoseconds timeout);
  /// Sends a request; returns its number. Throws RCLError when the bus refuses it.
  int64_t send_request_object(const void* request);

  std::shared_ptr<rclcpp::Context> context_;

 private:
  RCLCPP_DISABLE_COPY(ClientBase)
  const std::string service_name_;
  const rosidl_service_type_support_t& type_support_;
  const rclcpp::QoS qos_;
  const int32_t node_id_;
  const std::shared_ptr<void> type_use_;
  std::shared_ptr<ros2wasm::Endpoint> endpoint_;
  detail::Inbox inbox_;
  std::shared_ptr<detail::ServiceEvents> events_;
  std::atomic<bool> in_use_by_wait_set_{false};
};

template <typename ServiceT>
class Client : public ClientBase {
 public:
  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;
  using SharedRequest = typename ServiceT::Request::SharedPtr;
  using SharedResponse = typename ServiceT::Response::SharedPtr;

  using Promise = std::promise<SharedResponse>;
  using PromiseWithRequest = std::promise<std::pair<SharedRequest, SharedResponse>>;
  using SharedPromise = std::shared_ptr<Promise>;
  using SharedPromiseWithRequest = std::shared_ptr<PromiseWithRequest>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using SharedFutureWithRequest = std::shared_future<std::pair<SharedRequest, SharedResponse>>;
  using CallbackType = std::function<void(SharedFuture)>;
  using CallbackWithRequestType = std::function<void(SharedFutureWithRequest)>;

  RCLCPP_SMART_PTR_DEFINITIONS(Client)

  struct FutureAndRequestId : detail::FutureAndRequestId<std::future<SharedResponse>> {
    using detail::FutureAndRequestId<std::future<SharedResponse>>::FutureAndRequestId;
    SharedFuture share() noexcept { return this->future.share(); }
  };
  struct SharedFutureAndRequestId : detail::FutureAndRequestId<std::shared_future<SharedResponse>> {
    using detail::FutureAndRequestId<std::shared_future<SharedResponse>>::FutureAndRequestId;
  };
  struct SharedFutureWithRequestAndRequestId
      : detail::FutureAndRequestId<std::shared_future<std::pair<SharedRequest, SharedResponse>>> {
    using detail::FutureAndRequestId<
        std::shared_future<std::pair<SharedRequest, SharedResponse>>>::FutureAndRequestId;
  };

  Client(node_interfaces::NodeBaseInterface* node_base, const std::string& service_name,
         const rclcpp::QoS& qos)
      : ClientBase(node_base, service_name,
                   *rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), qos) {
    detail::know_service<ServiceT>();
  }

  bool take_response(Response& response_out, rmw_request_id_t& request_header_out) {
    return this->take_type_erased_response(&response_out, request_header_out);
  }
  std::shared_ptr<void> create_response() override { return std::make_shared<Response>(); }

  void handle_response(std::shared_ptr<rmw_request_id_t> request_header,
                       std::shared_ptr<void> response) override {
    std::function<void(SharedResponse)> finish;
    {
      const std::lock_guard<std::mutex> lock(pending_mutex_);
      const auto found = pending_.find(request_header->sequence_number);
      if (found == pending_.end()) {
        return;
      }
      finish = std::move(found->second.finish);
      pending_.erase(found);
    }
    finish(std::static_pointer_cast<Response>(std::move(response)));
  }

  FutureAndRequestId async_send_request(SharedRequest request) {
    auto promise = std::make_shared<Promise>();
    auto future = promise->get_future();
    const int64_t id = send(
        *request, [promise](SharedResponse response) { promise->set_value(std::move(response)); });
    return FutureAndRequestId(std::move(future), id);
  }

  template <typename CallbackT,
            std::enable_if_t<std::is_invocable_v<CallbackT&, SharedFuture>>* = nullptr>
  SharedFutureAndRequestId async_send_request(SharedRequest request, CallbackT&& cb) {
    auto promise = std::make_shared<Promise>();
    SharedFuture future(promise->get_future());
    const int64_t id =
        send(*request, [promise, future, callback = CallbackType(std::forward<CallbackT>(cb))](
                           SharedResponse response) {
          promise->set_value(std::move(response));
          callback(future);
        });
    return SharedFutureAndRequestId(std::move(future), id);
  }

  template <typename CallbackT,
            std::enable_if_t<!std::is_invocable_v<CallbackT&, SharedFuture> &&
                             std::is_invocable_v<CallbackT&, SharedFutureWithRequest>>* = nullptr>
  SharedFutureWithRequestAndRequestId async_send_request(SharedRequest request, CallbackT&& cb) {
    auto promise = std::make_shared<PromiseWithRequest>();
    SharedFutureWithRequest future(promise->get_future());
    const int64_t id = send(
        *request,
        [promise, future, request,
         callback = CallbackWithRequestType(std::forward<CallbackT>(cb))](SharedResponse response) {
          promise->set_value(std::make_pair(request, std::move(response)));
          callback(future);
        });
    return SharedFutureWithRequestAndRequestId(std::move(future), id);
  }

  /// False when there was no such request.
  bool remove_pending_request(int64_t request_id) {
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    return pending_.erase(request_id) != 0;
  }
  bool remove_pending_request(const FutureAndRequestId& future) {
    return remove_pending_request(future.request_id);
  }
  bool remove_pending_request(const SharedFutureAndRequestId& future) {
    return remove_pending_request(future.request_id);
  }
  bool remove_pending_request(const SharedFutureWithRequestAndRequestId& future) {
    return remove_pending_request(future.request_id);
  }

  size_t prune_pending_requests() {
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    const size_t count = pending_.size();
    pending_.clear();
    return count;
  }

  template <typename AllocatorT = std::allocator<int64_t>>
  size_t prune_requests_older_than(std::chrono::time_point<std::chrono::system_clock> time_point,
                                   std::vector<int64_t, AllocatorT>* pruned_requests = nullptr) {
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    size_t count = 0;
    for (auto it = pending_.begin(); it != pending_.end();) {
      if (it->second.sent < time_point) {
        if (pruned_requests != nullptr) {
          pruned_requests->push_back(it->first);
        }
        it = pending_.erase(it);
        ++count;
      } else {
        ++it;
      }
    }
    return count;
  }

 private:
  struct Pending {
    std::chrono::time_point<std::chrono::system_clock> sent;
    std::function<void(SharedResponse)> finish;
  };

  int64_t send(const Request& request, std::function<void(SharedResponse)> finish) {
    // Under the lock: the answer may come before the number is noted.
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    const int64_t id = this->send_request_object(&request);
    pending_[id] = Pending{std::chrono::system_clock::now(), std::move(finish)};
    return id;
  }

  RCLCPP_DISABLE_COPY(Client)
  std::mutex pending_mutex_;
  std::map<int64_t, Pending> pending_;
};

}  // namespace rclcpp
