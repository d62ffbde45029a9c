// Receiving: from the bus, or by pointer from the same process.
#include "rclcpp/subscription_base.hpp"

#include <cstring>

#include "rclcpp/detail/bus_qos.hpp"
#include "rclcpp/detail/content_filter.hpp"
#include "rclcpp/detail/listeners.hpp"
#include "rclcpp/detail/type_use.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/topic_statistics/subscription_topic_statistics.hpp"
#include "rmw/rmw.h"

namespace rclcpp {
namespace {

rmw_message_info_t to_rmw(const ros2wasm::SampleInfo& info, uint64_t received_count,
                          int64_t received_ns) {
  rmw_message_info_t result{};
  result.source_timestamp = info.source_timestamp_ns;
  result.received_timestamp = received_ns;
  result.publication_sequence_number = static_cast<uint64_t>(info.sequence);
  result.reception_sequence_number = received_count;
  result.publisher_gid.implementation_identifier = rmw_get_implementation_identifier();
  std::memcpy(result.publisher_gid.data, info.writer_gid, sizeof(info.writer_gid));
  return result;
}

}  // namespace

SubscriptionBase::SubscriptionBase(node_interfaces::NodeBaseInterface* node_base,
                                   const rosidl_message_type_support_t& type_support,
                                   const std::string& topic_name, const rclcpp::QoS& qos,
                                   const SubscriptionOptionsBase& options,
                                   DeliveredMessageKind delivered_message_kind)
    : topic_name_(node_base->resolve_topic_or_service_name(topic_name, false)),
      logger_name_(node_base->get_logger_name()),
      type_support_(type_support),
      qos_(detail::resolve_subscription_qos(qos, topic_name_)),
      delivered_message_kind_(delivered_message_kind),
      intra_process_(delivered_message_kind == DeliveredMessageKind::ROS_MESSAGE &&
                     (options.use_intra_process_comm == IntraProcessSetting::NodeDefault
                          ? node_base->get_use_intra_process_default()
                          : options.use_intra_process_comm == IntraProcessSetting::Enable)) {
  if (options.require_unique_network_flow_endpoints ==
      RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED) {
    rcutils_set_error_state(
        "Strict requirement on unique network flow endpoints for "
        "subscriptions not supported on the bus of a page",
        __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "could not create subscription");
  }
  if (intra_process_ && qos_.history() == HistoryPolicy::KeepAll) {
    throw std::invalid_argument(
        "intraprocess communication is not allowed with keep all history qos policy");
  }
  use_filter(options.content_filter_options, "could not create subscription");
  const detail::MessageCallbacks& type = detail::callbacks_of(type_support);
  ros2wasm::EndpointQos bus_qos = detail::to_bus(qos_);
  bus_qos.ignore_local_publications = options.ignore_local_publications;
  endpoint_ = std::make_shared<ros2wasm::Endpoint>(ros2wasm::EndpointKind::subscription,
                                                   node_base->get_node_id(), topic_name_,
                                                   type.type_name, type.type_hash, bus_qos);
  inbox_ = std::make_unique<detail::Inbox>(
      endpoint_, qos_.history() == HistoryPolicy::KeepAll ? 0 : qos_.depth(),
      [this](const auto& bytes, const auto& sample) { return accepts(bytes, sample); });
  type_use_ = detail::use_type(node_base->get_node_id(), type.type_hash, type.info);
  add_events(options);
}

SubscriptionBase::~SubscriptionBase() {
  inbox_->stop_listening();
  detail::bump_entities_version();
}

void SubscriptionBase::add_events(const SubscriptionOptionsBase& options) {
  const SubscriptionEventCallbacks& callbacks = options.event_callbacks;
  const auto add = [this](auto callback, rcl_subscription_event_type_t type, auto info) {
    if (callback) {
      event_handlers_[type] = std::make_shared<EventHandler<decltype(info)>>(
          std::move(callback), endpoint_, static_cast<int32_t>(type));
    }
  };
  add(callbacks.deadline_callback, RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED,
      QOSDeadlineRequestedInfo());
  add(callbacks.liveliness_callback, RCL_SUBSCRIPTION_LIVELINESS_CHANGED,
      QOSLivelinessChangedInfo());
  QOSRequestedIncompatibleQoSCallbackType incompatible = callbacks.incompatible_qos_callback;
  IncompatibleTypeCallbackType wrong_type = callbacks.incompatible_type_callback;
  if (options.use_default_callbacks && !incompatible) {
    incompatible = [this](QOSRequestedIncompatibleQoSInfo& info) {
      RCLCPP_WARN(rclcpp::get_logger(logger_name_),
                  "New publisher discovered on topic '%s', offering incompatible QoS. "
                  "No messages will be received from it. Last incompatible policy: %s",
                  get_topic_name(), qos_policy_name_from_kind(info.last_policy_kind).c_str());
    };
  }
  if (options.use_default_callbacks && !wrong_type) {
    wrong_type = [this](IncompatibleTypeInfo&) {
      RCLCPP_WARN(rclcpp::get_logger(logger_name_),
                  "Incompatible type on topic '%s', no messages will be received from it.",
                  get_topic_name());
    };
  }
  add(incompatible, RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS, QOSRequestedIncompatibleQoSInfo());
  add(callbacks.message_lost_callback, RCL_SUBSCRIPTION_MESSAGE_LOST, QOSMessageLostInfo());
  add(wrong_type, RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE, IncompatibleTypeInfo());
  add(callbacks.matched_callback, RCL_SUBSCRIPTION_MATCHED, MatchedInfo());
}

const char* SubscriptionBase::type_name() const {
  return detail::callbacks_of(type_support_).type_name;
}

bool SubscriptionBase::accepts(const ros2wasm::Bytes& bytes,
                               const ros2wasm::SampleInfo& sample) const {
  if (intra_process_ && detail::is_local_publisher(sample.writer_gid)) {
    return false;
  }
  const auto filter = this->filter();
  return filter == nullptr || filter->passes(bytes.data(), bytes.size());
}

bool SubscriptionBase::take_bytes(ros2wasm::Bytes& bytes, rclcpp::MessageInfo& info,
                                  bool with_time) {
  ros2wasm::SampleInfo sample{};
  while (inbox_->take(bytes, sample)) {
    if (!accepts(bytes, sample)) {
      continue;
    }
    const int64_t received_ns = with_time ? ros2wasm::system_now_ns() : 0;
    info = rclcpp::MessageInfo(to_rmw(sample, ++received_count_, received_ns));
    return true;
  }
  return false;
}

bool SubscriptionBase::take_type_erased(void* message_out, rclcpp::MessageInfo& message_info_out) {
  ros2wasm::Bytes bytes;
  while (take_bytes(bytes, message_info_out, true)) {
    if (detail::callbacks_of(type_support_).deserialize(bytes.data(), bytes.size(), message_out)) {
      return true;
    }
    report_malformed();
  }
  return false;
}

bool SubscriptionBase::take_serialized(rclcpp::SerializedMessage& message_out,
                                       rclcpp::MessageInfo& message_info_out) {
  ros2wasm::Bytes bytes;
  if (!take_bytes(bytes, message_info_out, true)) {
    return false;
  }
  if (message_out.capacity() < bytes.size()) {
    message_out.reserve(bytes.size());
  }
  rcl_serialized_message_t& out = message_out.get_rcl_serialized_message();
  std::memcpy(out.buffer, bytes.data(), bytes.size());
  out.buffer_length = bytes.size();
  return true;
}

std::shared_ptr<rclcpp::SerializedMessage> SubscriptionBase::create_serialized_message() {
  return std::make_shared<rclcpp::SerializedMessage>();
}

void SubscriptionBase::report_malformed() const {
  RCLCPP_ERROR(rclcpp::get_logger(logger_name_),
               "message on topic '%s' cannot be read as %s; it was dropped", get_topic_name(),
               type_name());
}

size_t SubscriptionBase::get_publisher_count() const {
  return static_cast<size_t>(std::max(0, endpoint_->matched()));
}

bool SubscriptionBase::exchange_in_use_by_wait_set_state(void* part, bool in_use_state) {
  if (part == nullptr) {
    throw std::invalid_argument("pointer_to_subscription_part is unexpectedly nullptr");
  }
  if (part == this) {
    return in_use_by_wait_set_.exchange(in_use_state);
  }
  for (const auto& [type, handler] : event_handlers_) {
    if (part == handler.get()) {
      return handler->exchange_in_use_by_wait_set_state(in_use_state);
    }
  }
  throw std::runtime_error("given pointer_to_subscription_part does not match any part");
}

std::vector<NetworkFlowEndpoint> SubscriptionBase::get_network_flow_endpoints() const {
  rcutils_set_error_state("network flow endpoints do not exist on the bus of a page", __FILE__,
                          __LINE__);
  exceptions::throw_from_rcl_error(RCL_RET_UNSUPPORTED,
                                   "error obtaining network flows of subscription");
}

void SubscriptionBase::set_on_new_message_callback(std::function<void(size_t)> callback) {
  if (!callback) {
    throw std::invalid_argument(
        "The callback passed to set_on_new_message_callback is not callable.");
  }
  inbox_->listen(detail::guarded<size_t>(this, "rclcpp::SubscriptionBase", "on new message",
                                         std::move(callback)));
}

void SubscriptionBase::clear_on_new_message_callback() {
  inbox_->stop_listening();
}

void SubscriptionBase::set_on_new_intra_process_message_callback(
    std::function<void(size_t)> callback) {
  if (!intra_process_) {
    RCLCPP_WARN(rclcpp::get_logger("rclcpp"),
                "Calling set_on_new_intra_process_message_callback for subscription with IPC "
                "disabled");
    return;
  }
  if (!callback) {
    throw std::invalid_argument(
        "The callback passed to set_on_new_intra_process_message_callback is not callable.");
  }
  const std::lock_guard<std::recursive_mutex> lock(local_callback_mutex_);
  on_new_local_message_callback_ = detail::guarded<size_t>(
      this, "rclcpp::SubscriptionBase", "on new intra process message", std::move(callback));
  size_t waiting = 0;
  {
    const std::lock_guard<std::mutex> local_lock(local_mutex_);
    waiting = local_messages_.size();
  }
  if (waiting > 0) {
    const auto told = on_new_local_message_callback_;
    told(waiting);
  }
}

void SubscriptionBase::clear_on_new_intra_process_message_callback() {
  const std::lock_guard<std::recursive_mutex> lock(local_callback_mutex_);
  on_new_local_message_callback_ = nullptr;
}

void SubscriptionBase::set_on_new_qos_event_callback(std::function<void(size_t)> callback,
                                                     rcl_subscription_event_type_t event_type) {
  const auto found = event_handlers_.find(event_type);
  if (found == event_handlers_.end()) {
    RCLCPP_WARN(rclcpp::get_logger("rclcpp"),
                "Calling set_on_new_qos_event_callback for non registered subscription event_type");
    return;
  }
  found->second->set_on_new_event_callback(std::move(callback));
}

void SubscriptionBase::clear_on_new_qos_event_callback(rcl_subscription_event_type_t event_type) {
  const auto found = event_handlers_.find(event_type);
  if (found == event_handlers_.end()) {
    RCLCPP_WARN(
        rclcpp::get_logger("rclcpp"),
        "Calling clear_on_new_qos_event_callback for non registered subscription event_type");
    return;
  }
  found->second->clear_on_ready_callback();
}

void SubscriptionBase::use_filter(const ContentFilterOptions& options, const char* failure) {
  std::shared_ptr<const detail::ContentFilter> filter;
  if (!options.filter_expression.empty()) {
    const ros2wasm_typesupport::TypeInfo* type = detail::callbacks_of(type_support_).info;
    try {
      if (type == nullptr) {
        throw std::invalid_argument("content filter: the fields of the type are not known here");
      }
      filter = std::make_shared<const detail::ContentFilter>(*type, options);
    } catch (const std::invalid_argument& error) {
      rcutils_set_error_state(error.what(), __FILE__, __LINE__);
      exceptions::throw_from_rcl_error(RCL_RET_ERROR, failure);
    }
  }
  const std::lock_guard<std::mutex> lock(filter_mutex_);
  filter_ = std::move(filter);
}

std::shared_ptr<const detail::ContentFilter> SubscriptionBase::filter() const {
  const std::lock_guard<std::mutex> lock(filter_mutex_);
  return filter_;
}

bool SubscriptionBase::is_cft_enabled() const {
  return filter() != nullptr;
}

void SubscriptionBase::set_content_filter(const std::string& filter_expression,
                                          const std::vector<std::string>& expression_parameters) {
  use_filter({filter_expression, expression_parameters}, "failed to set cft expression parameters");
}

rclcpp::ContentFilterOptions SubscriptionBase::get_content_filter() const {
  const auto filter = this->filter();
  if (filter == nullptr) {
    rcutils_set_error_state("the subscription has no content filter", __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to get cft expression parameters");
  }
  return filter->options();
}

void SubscriptionBase::set_topic_statistics(
    std::shared_ptr<topic_statistics::SubscriptionTopicStatistics> topic_statistics) {
  topic_statistics_ = std::move(topic_statistics);
}

void SubscriptionBase::push_local(detail::LocalMessage message) {
  if (const auto filter = this->filter()) {
    const detail::MessageCallbacks& type = detail::callbacks_of(type_support_);
    const void* object = message.owned ? message.owned.get() : message.shared.get();
    std::vector<uint8_t> bytes(type.serialized_size(object));
    if (!filter->passes(bytes.data(), type.serialize(object, bytes.data(), bytes.size()))) {
      return;
    }
  }
  {
    const std::lock_guard<std::mutex> lock(local_mutex_);
    if (local_messages_.size() >= qos_.depth()) {
      local_messages_.pop_front();
    }
    local_messages_.push_back(std::move(message));
  }
  {
    const std::lock_guard<std::recursive_mutex> lock(local_callback_mutex_);
    if (const auto callback = on_new_local_message_callback_) {
      callback(1);
    }
  }
  ros2wasm::wake();
}

int32_t SubscriptionBase::ready_endpoint() const {
  return inbox_->ready_endpoint();
}

bool SubscriptionBase::is_ready_now() {
  if (inbox_->has_kept()) {
    return true;
  }
  const std::lock_guard<std::mutex> lock(local_mutex_);
  return !local_messages_.empty();
}

bool SubscriptionBase::run_local() {
  detail::LocalMessage message;
  {
    const std::lock_guard<std::mutex> lock(local_mutex_);
    if (local_messages_.empty()) {
      return false;
    }
    message = std::move(local_messages_.front());
    local_messages_.pop_front();
  }
  rmw_message_info_t info{};
  info.from_intra_process = true;
  handle_local(std::move(message), rclcpp::MessageInfo(info));
  return true;
}

bool SubscriptionBase::run_from_bus(rclcpp::MessageInfo& info) {
  if (is_serialized()) {
    auto message = create_serialized_message();
    const bool taken = take_serialized(*message, info);
    if (taken) {
      handle_serialized_message(message, info);
    }
    return taken;
  }
  ros2wasm::Bytes bytes;
  const bool taken = take_bytes(bytes, info, reads_info());
  if (taken) {
    handle_bytes(bytes.data(), bytes.size(), info);
  }
  return taken;
}

bool SubscriptionBase::run(std::shared_ptr<void>&) {
  if (intra_process_ && run_local()) {
    return true;
  }
  const rclcpp::Time received(topic_statistics_ == nullptr ? 0 : ros2wasm::system_now_ns());
  rclcpp::MessageInfo info;
  const bool taken = run_from_bus(info);
  if (taken && topic_statistics_ != nullptr) {
    topic_statistics_->handle_message(info.get_rmw_message_info(), received);
  }
  return taken;
}

}  // namespace rclcpp
