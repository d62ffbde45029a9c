// A node's view of the graph: the names, types and endpoints of all nodes.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "rclcpp/event.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/detail/node_interfaces_helpers.hpp"
#include "rclcpp/qos.hpp"
#include "rmw/types.h"

namespace rclcpp {

enum class EndpointType {
  Invalid = RMW_ENDPOINT_INVALID,
  Publisher = RMW_ENDPOINT_PUBLISHER,
  Subscription = RMW_ENDPOINT_SUBSCRIPTION
};

/// One publisher or subscription somewhere in the graph.
class TopicEndpointInfo {
 public:
  TopicEndpointInfo(std::string node_name, std::string node_namespace, std::string topic_type,
                    EndpointType endpoint_type, std::array<uint8_t, RMW_GID_STORAGE_SIZE> gid,
                    rclcpp::QoS qos, std::string type_hash)
      : node_name_(std::move(node_name)),
        node_namespace_(std::move(node_namespace)),
        topic_type_(std::move(topic_type)),
        endpoint_type_(endpoint_type),
        endpoint_gid_(gid),
        qos_profile_(std::move(qos)),
        topic_type_hash_(std::move(type_hash)) {}

  std::string& node_name() { return node_name_; }
  const std::string& node_name() const { return node_name_; }
  std::string& node_namespace() { return node_namespace_; }
  const std::string& node_namespace() const { return node_namespace_; }
  std::string& topic_type() { return topic_type_; }
  const std::string& topic_type() const { return topic_type_; }
  rclcpp::EndpointType& endpoint_type() { return endpoint_type_; }
  const rclcpp::EndpointType& endpoint_type() const { return endpoint_type_; }
  std::array<uint8_t, RMW_GID_STORAGE_SIZE>& endpoint_gid() { return endpoint_gid_; }
  const std::array<uint8_t, RMW_GID_STORAGE_SIZE>& endpoint_gid() const { return endpoint_gid_; }
  rclcpp::QoS& qos_profile() { return qos_profile_; }
  const rclcpp::QoS& qos_profile() const { return qos_profile_; }
  /// "RIHS01_..." or empty.
  const std::string& topic_type_hash() const { return topic_type_hash_; }

 private:
  std::string node_name_;
  std::string node_namespace_;
  std::string topic_type_;
  rclcpp::EndpointType endpoint_type_;
  std::array<uint8_t, RMW_GID_STORAGE_SIZE> endpoint_gid_;
  rclcpp::QoS qos_profile_;
  std::string topic_type_hash_;
};

namespace node_interfaces {

class NodeGraphInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeGraphInterface)
  using NamesAndTypes = std::map<std::string, std::vector<std::string>>;
  virtual ~NodeGraphInterface() = default;

  virtual NamesAndTypes get_topic_names_and_types(bool no_demangle = false) const = 0;
  virtual NamesAndTypes get_service_names_and_types() const = 0;
  virtual NamesAndTypes get_service_names_and_types_by_node(
      const std::string& node_name, const std::string& namespace_) const = 0;
  virtual NamesAndTypes get_client_names_and_types_by_node(const std::string& node_name,
                                                           const std::string& namespace_) const = 0;
  virtual NamesAndTypes get_publisher_names_and_types_by_node(const std::string& node_name,
                                                              const std::string& namespace_,
                                                              bool no_demangle = false) const = 0;
  virtual NamesAndTypes get_subscriber_names_and_types_by_node(const std::string& node_name,
                                                               const std::string& namespace_,
                                                               bool no_demangle = false) const = 0;
  /// Full names.
  virtual std::vector<std::string> get_node_names() const = 0;
  virtual std::vector<std::pair<std::string, std::string>> get_node_names_and_namespaces()
      const = 0;
  /// Name, namespace and enclave; a site has the one enclave "/".
  virtual std::vector<std::tuple<std::string, std::string, std::string>>
  get_node_names_with_enclaves() const = 0;
  virtual size_t count_publishers(const std::string& topic_name) const = 0;
  virtual size_t count_subscribers(const std::string& topic_name) const = 0;
  virtual size_t count_clients(const std::string& service_name) const = 0;
  virtual size_t count_services(const std::string& service_name) const = 0;
  virtual rclcpp::Event::SharedPtr get_graph_event() = 0;
  /// Returns when the event is set, on shutdown, or after the timeout.
  /// How many events of get_graph_event() are in use.
  virtual size_t count_graph_users() const = 0;
  virtual void wait_for_graph_change(rclcpp::Event::SharedPtr event,
                                     std::chrono::nanoseconds timeout) = 0;
  virtual std::vector<rclcpp::TopicEndpointInfo> get_publishers_info_by_topic(
      const std::string& topic_name, bool no_mangle = false) const = 0;
  virtual std::vector<rclcpp::TopicEndpointInfo> get_subscriptions_info_by_topic(
      const std::string& topic_name, bool no_mangle = false) const = 0;
};

}  // namespace node_interfaces
}  // namespace rclcpp

RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(rclcpp::node_interfaces::NodeGraphInterface, graph)
