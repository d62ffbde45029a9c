// Publishing: serialise once, write once.
#include "rclcpp/publisher_base.hpp"

#include <cstring>

#include "rclcpp/context.hpp"
#include "rclcpp/detail/bus_qos.hpp"
#include "rclcpp/detail/intra_process.hpp"
#include "rclcpp/detail/type_use.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rmw/rmw.h"

namespace rclcpp {
namespace {

bool resolve(IntraProcessSetting setting, bool node_default) {
  return setting == IntraProcessSetting::NodeDefault ? node_default
                                                     : setting == IntraProcessSetting::Enable;
}

}  // namespace

PublisherBase::PublisherBase(node_interfaces::NodeBaseInterface* node_base,
                             const std::string& topic,
                             const rosidl_message_type_support_t& type_support,
                             const rclcpp::QoS& qos, const PublisherOptionsBase& options,
                             const detail::ObjectFunctions* object_functions)
    : context_(node_base->get_context()),
      topic_name_(node_base->resolve_topic_or_service_name(topic, false)),
      logger_name_(node_base->get_logger_name()),
      type_support_(type_support),
      qos_(detail::resolve_publisher_qos(qos, topic_name_)),
      object_functions_(object_functions),
      intra_process_(
          object_functions != nullptr &&
          resolve(options.use_intra_process_comm, node_base->get_use_intra_process_default())) {
  if (options.require_unique_network_flow_endpoints ==
      RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED) {
    rcutils_set_error_state(
        "Strict requirement on unique network flow endpoints for publishers "
        "not supported on the bus of a page",
        __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "could not create publisher");
  }
  const detail::MessageCallbacks& type = detail::callbacks_of(type_support);
  endpoint_ = std::make_shared<ros2wasm::Endpoint>(
      ros2wasm::EndpointKind::publisher, node_base->get_node_id(), topic_name_, type.type_name,
      type.type_hash, detail::to_bus(qos_));
  type_use_ = detail::use_type(node_base->get_node_id(), type.type_hash, type.info);
  gid_.implementation_identifier = rmw_get_implementation_identifier();
  std::memcpy(gid_.data, endpoint_->gid().data(), sizeof(gid_.data));
  if (intra_process_) {
    if (qos_.history() == HistoryPolicy::KeepAll) {
      throw std::invalid_argument(
          "intraprocess communication is not allowed with keep all history qos policy");
    }
    detail::add_local_publisher(gid_.data);
  }
  add_events(options);
}

PublisherBase::~PublisherBase() {
  if (intra_process_) {
    detail::remove_local_publisher(gid_.data);
  }
}

void PublisherBase::add_events(const PublisherOptionsBase& options) {
  const PublisherEventCallbacks& callbacks = options.event_callbacks;
  const auto add = [this](auto callback, rcl_publisher_event_type_t type, auto info) {
    if (callback) {
      event_handlers_[type] = std::make_shared<EventHandler<decltype(info)>>(
          std::move(callback), endpoint_, static_cast<int32_t>(type));
    }
  };
  add(callbacks.deadline_callback, RCL_PUBLISHER_OFFERED_DEADLINE_MISSED, QOSDeadlineOfferedInfo());
  add(callbacks.liveliness_callback, RCL_PUBLISHER_LIVELINESS_LOST, QOSLivelinessLostInfo());
  QOSOfferedIncompatibleQoSCallbackType incompatible = callbacks.incompatible_qos_callback;
  IncompatibleTypeCallbackType wrong_type = callbacks.incompatible_type_callback;
  if (options.use_default_callbacks && !incompatible) {
    incompatible = [this](QOSOfferedIncompatibleQoSInfo& info) {
      RCLCPP_WARN(rclcpp::get_logger(logger_name_),
                  "New subscription discovered on topic '%s', requesting incompatible QoS. "
                  "No messages will be sent to it. Last incompatible policy: %s",
                  get_topic_name(), qos_policy_name_from_kind(info.last_policy_kind).c_str());
    };
  }
  if (options.use_default_callbacks && !wrong_type) {
    wrong_type = [this](IncompatibleTypeInfo&) {
      RCLCPP_WARN(rclcpp::get_logger(logger_name_),
                  "Incompatible type on topic '%s', no messages will be sent to it.",
                  get_topic_name());
    };
  }
  add(incompatible, RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS, QOSOfferedIncompatibleQoSInfo());
  add(wrong_type, RCL_PUBLISHER_INCOMPATIBLE_TYPE, IncompatibleTypeInfo());
  add(callbacks.matched_callback, RCL_PUBLISHER_MATCHED, MatchedInfo());
}

size_t PublisherBase::get_queue_size() const {
  return qos_.depth();
}

void PublisherBase::set_on_new_qos_event_callback(std::function<void(size_t)> callback,
                                                  rcl_publisher_event_type_t event_type) {
  const auto found = event_handlers_.find(event_type);
  if (found == event_handlers_.end()) {
    RCLCPP_WARN(rclcpp::get_logger("rclcpp"),
                "Calling set_on_new_qos_event_callback for non registered publisher event_type");
    return;
  }
  found->second->set_on_new_event_callback(std::move(callback));
}

void PublisherBase::clear_on_new_qos_event_callback(rcl_publisher_event_type_t event_type) {
  const auto found = event_handlers_.find(event_type);
  if (found == event_handlers_.end()) {
    RCLCPP_WARN(rclcpp::get_logger("rclcpp"),
                "Calling clear_on_new_qos_event_callback for non registered event_type");
    return;
  }
  found->second->clear_on_ready_callback();
}

size_t PublisherBase::get_subscription_count() const {
  return static_cast<size_t>(std::max(0, endpoint_->matched()));
}

size_t PublisherBase::get_intra_process_subscription_count() const {
  return intra_process_ ? detail::count_local_subscriptions(
                              topic_name_, detail::callbacks_of(type_support_).type_name)
                        : 0;
}

bool PublisherBase::is_durability_transient_local() const {
  return qos_.durability() == DurabilityPolicy::TransientLocal;
}

bool PublisherBase::assert_liveliness() const {
  return endpoint_->assert_liveliness();
}

bool PublisherBase::operator==(const rmw_gid_t* gid) const {
  return std::memcmp(gid->data, gid_.data, sizeof(gid_.data)) == 0;
}

std::vector<NetworkFlowEndpoint> PublisherBase::get_network_flow_endpoints() const {
  rcutils_set_error_state("network flow endpoints do not exist on the bus of a page", __FILE__,
                          __LINE__);
  exceptions::throw_from_rcl_error(RCL_RET_UNSUPPORTED,
                                   "error obtaining network flows of publisher");
}

void PublisherBase::publish_object(const void* ros_message) const {
  const detail::MessageCallbacks& type = detail::callbacks_of(type_support_);
  const size_t size = type.serialized_size(ros_message);
  uint8_t small[1024];
  std::unique_ptr<uint8_t[]> large;
  uint8_t* buffer = small;
  if (size > sizeof(small)) {
    large.reset(new uint8_t[size]);
    buffer = large.get();
  }
  const size_t written = type.serialize(ros_message, buffer, size);
  if (written == 0) {
    rcutils_set_error_state("a field is longer than its bound", __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to publish message");
  }
  publish_bytes(buffer, written);
}

void PublisherBase::publish_bytes(const uint8_t* bytes, size_t size) const {
  // Without a time: the bus gives it the one at which it is written.
  ros2wasm::SampleInfo info{};
  const int32_t result = endpoint_->write(bytes, size, info);
  if (result < 0 && context_->is_valid()) {
    const std::string text = "the bus refused the message, error " + std::to_string(result);
    rcutils_set_error_state(text.c_str(), __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "failed to publish message");
  }
}

void PublisherBase::publish_owned(void* ros_message) const {
  const char* type = detail::callbacks_of(type_support_).type_name;
  std::unique_ptr<void, void (*)(void*)> owner(ros_message, object_functions_->destroy);
  if (is_durability_transient_local() ||
      get_subscription_count() > detail::count_local_subscriptions(topic_name_, type)) {
    publish_object(ros_message);
  }
  detail::deliver_locally(topic_name_, type, owner.release(), *object_functions_);
}

}  // namespace rclcpp
