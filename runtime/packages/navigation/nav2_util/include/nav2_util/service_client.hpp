// A client that waits for the answer, in an executor of its own.
#pragma once

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace nav2_util {

template <class ServiceT, typename NodeT = rclcpp::Node::SharedPtr>
class ServiceClient {
 public:
  using RequestType = typename ServiceT::Request;
  using ResponseType = typename ServiceT::Response;

  explicit ServiceClient(const std::string& service_name, const NodeT& provided_node)
      : service_name_(service_name), node_(provided_node) {
    callback_group_ =
        node_->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    callback_group_executor_.add_callback_group(callback_group_, node_->get_node_base_interface());
    client_ = node_->template create_client<ServiceT>(service_name, rclcpp::SystemDefaultsQoS(),
                                                      callback_group_);
  }

  /// Waits for the service, however long, and then for the answer. Throws std::runtime_error when
  /// no answer comes in time.
  typename ResponseType::SharedPtr invoke(
      typename RequestType::SharedPtr& request,
      const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1)) {
    typename ResponseType::SharedPtr response;
    if (!ask(request, timeout, response)) {
      throw std::runtime_error(service_name_ + " service client: async_send_request failed");
    }
    return response;
  }

  /// False: the node was stopped before the answer came.
  bool invoke(typename RequestType::SharedPtr& request,
              typename ResponseType::SharedPtr& response) {
    return ask(request, std::chrono::nanoseconds(-1), response) && response != nullptr;
  }

  bool wait_for_service(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds::max()) {
    return client_->wait_for_service(timeout);
  }

  std::string getServiceName() { return service_name_; }

  void stop() {
    if (client_) callback_group_executor_.cancel();
  }

 protected:
  std::string service_name_;
  NodeT node_;
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp::executors::SingleThreadedExecutor callback_group_executor_;
  typename rclcpp::Client<ServiceT>::SharedPtr client_;

 private:
  bool ask(const typename RequestType::SharedPtr& request, std::chrono::nanoseconds timeout,
           typename ResponseType::SharedPtr& response) {
    while (!client_->wait_for_service(std::chrono::seconds(1))) {
      if (!rclcpp::ok()) {
        throw std::runtime_error(service_name_ +
                                 " service client: interrupted while waiting for service");
      }
      RCLCPP_INFO(node_->get_logger(), "%s service client: waiting for service to appear...",
                  service_name_.c_str());
    }
    RCLCPP_DEBUG(node_->get_logger(), "%s service client: send async request",
                 service_name_.c_str());
    auto future = client_->async_send_request(request);
    if (callback_group_executor_.spin_until_future_complete(future, timeout) !=
        rclcpp::FutureReturnCode::SUCCESS) {
      client_->remove_pending_request(future);
      return false;
    }
    response = future.get();
    return true;
  }
};

}  // namespace nav2_util
