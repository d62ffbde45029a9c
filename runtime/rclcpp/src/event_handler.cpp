// Reading event counters off the bus.
#include "rclcpp/event_handler.hpp"

#include "ros2wasm/endpoint.hpp"

namespace rclcpp {

EventHandlerBase::EventHandlerBase(std::shared_ptr<ros2wasm::Endpoint> endpoint, int32_t event_type)
    : endpoint_(std::move(endpoint)),
      event_type_(event_type),
      seen_status_(ros2wasm::status_version()) {
  if (!read()) {
    rcutils_set_error_state("the bus does not know this event", __FILE__, __LINE__);
    const exceptions::RCLErrorBase error(RCL_RET_UNSUPPORTED, rcl_get_error_state());
    rcl_reset_error();
    throw UnsupportedEventTypeException(error, "Failed to initialize event");
  }
}

EventHandlerBase::~EventHandlerBase() = default;

bool EventHandlerBase::read() {
  ros2wasm::EndpointStatus status{};
  if (!endpoint_->status(event_type_, status)) {
    return false;
  }
  counts_.total_count = status.total_count;
  counts_.current_count = status.current_count;
  counts_.total_change += status.total_change;
  counts_.current_change += status.current_change;
  counts_.last_policy = status.last_policy;
  pending_ = pending_ || status.total_change != 0 || status.current_change != 0;
  return true;
}

bool EventHandlerBase::is_ready() {
  const int32_t status = ros2wasm::status_version();
  if (status != seen_status_) {
    seen_status_ = status;
    read();
  }
  return pending_;
}

std::shared_ptr<void> EventHandlerBase::take_data() {
  auto data = std::make_shared<EventCounts>(counts_);
  counts_ = EventCounts();
  pending_ = false;
  return data;
}

namespace detail {

void fill(rmw_offered_deadline_missed_status_t& info, const EventCounts& counts) {
  info.total_count = counts.total_count;
  info.total_count_change = counts.total_change;
}
void fill(rmw_requested_deadline_missed_status_t& info, const EventCounts& counts) {
  info.total_count = counts.total_count;
  info.total_count_change = counts.total_change;
}
// The bus counts the living as current and those that are not alive as total.
void fill(rmw_liveliness_changed_status_t& info, const EventCounts& counts) {
  info.alive_count = counts.current_count;
  info.alive_count_change = counts.current_change;
  info.not_alive_count = counts.total_count;
  info.not_alive_count_change = counts.total_change;
}
void fill(rmw_liveliness_lost_status_t& info, const EventCounts& counts) {
  info.total_count = counts.total_count;
  info.total_count_change = counts.total_change;
}
void fill(rmw_message_lost_status_t& info, const EventCounts& counts) {
  info.total_count = static_cast<size_t>(counts.total_count);
  info.total_count_change = static_cast<size_t>(counts.total_change);
}
void fill(rmw_qos_incompatible_event_status_t& info, const EventCounts& counts) {
  info.total_count = counts.total_count;
  info.total_count_change = counts.total_change;
  info.last_policy_kind = static_cast<rmw_qos_policy_kind_t>(counts.last_policy);
}
void fill(rmw_incompatible_type_status_t& info, const EventCounts& counts) {
  info.total_count = counts.total_count;
  info.total_count_change = counts.total_change;
}
void fill(rmw_matched_status_t& info, const EventCounts& counts) {
  info.total_count = static_cast<size_t>(counts.total_count);
  info.total_count_change = static_cast<size_t>(counts.total_change);
  info.current_count = static_cast<size_t>(counts.current_count);
  info.current_count_change = counts.current_change;
}

}  // namespace detail
}  // namespace rclcpp
