// A client of a service whose type is known only by its name.
#pragma once

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

#include "rcl/client.h"
#include "rclcpp/client.hpp"
#include "rclcpp/detail/known_services.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

/// Differs from rclcpp on ROS machines: nothing is loaded at run time, so the program must use the
/// service type somewhere else too, in a client or a service, before.
class GenericClient : public ClientBase {
 public:
  /// A request message of the type, and what comes back.
  using Request = void*;
  using Response = void*;
  using SharedResponse = std::shared_ptr<void>;
  using Promise = std::promise<SharedResponse>;
  using SharedPromise = std::shared_ptr<Promise>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using CallbackType = std::function<void(SharedFuture)>;

  RCLCPP_SMART_PTR_DEFINITIONS(GenericClient)

  struct FutureAndRequestId : detail::FutureAndRequestId<Future> {
    using detail::FutureAndRequestId<Future>::FutureAndRequestId;
    SharedFuture share() noexcept { return this->future.share(); }
  };
  struct SharedFutureAndRequestId : detail::FutureAndRequestId<SharedFuture> {
    using detail::FutureAndRequestId<SharedFuture>::FutureAndRequestId;
  };

  /// Throws InvalidServiceTypeError for a type that the program does not have.
  GenericClient(node_interfaces::NodeBaseInterface* node_base,
                std::shared_ptr<node_interfaces::NodeGraphInterface> node_graph,
                const std::string& service_name, const std::string& service_type,
                const rcl_client_options_t& client_options);

  SharedResponse create_response() override { return service_.make_response(); }
  void handle_response(std::shared_ptr<rmw_request_id_t> request_header,
                       std::shared_ptr<void> response) override;

  FutureAndRequestId async_send_request(const Request request);
  template <typename CallbackT,
            std::enable_if_t<std::is_invocable_v<CallbackT&, SharedFuture>>* = nullptr>
  SharedFutureAndRequestId async_send_request(const Request request, CallbackT&& cb) {
    auto promise = std::make_shared<Promise>();
    SharedFuture future(promise->get_future());
    const int64_t id =
        send(request, [promise, future, callback = CallbackType(std::forward<CallbackT>(cb))](
                          SharedResponse response) {
          promise->set_value(std::move(response));
          callback(future);
        });
    return SharedFutureAndRequestId(std::move(future), id);
  }

  /// False when there was no such request.
  bool remove_pending_request(int64_t request_id);
  bool remove_pending_request(const FutureAndRequestId& future) {
    return remove_pending_request(future.request_id);
  }
  bool remove_pending_request(const SharedFutureAndRequestId& future) {
    return remove_pending_request(future.request_id);
  }
  size_t prune_pending_requests();
  template <typename AllocatorT = std::allocator<int64_t>>
  size_t prune_requests_older_than(std::chrono::time_point<std::chrono::system_clock> time_point,
                                   std::vector<int64_t, AllocatorT>* pruned_requests = nullptr) {
    const std::lock_guard<std::mutex> lock(pending_mutex_);
    size_t count = 0;
    for (auto it = pending_.begin(); it != pending_.end();) {
      if (it->second.sent >= time_point) {
        ++it;
        continue;
      }
      if (pruned_requests != nullptr) {
        pruned_requests->push_back(it->first);
      }
      it = pending_.erase(it);
      ++count;
    }
    return count;
  }
  bool take_response(Response response_out, rmw_request_id_t& request_header_out) {
    return this->take_type_erased_response(response_out, request_header_out);
  }

 private:
  struct Pending {
    std::chrono::time_point<std::chrono::system_clock> sent;
    std::function<void(SharedResponse)> finish;
  };
  GenericClient(node_interfaces::NodeBaseInterface* node_base, const std::string& service_name,
                const detail::KnownService& service, const rclcpp::QoS& qos);
  int64_t send(const void* request, std::function<void(SharedResponse)> finish);

  RCLCPP_DISABLE_COPY(GenericClient)
  const detail::KnownService& service_;
  std::mutex pending_mutex_;
  std::map<int64_t, Pending> pending_;
};

}  // namespace rclcpp
