// Services and clients: requests and replies on the bus.
#include "rclcpp/service.hpp"

#include <cstring>
#include <stdexcept>
#include <vector>

#include "rclcpp/client.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/detail/background.hpp"
#include "rclcpp/detail/bus_qos.hpp"
#include "rclcpp/detail/listeners.hpp"
#include "rclcpp/detail/type_use.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace {

void tell(const std::shared_ptr<detail::ServiceEvents>& slot, detail::ServiceEventKind kind,
          const uint8_t* client_gid, int64_t sequence_number, const void* message) {
  if (const auto events = std::atomic_load(&slot)) {
    events->tell(kind, client_gid, sequence_number, message);
  }
}

std::shared_ptr<ros2wasm::Endpoint> make_endpoint(ros2wasm::EndpointKind kind,
                                                  node_interfaces::NodeBaseInterface* node,
                                                  const std::string& name,
                                                  const detail::ServiceCallbacks& type,
                                                  const rclcpp::QoS& qos) {
  return std::make_shared<ros2wasm::Endpoint>(kind, node->get_node_id(), name, type.type_name,
                                              type.type_hash, detail::to_bus(qos));
}

size_t kept_depth(const rclcpp::QoS& qos) {
  return qos.history() == HistoryPolicy::KeepAll ? 0 : qos.depth();
}

int32_t write_object(ros2wasm::Endpoint& endpoint, const detail::MessageCallbacks& type,
                     const void* object, ros2wasm::SampleInfo& info) {
  ros2wasm::Bytes bytes(type.serialized_size(object));
  const size_t size = type.serialize(object, bytes.data(), bytes.size());
  if (size == 0) {
    rcutils_set_error_state("a field is longer than its bound", __FILE__, __LINE__);
    return RCL_RET_ERROR;
  }
  info.source_timestamp_ns = ros2wasm::system_now_ns();
  const int32_t result = endpoint.write(bytes.data(), size, info);
  if (result < 0) {
    const std::string text = "the bus refused it, error " + std::to_string(result);
    rcutils_set_error_state(text.c_str(), __FILE__, __LINE__);
    return RCL_RET_ERROR;
  }
  return RCL_RET_OK;
}

}  // namespace

ServiceBase::ServiceBase(node_interfaces::NodeBaseInterface* node_base,
                         const std::string& service_name,
                         const rosidl_service_type_support_t& type_support, const rclcpp::QoS& qos)
    : context_(node_base->get_context()),
      service_name_(node_base->resolve_topic_or_service_name(service_name, true)),
      logger_name_(node_base->get_logger_name()),
      type_support_(type_support),
      qos_(detail::resolve_qos(qos)),
      node_id_(node_base->get_node_id()),
      type_use_(detail::use_type(node_id_, detail::callbacks_of(type_support).type_hash,
                                 detail::callbacks_of(type_support).info)),
      endpoint_(make_endpoint(ros2wasm::EndpointKind::server, node_base, service_name_,
                              detail::callbacks_of(type_support), qos_)),
      inbox_(endpoint_, kept_depth(qos_)) {}

ServiceBase::~ServiceBase() {
  inbox_.stop_listening();
  detail::bump_entities_version();
}

bool ServiceBase::take_type_erased_request(void* request_out, rmw_request_id_t& request_id_out) {
  ros2wasm::Bytes bytes;
  ros2wasm::SampleInfo info{};
  while (inbox_.take(bytes, info)) {
    if (detail::callbacks_of(type_support_)
            .request->deserialize(bytes.data(), bytes.size(), request_out)) {
      std::memcpy(request_id_out.writer_guid, info.writer_gid, sizeof(info.writer_gid));
      request_id_out.sequence_number = info.sequence;
      tell(events_, detail::ServiceEventKind::request_received, info.writer_gid, info.sequence,
           request_out);
      return true;
    }
    RCLCPP_ERROR(rclcpp::get_logger(logger_name_),
                 "request for service '%s' cannot be read; it was dropped", get_service_name());
  }
  return false;
}

void ServiceBase::send_response_object(const rmw_request_id_t& request_id, const void* response) {
  ros2wasm::SampleInfo info{};
  std::memcpy(info.related_gid, request_id.writer_guid, sizeof(info.related_gid));
  info.related_sequence = request_id.sequence_number;
  const detail::MessageCallbacks& type = *detail::callbacks_of(type_support_).response;
  if (write_object(*endpoint_, type, response, info) != RCL_RET_OK && context_->is_valid()) {
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to send response");
  }
  tell(events_, detail::ServiceEventKind::response_sent, info.related_gid, info.related_sequence,
       response);
}

void ServiceBase::configure_introspection(Clock::SharedPtr clock, const QoS& qos_service_event_pub,
                                          rcl_service_introspection_state_t introspection_state) {
  detail::configure_service_events(events_, node_id_, service_name_,
                                   detail::callbacks_of(type_support_), std::move(clock),
                                   qos_service_event_pub, introspection_state);
}

void ServiceBase::set_on_new_request_callback(std::function<void(size_t)> callback) {
  if (!callback) {
    throw std::invalid_argument(
        "The callback passed to set_on_new_request_callback is not callable.");
  }
  inbox_.listen(
      detail::guarded<size_t>(this, "rclcpp::ServiceBase", "on new request", std::move(callback)));
}

bool ServiceBase::run(std::shared_ptr<void>&) {
  auto request = create_request();
  auto header = create_request_header();
  const bool taken = take_type_erased_request(request.get(), *header);
  if (taken) {
    handle_request(std::move(header), std::move(request));
  }
  return taken;
}

ClientBase::ClientBase(node_interfaces::NodeBaseInterface* node_base,
                       const std::string& service_name,
                       const rosidl_service_type_support_t& type_support, const rclcpp::QoS& qos)
    : context_(node_base->get_context()),
      service_name_(node_base->resolve_topic_or_service_name(service_name, true)),
      type_support_(type_support),
      qos_(detail::resolve_qos(qos)),
      node_id_(node_base->get_node_id()),
      type_use_(detail::use_type(node_id_, detail::callbacks_of(type_support).type_hash,
                                 detail::callbacks_of(type_support).info)),
      endpoint_(make_endpoint(ros2wasm::EndpointKind::client, node_base, service_name_,
                              detail::callbacks_of(type_support), qos_)),
      inbox_(endpoint_, kept_depth(qos_)) {}

ClientBase::~ClientBase() {
  inbox_.stop_listening();
  detail::bump_entities_version();
}

bool ClientBase::service_is_ready() const {
  return endpoint_->matched() > 0;
}

bool ClientBase::wait_for_service_nanoseconds(std::chrono::nanoseconds timeout) {
  const bool limited = timeout.count() >= 0;
  const int64_t until = ros2wasm::steady_now_ns() + timeout.count();
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    if (service_is_ready()) {
      return true;
    }
    if (!context_->is_valid()) {
      return false;
    }
    detail::run_background();
    const int64_t left = limited ? until - ros2wasm::steady_now_ns() : -1;
    if (limited && left <= 0) {
      return false;
    }
    ros2wasm::wait(token, left);
  }
}

bool ClientBase::take_type_erased_response(void* response_out,
                                           rmw_request_id_t& request_header_out) {
  ros2wasm::Bytes bytes;
  ros2wasm::SampleInfo info{};
  while (inbox_.take(bytes, info)) {
    if (detail::callbacks_of(type_support_)
            .response->deserialize(bytes.data(), bytes.size(), response_out)) {
      std::memcpy(request_header_out.writer_guid, info.related_gid, sizeof(info.related_gid));
      request_header_out.sequence_number = info.related_sequence;
      tell(events_, detail::ServiceEventKind::response_received, endpoint_->gid().data(),
           info.related_sequence, response_out);
      return true;
    }
    RCLCPP_ERROR(rclcpp::get_logger("rclcpp"),
                 "response of service '%s' cannot be read; it was dropped", get_service_name());
  }
  return false;
}

int64_t ClientBase::send_request_object(const void* request) {
  ros2wasm::SampleInfo info{};
  const detail::MessageCallbacks& type = *detail::callbacks_of(type_support_).request;
  if (write_object(*endpoint_, type, request, info) != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to send request");
  }
  tell(events_, detail::ServiceEventKind::request_sent, endpoint_->gid().data(), info.sequence,
       request);
  return info.sequence;
}

void ClientBase::configure_introspection(Clock::SharedPtr clock, const QoS& qos_service_event_pub,
                                         rcl_service_introspection_state_t introspection_state) {
  detail::configure_service_events(events_, node_id_, service_name_,
                                   detail::callbacks_of(type_support_), std::move(clock),
                                   qos_service_event_pub, introspection_state);
}

void ClientBase::set_on_new_response_callback(std::function<void(size_t)> callback) {
  if (!callback) {
    throw std::invalid_argument(
        "The callback passed to set_on_new_response_callback is not callable.");
  }
  inbox_.listen(
      detail::guarded<size_t>(this, "rclcpp::ClientBase", "on new response", std::move(callback)));
}

bool ClientBase::run(std::shared_ptr<void>&) {
  auto response = create_response();
  auto header = create_request_header();
  const bool taken = take_type_erased_response(response.get(), *header);
  if (taken) {
    handle_response(std::move(header), std::move(response));
  }
  return taken;
}

}  // namespace rclcpp
