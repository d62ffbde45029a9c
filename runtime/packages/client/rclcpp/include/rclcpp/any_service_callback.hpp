// Any of the forms a service's callback may have, as one function.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rmw/types.h"

namespace rclcpp {

template <typename ServiceT>
class Service;

template <typename ServiceT>
class AnyServiceCallback {
 public:
  using SharedRequest = std::shared_ptr<typename ServiceT::Request>;
  using SharedResponse = std::shared_ptr<typename ServiceT::Response>;
  using SharedHeader = std::shared_ptr<rmw_request_id_t>;
  using SharedService = std::shared_ptr<rclcpp::Service<ServiceT>>;

  template <typename CallbackT>
  void set(CallbackT callback) {
    if constexpr (std::is_invocable_v<CallbackT&, SharedRequest, SharedResponse>) {
      function_ = [callback = std::move(callback)](const SharedService&, const SharedHeader&,
                                                   SharedRequest request) mutable {
        auto response = std::make_shared<typename ServiceT::Response>();
        callback(std::move(request), response);
        return response;
      };
    } else if constexpr (std::is_invocable_v<CallbackT&, SharedHeader, SharedRequest,
                                             SharedResponse>) {
      function_ = [callback = std::move(callback)](const SharedService&, const SharedHeader& header,
                                                   SharedRequest request) mutable {
        auto response = std::make_shared<typename ServiceT::Response>();
        callback(header, std::move(request), response);
        return response;
      };
    } else if constexpr (std::is_invocable_v<CallbackT&, SharedHeader, SharedRequest>) {
      function_ = [callback = std::move(callback)](const SharedService&, const SharedHeader& header,
                                                   SharedRequest request) mutable {
        callback(header, std::move(request));
        return SharedResponse();
      };
    } else if constexpr (std::is_invocable_v<CallbackT&, SharedService, SharedHeader,
                                             SharedRequest>) {
      function_ = [callback = std::move(callback)](const SharedService& service,
                                                   const SharedHeader& header,
                                                   SharedRequest request) mutable {
        callback(service, header, std::move(request));
        return SharedResponse();
      };
    } else {
      static_assert(detail::always_false_v<CallbackT>,
                    "a service callback takes (shared_ptr<Request>, shared_ptr<Response>), with "
                    "or without a shared_ptr<rmw_request_id_t> in front, or answers later: "
                    "(shared_ptr<rmw_request_id_t>, shared_ptr<Request>), with or without a "
                    "shared_ptr<Service> in front");
    }
  }

  /// The response, or null when the callback will send it later.
  SharedResponse dispatch(const SharedService& service, const SharedHeader& header,
                          SharedRequest request) {
    if (!function_) {
      throw std::runtime_error("unexpected request without any callback set");
    }
    return function_(service, header, std::move(request));
  }

 private:
  std::function<SharedResponse(const SharedService&, const SharedHeader&, SharedRequest)> function_;
};

}  // namespace rclcpp
