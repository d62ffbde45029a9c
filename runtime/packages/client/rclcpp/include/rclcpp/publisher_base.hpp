// The part that all publishers share: an endpoint on the bus, its QoS, its events, and delivery by
// pointer to subscriptions of the same process.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "rclcpp/detail/message_type.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/network_flow_endpoint.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"

namespace ros2wasm {
class Endpoint;
}

namespace rclcpp {

class Context;

namespace node_interfaces {
class NodeBaseInterface;
class NodeTopicsInterface;
}  // namespace node_interfaces

class PublisherBase : public std::enable_shared_from_this<PublisherBase> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(PublisherBase)

  using EventHandlers =
      std::unordered_map<rcl_publisher_event_type_t, std::shared_ptr<rclcpp::EventHandlerBase>>;

  /// Throws InvalidTopicNameError for a name that cannot be.
  PublisherBase(node_interfaces::NodeBaseInterface* node_base, const std::string& topic,
                const rosidl_message_type_support_t& type_support, const rclcpp::QoS& qos,
                const PublisherOptionsBase& options,
                const detail::ObjectFunctions* object_functions = nullptr);
  virtual ~PublisherBase();

  const char* get_topic_name() const { return topic_name_.c_str(); }
  /// The depth of its history.
  size_t get_queue_size() const;
  const rmw_gid_t& get_gid() const { return gid_; }
  const EventHandlers& get_event_handlers() const { return event_handlers_; }
  size_t get_subscription_count() const;
  size_t get_intra_process_subscription_count() const;
  bool is_durability_transient_local() const;
  /// The bus knows that a publisher lives for as long as its program does, so there is nothing to
  /// say; false after shutdown.
  [[nodiscard]] bool assert_liveliness() const;
  rclcpp::QoS get_actual_qos() const { return qos_; }
  bool can_loan_messages() const { return false; }
  bool operator==(const rmw_gid_t& gid) const { return *this == &gid; }
  bool operator==(const rmw_gid_t* gid) const;
  /// Throws RCLError: a page has no network flows.
  std::vector<rclcpp::NetworkFlowEndpoint> get_network_flow_endpoints() const;

  /// Called with how often the event came, by whoever waits next in this process. Warns when the
  /// publisher has no handler for it.
  void set_on_new_qos_event_callback(std::function<void(size_t)> callback,
                                     rcl_publisher_event_type_t event_type);
  void clear_on_new_qos_event_callback(rcl_publisher_event_type_t event_type);

  /// True once all matched reliable subscriptions have what was published. The bus hands over at
  /// once, so this does not block.
  template <typename DurationRepT = int64_t, typename DurationT = std::milli>
  bool wait_for_all_acked(std::chrono::duration<DurationRepT, DurationT> timeout =
                              std::chrono::duration<DurationRepT, DurationT>(-1)) const {
    static_cast<void>(timeout);
    return true;
  }

 protected:
  /// Writes a message to the bus. Silently nothing after shutdown.
  void publish_object(const void* ros_message) const;
  void publish_bytes(const uint8_t* bytes, size_t size) const;
  bool is_intra_process() const { return intra_process_; }
  /// Hands an object over to the subscriptions in this process and, if others listen, to the bus.
  void publish_owned(void* ros_message) const;

  std::shared_ptr<rclcpp::Context> context_;

 private:
  RCLCPP_DISABLE_COPY(PublisherBase)
  void add_events(const PublisherOptionsBase& options);

  const std::string topic_name_;
  std::string logger_name_;
  const rosidl_message_type_support_t& type_support_;
  const rclcpp::QoS qos_;
  const detail::ObjectFunctions* object_functions_;
  bool intra_process_;
  std::shared_ptr<ros2wasm::Endpoint> endpoint_;
  std::shared_ptr<void> type_use_;
  rmw_gid_t gid_{};
  EventHandlers event_handlers_;
};

}  // namespace rclcpp
