// The part that all subscriptions share: an endpoint on the bus, its QoS, its events, and the queue
// of messages that came by pointer.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "rclcpp/detail/executable.hpp"
#include "rclcpp/detail/inbox.hpp"
#include "rclcpp/detail/intra_process.hpp"
#include "rclcpp/detail/message_type.hpp"
#include "rclcpp/event_handler.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/message_info.hpp"
#include "rclcpp/network_flow_endpoint.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/subscription_options.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {

namespace node_interfaces {
class NodeBaseInterface;
}
namespace detail {
class ContentFilter;
}
namespace topic_statistics {
class SubscriptionTopicStatistics;
}

enum class DeliveredMessageKind : uint8_t {
  INVALID = 0,
  ROS_MESSAGE = 1,
  SERIALIZED_MESSAGE = 2,
  DYNAMIC_MESSAGE = 3,
};

class SubscriptionBase : public detail::Executable,
                         public std::enable_shared_from_this<SubscriptionBase> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(SubscriptionBase)

  using EventHandlers =
      std::unordered_map<rcl_subscription_event_type_t, std::shared_ptr<rclcpp::EventHandlerBase>>;

  /// Throws InvalidTopicNameError for a name that cannot be.
  SubscriptionBase(node_interfaces::NodeBaseInterface* node_base,
                   const rosidl_message_type_support_t& type_support, const std::string& topic_name,
                   const rclcpp::QoS& qos, const SubscriptionOptionsBase& options,
                   DeliveredMessageKind delivered_message_kind = DeliveredMessageKind::ROS_MESSAGE);
  ~SubscriptionBase() override;

  const char* get_topic_name() const { return topic_name_.c_str(); }
  const EventHandlers& get_event_handlers() const { return event_handlers_; }
  rclcpp::QoS get_actual_qos() const { return qos_; }
  /// Takes one message into an object of the right type; false when there is none.
  bool take_type_erased(void* message_out, rclcpp::MessageInfo& message_info_out);
  bool take_serialized(rclcpp::SerializedMessage& message_out,
                       rclcpp::MessageInfo& message_info_out);
  virtual std::shared_ptr<void> create_message() = 0;
  virtual std::shared_ptr<rclcpp::SerializedMessage> create_serialized_message();
  virtual void handle_message(std::shared_ptr<void>& message,
                              const rclcpp::MessageInfo& message_info) = 0;
  virtual void handle_serialized_message(
      const std::shared_ptr<rclcpp::SerializedMessage>& serialized_message,
      const rclcpp::MessageInfo& message_info) = 0;
  virtual void return_message(std::shared_ptr<void>& message) { message.reset(); }
  virtual void return_serialized_message(std::shared_ptr<rclcpp::SerializedMessage>& message) {
    message.reset();
  }
  const rosidl_message_type_support_t& get_message_type_support_handle() const {
    return type_support_;
  }
  bool is_serialized() const {
    return delivered_message_kind_ == DeliveredMessageKind::SERIALIZED_MESSAGE;
  }
  DeliveredMessageKind get_delivered_message_kind() const { return delivered_message_kind_; }
  size_t get_publisher_count() const;
  bool can_loan_messages() const { return false; }
  bool exchange_in_use_by_wait_set_state(void* pointer_to_subscription_part, bool in_use_state);
  /// Throws RCLError: a page has no network flows.
  std::vector<rclcpp::NetworkFlowEndpoint> get_network_flow_endpoints() const;
  /// Called with the number of messages that arrived from the bus, by whoever waits next in this
  /// process; they stay to be taken.
  void set_on_new_message_callback(std::function<void(size_t)> callback);
  void clear_on_new_message_callback();
  /// The same of messages that come by pointer, called by who publishes.
  void set_on_new_intra_process_message_callback(std::function<void(size_t)> callback);
  void clear_on_new_intra_process_message_callback();
  /// Called with how often the event came. Warns when the subscription has no handler for it.
  void set_on_new_qos_event_callback(std::function<void(size_t)> callback,
                                     rcl_subscription_event_type_t event_type);
  void clear_on_new_qos_event_callback(rcl_subscription_event_type_t event_type);
  /// Whether messages are filtered by what they say. It happens here, when they are taken.
  bool is_cft_enabled() const;
  /// From the next message on; an empty expression lets all pass. Throws RCLError for one that
  /// cannot be read.
  void set_content_filter(const std::string& filter_expression,
                          const std::vector<std::string>& expression_parameters = {});
  /// Throws RCLError when there is none.
  rclcpp::ContentFilterOptions get_content_filter() const;

  /// Told of each message from the bus. To be set before the subscription is entered into its node.
  void set_topic_statistics(
      std::shared_ptr<topic_statistics::SubscriptionTopicStatistics> topic_statistics);

  bool is_intra_process() const { return intra_process_; }
  /// Whether its callback wants to own the message.
  virtual bool takes_ownership() const { return false; }
  const char* type_name() const;
  void push_local(detail::LocalMessage message);

  int32_t ready_endpoint() const override;
  bool polls() const override { return intra_process_ || inbox_->polls(); }
  bool is_ready_now() override;
  bool run(std::shared_ptr<void>& data) override;

 protected:
  /// The bytes are taken; makes the message and calls back.
  virtual void handle_bytes(const uint8_t* bytes, size_t size,
                            const rclcpp::MessageInfo& message_info) = 0;
  virtual void handle_local(detail::LocalMessage message,
                            const rclcpp::MessageInfo& message_info) = 0;
  /// Whether its callback is told what came with a message.
  virtual bool reads_info() const { return true; }
  /// Logs what could not be read; the message is dropped.
  void report_malformed() const;

 private:
  RCLCPP_DISABLE_COPY(SubscriptionBase)
  void add_events(const SubscriptionOptionsBase& options);
  void use_filter(const ContentFilterOptions& options, const char* failure);
  std::shared_ptr<const detail::ContentFilter> filter() const;
  /// Whether the message is for this subscription.
  bool accepts(const ros2wasm::Bytes& bytes, const ros2wasm::SampleInfo& sample) const;
  /// `with_time`: notes when it was taken; to ask for the time costs as much as to take a message.
  bool take_bytes(ros2wasm::Bytes& bytes, rclcpp::MessageInfo& info, bool with_time);
  bool run_local();
  bool run_from_bus(rclcpp::MessageInfo& info);

  const std::string topic_name_;
  std::string logger_name_;
  const rosidl_message_type_support_t& type_support_;
  const rclcpp::QoS qos_;
  const DeliveredMessageKind delivered_message_kind_;
  bool intra_process_;
  std::shared_ptr<ros2wasm::Endpoint> endpoint_;
  std::unique_ptr<detail::Inbox> inbox_;
  std::shared_ptr<void> type_use_;
  EventHandlers event_handlers_;
  uint64_t received_count_ = 0;
  std::shared_ptr<topic_statistics::SubscriptionTopicStatistics> topic_statistics_;
  mutable std::mutex filter_mutex_;
  std::shared_ptr<const detail::ContentFilter> filter_;
  std::mutex local_mutex_;
  std::deque<detail::LocalMessage> local_messages_;
  std::atomic<bool> in_use_by_wait_set_{false};
  std::recursive_mutex local_callback_mutex_;
  std::function<void(size_t)> on_new_local_message_callback_;
};

}  // namespace rclcpp
