// Reading event counters off the bus.
#include "rclcpp/event_handler.hpp"

#include <algorithm>
#include <utility>

#include "rclcpp/detail/listeners.hpp"
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

EventHandlerBase::~EventHandlerBase() {
  clear_on_ready_callback();
}

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
  if (status.total_change != 0 || status.current_change != 0) {
    pending_ = true;
    untold_ += static_cast<size_t>(std::max(1, status.total_change));
  }
  return true;
}

bool EventHandlerBase::is_ready_now() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const int32_t status = ros2wasm::status_version();
  if (status != seen_status_) {
    seen_status_ = status;
    read();
  }
  return pending_;
}

bool EventHandlerBase::is_ready(const rcl_wait_set_t&) {
  return is_ready_now();
}

std::shared_ptr<void> EventHandlerBase::take_data() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  auto data = std::make_shared<EventCounts>(counts_);
  counts_ = EventCounts();
  pending_ = false;
  untold_ = 0;
  return data;
}

std::shared_ptr<void> EventHandlerBase::take_data_by_entity_id(size_t) {
  return take_data();
}

void EventHandlerBase::look() {
  std::function<void(size_t, int)> callback;
  size_t count = 0;
  {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    is_ready_now();
    if (!on_ready_callback_ || untold_ == 0) {
      return;
    }
    callback = on_ready_callback_;
    count = std::exchange(untold_, 0);
  }
  // Without the lock: an executor asks is_ready_now() under its own.
  callback(count, static_cast<int>(EntityType::Event));
}

void EventHandlerBase::set_on_ready_callback(std::function<void(size_t, int)> callback) {
  if (!callback) {
    throw std::invalid_argument("The callback passed to set_on_ready_callback is not callable.");
  }
  {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    on_ready_callback_ = detail::guarded<size_t, int>(this, "rclcpp::EventHandlerBase", "on ready",
                                                      std::move(callback));
  }
  look();
  if (!listener_) {
    listener_ = detail::add_listener([this] { look(); });
  }
}

void EventHandlerBase::set_on_new_event_callback(std::function<void(size_t)> callback) {
  if (!callback) {
    throw std::invalid_argument(
        "The callback passed to set_on_new_qos_event_callback is not callable.");
  }
  set_on_ready_callback([callback = std::move(callback)](size_t count, int) { callback(count); });
}

void EventHandlerBase::clear_on_ready_callback() {
  // First the listener: it may be looking in another thread.
  listener_.reset();
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  on_ready_callback_ = nullptr;
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
