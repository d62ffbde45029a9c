// Services.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/any_service_callback.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/detail/executable.hpp"
#include "rclcpp/detail/inbox.hpp"
#include "rclcpp/detail/known_services.hpp"
#include "rclcpp/detail/message_type.hpp"
#include "rclcpp/detail/service_events.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/types.h"

namespace rclcpp {

namespace node_interfaces {
class NodeBaseInterface;
}

class Context;

class ServiceBase : public detail::Executable, public std::enable_shared_from_this<ServiceBase> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(ServiceBase)

  ServiceBase(node_interfaces::NodeBaseInterface* node_base, const std::string& service_name,
              const rosidl_service_type_support_t& type_support, const rclcpp::QoS& qos);
  ~ServiceBase() override;

  const char* get_service_name() { return service_name_.c_str(); }
  bool take_type_erased_request(void* request_out, rmw_request_id_t& request_id_out);
  virtual std::shared_ptr<void> create_request() = 0;
  virtual std::shared_ptr<rmw_request_id_t> create_request_header() {
    return std::make_shared<rmw_request_id_t>();
  }
  virtual void handle_request(std::shared_ptr<rmw_request_id_t> request_header,
                              std::shared_ptr<void> request) = 0;
  bool exchange_in_use_by_wait_set_state(bool in_use_state) {
    return in_use_by_wait_set_.exchange(in_use_state);
  }
  rclcpp::QoS get_response_publisher_actual_qos() const { return qos_; }
  rclcpp::QoS get_request_subscription_actual_qos() const { return qos_; }
  /// Called with the number of requests that came, by whoever waits next in this process; they stay
  /// to be taken.
  void set_on_new_request_callback(std::function<void(size_t)> callback);
  void clear_on_new_request_callback() { inbox_.stop_listening(); }

  /// Tells what happens here on `<service>/_service_event`: nothing, that it happens, or all of it.
  void configure_introspection(Clock::SharedPtr clock, const QoS& qos_service_event_pub,
                               rcl_service_introspection_state_t introspection_state);

  int32_t ready_endpoint() const override { return inbox_.ready_endpoint(); }
  bool polls() const override { return inbox_.polls(); }
  bool is_ready_now() override { return inbox_.has_kept(); }
  bool run(std::shared_ptr<void>& data) override;

 protected:
  void send_response_object(const rmw_request_id_t& request_id, const void* response);

  std::shared_ptr<rclcpp::Context> context_;

 private:
  RCLCPP_DISABLE_COPY(ServiceBase)
  const std::string service_name_;
  std::string logger_name_;
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
class Service : public ServiceBase {
 public:
  using CallbackType = std::function<void(const std::shared_ptr<typename ServiceT::Request>,
                                          std::shared_ptr<typename ServiceT::Response>)>;
  using CallbackWithHeaderType = std::function<void(
      const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<typename ServiceT::Request>,
      std::shared_ptr<typename ServiceT::Response>)>;

  RCLCPP_SMART_PTR_DEFINITIONS(Service)

  Service(node_interfaces::NodeBaseInterface* node_base, const std::string& service_name,
          AnyServiceCallback<ServiceT> callback, const rclcpp::QoS& qos)
      : ServiceBase(node_base, service_name,
                    *rosidl_typesupport_cpp::get_service_type_support_handle<ServiceT>(), qos),
        callback_(std::move(callback)) {
    detail::know_service<ServiceT>();
  }

  bool take_request(typename ServiceT::Request& request_out, rmw_request_id_t& request_id_out) {
    return this->take_type_erased_request(&request_out, request_id_out);
  }
  std::shared_ptr<void> create_request() override {
    return std::make_shared<typename ServiceT::Request>();
  }
  void handle_request(std::shared_ptr<rmw_request_id_t> request_header,
                      std::shared_ptr<void> request) override {
    const auto response = callback_.dispatch(
        std::static_pointer_cast<Service>(this->shared_from_this()), request_header,
        std::static_pointer_cast<typename ServiceT::Request>(request));
    if (response) {
      send_response(*request_header, *response);
    }
  }
  void send_response(rmw_request_id_t& req_id, typename ServiceT::Response& response) {
    this->send_response_object(req_id, &response);
  }

 private:
  RCLCPP_DISABLE_COPY(Service)
  AnyServiceCallback<ServiceT> callback_;
};

}  // namespace rclcpp
