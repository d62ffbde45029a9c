// Events of publishers and subscriptions: deadlines, liveliness, matches, policies that do not fit.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "rcl/error_handling.h"
#include "rcl/event.h"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/function_traits.hpp"
#include "rclcpp/waitable.hpp"
#include "rmw/events_statuses.h"

namespace ros2wasm {
class Endpoint;
}

namespace rclcpp {

using QOSDeadlineRequestedInfo = rmw_requested_deadline_missed_status_t;
using QOSDeadlineOfferedInfo = rmw_offered_deadline_missed_status_t;
using QOSLivelinessChangedInfo = rmw_liveliness_changed_status_t;
using QOSLivelinessLostInfo = rmw_liveliness_lost_status_t;
using QOSMessageLostInfo = rmw_message_lost_status_t;
using QOSOfferedIncompatibleQoSInfo = rmw_offered_qos_incompatible_event_status_t;
using QOSRequestedIncompatibleQoSInfo = rmw_requested_qos_incompatible_event_status_t;
using IncompatibleTypeInfo = rmw_incompatible_type_status_t;
using MatchedInfo = rmw_matched_status_t;

using QOSDeadlineRequestedCallbackType = std::function<void(QOSDeadlineRequestedInfo&)>;
using QOSDeadlineOfferedCallbackType = std::function<void(QOSDeadlineOfferedInfo&)>;
using QOSLivelinessChangedCallbackType = std::function<void(QOSLivelinessChangedInfo&)>;
using QOSLivelinessLostCallbackType = std::function<void(QOSLivelinessLostInfo&)>;
using QOSMessageLostCallbackType = std::function<void(QOSMessageLostInfo&)>;
using QOSOfferedIncompatibleQoSCallbackType = std::function<void(QOSOfferedIncompatibleQoSInfo&)>;
using QOSRequestedIncompatibleQoSCallbackType =
    std::function<void(QOSRequestedIncompatibleQoSInfo&)>;
using IncompatibleTypeCallbackType = std::function<void(IncompatibleTypeInfo&)>;
using PublisherMatchedCallbackType = std::function<void(MatchedInfo&)>;
using SubscriptionMatchedCallbackType = std::function<void(MatchedInfo&)>;

struct PublisherEventCallbacks {
  QOSDeadlineOfferedCallbackType deadline_callback;
  QOSLivelinessLostCallbackType liveliness_callback;
  QOSOfferedIncompatibleQoSCallbackType incompatible_qos_callback;
  IncompatibleTypeCallbackType incompatible_type_callback;
  PublisherMatchedCallbackType matched_callback;
};

struct SubscriptionEventCallbacks {
  QOSDeadlineRequestedCallbackType deadline_callback;
  QOSLivelinessChangedCallbackType liveliness_callback;
  QOSRequestedIncompatibleQoSCallbackType incompatible_qos_callback;
  QOSMessageLostCallbackType message_lost_callback;
  IncompatibleTypeCallbackType incompatible_type_callback;
  SubscriptionMatchedCallbackType matched_callback;
};

class UnsupportedEventTypeException : public exceptions::RCLErrorBase, public std::runtime_error {
 public:
  UnsupportedEventTypeException(rcl_ret_t ret, const rcl_error_state_t* error_state,
                                const std::string& prefix)
      : UnsupportedEventTypeException(exceptions::RCLErrorBase(ret, error_state), prefix) {}
  UnsupportedEventTypeException(const exceptions::RCLErrorBase& base_exc, const std::string& prefix)
      : exceptions::RCLErrorBase(base_exc),
        std::runtime_error(prefix + (prefix.empty() ? "" : ": ") + base_exc.formatted_message) {}
};

/// The counters of the bus for all kinds of events; each kind reads its own fields.
struct EventCounts {
  int32_t total_count = 0;
  int32_t total_change = 0;
  int32_t current_count = 0;
  int32_t current_change = 0;
  int32_t last_policy = 0;
};

class EventHandlerBase : public Waitable {
 public:
  enum class EntityType : std::size_t { Event };

  EventHandlerBase(std::shared_ptr<ros2wasm::Endpoint> endpoint, int32_t event_type);
  ~EventHandlerBase() override;

  using Waitable::add_to_wait_set;
  using Waitable::is_ready;
  void add_to_wait_set(rcl_wait_set_t& wait_set) override { static_cast<void>(wait_set); }
  /// The bus counts events, so there is nothing of them in the wait set.
  bool is_ready(const rcl_wait_set_t& wait_set) override;
  std::shared_ptr<void> take_data() override;
  std::shared_ptr<void> take_data_by_entity_id(size_t id) override;
  /// Called with how often the event came and EntityType::Event, by whoever waits next in this
  /// process.
  void set_on_ready_callback(std::function<void(size_t, int)> callback) override;
  void clear_on_ready_callback() override;
  /// As set_on_ready_callback, without the kind.
  void set_on_new_event_callback(std::function<void(size_t)> callback);

  bool follows_status() const override { return true; }
  bool is_ready_now() override;

 private:
  /// Adds what changed to counts_; false when the endpoint has no such event.
  bool read();
  void look();

  std::shared_ptr<ros2wasm::Endpoint> endpoint_;
  const int32_t event_type_;
  int32_t seen_status_ = 0;
  EventCounts counts_;
  bool pending_ = false;
  size_t untold_ = 0;           // events that on_ready_callback_ was not told of
  std::recursive_mutex mutex_;  // of what is above from seen_status_ on, and the callback
  std::function<void(size_t, int)> on_ready_callback_;
  std::shared_ptr<void> listener_;
};

namespace detail {
void fill(rmw_offered_deadline_missed_status_t& info, const EventCounts& counts);
void fill(rmw_requested_deadline_missed_status_t& info, const EventCounts& counts);
void fill(rmw_liveliness_changed_status_t& info, const EventCounts& counts);
void fill(rmw_liveliness_lost_status_t& info, const EventCounts& counts);
void fill(rmw_message_lost_status_t& info, const EventCounts& counts);
void fill(rmw_qos_incompatible_event_status_t& info, const EventCounts& counts);
void fill(rmw_incompatible_type_status_t& info, const EventCounts& counts);
void fill(rmw_matched_status_t& info, const EventCounts& counts);
}  // namespace detail

/// Calls `callback` with an InfoT when the counters of its event changed.
template <typename InfoT>
class EventHandler : public EventHandlerBase {
 public:
  EventHandler(std::function<void(InfoT&)> callback, std::shared_ptr<ros2wasm::Endpoint> endpoint,
               int32_t event_type)
      : EventHandlerBase(std::move(endpoint), event_type), callback_(std::move(callback)) {}

  void execute(const std::shared_ptr<void>& data) override {
    InfoT info{};
    detail::fill(info, *static_cast<const EventCounts*>(data.get()));
    callback_(info);
  }

 private:
  std::function<void(InfoT&)> callback_;
};

}  // namespace rclcpp
