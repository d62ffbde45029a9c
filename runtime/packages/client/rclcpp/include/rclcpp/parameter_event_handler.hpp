// Callbacks for changes of parameters, of any node.
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/create_subscription.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/subscription.hpp"

namespace rclcpp {

struct ParameterCallbackHandle {
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle)
  using ParameterCallbackType = std::function<void(const rclcpp::Parameter&)>;
  std::string parameter_name;
  std::string node_name;
  ParameterCallbackType callback;
};

struct ParameterEventCallbackHandle {
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle)
  using ParameterEventCallbackType =
      std::function<void(const rcl_interfaces::msg::ParameterEvent&)>;
  ParameterEventCallbackType callback;
};

class ParameterEventHandler {
 public:
  template <typename NodeT>
  explicit ParameterEventHandler(NodeT node, const rclcpp::QoS& qos = rclcpp::ParameterEventsQoS())
      : callbacks_(std::make_shared<Callbacks>()),
        node_base_(rclcpp::node_interfaces::get_node_base_interface(node)) {
    event_subscription_ = rclcpp::create_subscription<rcl_interfaces::msg::ParameterEvent>(
        rclcpp::node_interfaces::get_node_topics_interface(node), "/parameter_events", qos,
        [callbacks = callbacks_](const rcl_interfaces::msg::ParameterEvent& event) {
          callbacks->event_callback(event);
        });
  }

  using ParameterEventCallbackType = ParameterEventCallbackHandle::ParameterEventCallbackType;
  using ParameterCallbackType = ParameterCallbackHandle::ParameterCallbackType;

  /// The callback lives as long as its handle.
  [[nodiscard]] ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(
      ParameterEventCallbackType callback);
  /// Throws std::runtime_error when it is not there.
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr callback_handle);
  /// `node_name` empty: this node; relative: in this node's namespace.
  [[nodiscard]] ParameterCallbackHandle::SharedPtr add_parameter_callback(
      const std::string& parameter_name, ParameterCallbackType callback,
      const std::string& node_name = "");
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr callback_handle);

  static bool get_parameter_from_event(const rcl_interfaces::msg::ParameterEvent& event,
                                       rclcpp::Parameter& parameter,
                                       const std::string& parameter_name,
                                       const std::string& node_name = "");
  /// Throws std::runtime_error when the event does not have it.
  static rclcpp::Parameter get_parameter_from_event(
      const rcl_interfaces::msg::ParameterEvent& event, const std::string& parameter_name,
      const std::string& node_name = "");
  static std::vector<rclcpp::Parameter> get_parameters_from_event(
      const rcl_interfaces::msg::ParameterEvent& event);

  using CallbacksContainerType = std::list<ParameterCallbackHandle::WeakPtr>;

 protected:
  struct Callbacks {
    std::recursive_mutex mutex_;
    // By parameter name and node name.
    std::map<std::pair<std::string, std::string>, CallbacksContainerType> parameter_callbacks_;
    std::list<ParameterEventCallbackHandle::WeakPtr> event_callbacks_;
    void event_callback(const rcl_interfaces::msg::ParameterEvent& event);
  };

  std::shared_ptr<Callbacks> callbacks_;
  std::string resolve_path(const std::string& path);
  std::shared_ptr<rclcpp::node_interfaces::NodeBaseInterface> node_base_;
  rclcpp::Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr event_subscription_;
};

}  // namespace rclcpp
