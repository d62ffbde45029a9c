// Writes the events of a service. An event is made of its parts' bytes, so that no type needs code
// of its own for it: service_msgs/ServiceEventInfo info, Request[<=1] request, Response[<=1]
// response.
#include "rclcpp/detail/service_events.hpp"

#include <atomic>
#include <memory>
#include <stdexcept>
#include <utility>

#include "rclcpp/detail/bus_qos.hpp"
#include "rclcpp/detail/type_use.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace detail {
namespace {

using ros2wasm_typesupport::CdrSizer;
using ros2wasm_typesupport::CdrWriter;

constexpr size_t kGidSize = sizeof(ros2wasm::Gid);

class EventWriter : public ServiceEvents {
 public:
  EventWriter(int32_t node_id, const std::string& topic, const ServiceCallbacks& type,
              Clock::SharedPtr clock, const rclcpp::QoS& qos)
      : type_(type),
        clock_(std::move(clock)),
        type_use_(use_type(node_id, type.event_hash, type.event)),
        endpoint_(ros2wasm::EndpointKind::publisher, node_id, topic, type.event->type_name,
                  type.event_hash, to_bus(resolve_publisher_qos(qos, topic))) {}

  void set_state(rcl_service_introspection_state_t state) override { state_ = state; }

  void tell(ServiceEventKind kind, const uint8_t* client_gid, int64_t sequence_number,
            const void* message) override {
    const bool is_request =
        kind == ServiceEventKind::request_sent || kind == ServiceEventKind::request_received;
    const MessageCallbacks& part = is_request ? *type_.request : *type_.response;
    const bool whole = state_ == RCL_SERVICE_INTROSPECTION_CONTENTS;

    CdrSizer sizer;
    sizer.add(sizeof(uint8_t), 1);
    sizer.add(2 * sizeof(uint32_t), sizeof(uint32_t));
    sizer.add(kGidSize, 1);
    sizer.add(sizeof(int64_t), sizeof(int64_t));
    sizer.add(sizeof(uint32_t), sizeof(uint32_t));
    if (whole) {
      part.size(sizer, message);
    }
    sizer.add(sizeof(uint32_t), sizeof(uint32_t));

    ros2wasm::Bytes bytes(sizer.total());
    CdrWriter writer(bytes.data(), bytes.size());
    const int64_t now = clock_->now().nanoseconds();
    constexpr int64_t kSecond = 1'000'000'000;
    writer.put(static_cast<uint8_t>(kind));
    writer.put(static_cast<int32_t>(now / kSecond));
    writer.put(static_cast<uint32_t>(now % kSecond));
    writer.put_bytes(client_gid, kGidSize, 1);
    writer.put(sequence_number);
    const auto put_part = [&](bool is_this) {
      writer.put_count(is_this && whole ? 1 : 0);
      if (is_this && whole) {
        part.write(writer, message);
      }
    };
    put_part(is_request);
    put_part(!is_request);

    // An event that cannot be written does not stop the call.
    const size_t size = writer.finish();
    if (size != 0) {
      ros2wasm::SampleInfo info{};
      info.source_timestamp_ns = ros2wasm::system_now_ns();
      endpoint_.write(bytes.data(), size, info);
    }
  }

 private:
  const ServiceCallbacks& type_;
  const Clock::SharedPtr clock_;
  const std::shared_ptr<void> type_use_;
  ros2wasm::Endpoint endpoint_;
  std::atomic<rcl_service_introspection_state_t> state_{RCL_SERVICE_INTROSPECTION_METADATA};
};

}  // namespace

void configure_service_events(std::shared_ptr<ServiceEvents>& events, int32_t node_id,
                              const std::string& service_name, const ServiceCallbacks& type,
                              Clock::SharedPtr clock, const rclcpp::QoS& qos,
                              rcl_service_introspection_state_t state) {
  std::shared_ptr<ServiceEvents> next = std::atomic_load(&events);
  if (state == RCL_SERVICE_INTROSPECTION_OFF) {
    next = nullptr;
  } else {
    if (!clock) {
      throw std::invalid_argument("clock cannot be null");
    }
    if (!next) {
      next = std::make_shared<EventWriter>(node_id,
                                           service_name + RCL_SERVICE_INTROSPECTION_TOPIC_POSTFIX,
                                           type, std::move(clock), qos);
    }
    next->set_state(state);
  }
  std::atomic_store(&events, std::move(next));
}

}  // namespace detail
}  // namespace rclcpp
