// The implementation of NodeGraphInterface.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeGraph : public NodeGraphInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeGraph)
  explicit NodeGraph(NodeBaseInterface* node_base) : node_base_(node_base) {}

  NamesAndTypes get_topic_names_and_types(bool no_demangle) const override;
  NamesAndTypes get_service_names_and_types() const override;
  NamesAndTypes get_service_names_and_types_by_node(const std::string& node_name,
                                                    const std::string& ns) const override;
  NamesAndTypes get_client_names_and_types_by_node(const std::string& node_name,
                                                   const std::string& ns) const override;
  NamesAndTypes get_publisher_names_and_types_by_node(const std::string& node_name,
                                                      const std::string& ns,
                                                      bool no_demangle) const override;
  NamesAndTypes get_subscriber_names_and_types_by_node(const std::string& node_name,
                                                       const std::string& ns,
                                                       bool no_demangle) const override;
  std::vector<std::string> get_node_names() const override;
  std::vector<std::pair<std::string, std::string>> get_node_names_and_namespaces() const override;
  std::vector<std::tuple<std::string, std::string, std::string>> get_node_names_with_enclaves()
      const override;
  size_t count_publishers(const std::string& topic_name) const override;
  size_t count_subscribers(const std::string& topic_name) const override;
  size_t count_clients(const std::string& service_name) const override;
  size_t count_services(const std::string& service_name) const override;
  rclcpp::Event::SharedPtr get_graph_event() override;
  size_t count_graph_users() const override;
  void wait_for_graph_change(rclcpp::Event::SharedPtr event,
                             std::chrono::nanoseconds timeout) override;
  std::vector<rclcpp::TopicEndpointInfo> get_publishers_info_by_topic(
      const std::string& topic_name, bool no_mangle) const override;
  std::vector<rclcpp::TopicEndpointInfo> get_subscriptions_info_by_topic(
      const std::string& topic_name, bool no_mangle) const override;

 private:
  RCLCPP_DISABLE_COPY(NodeGraph)
  NodeBaseInterface* node_base_;
  mutable std::mutex mutex_;
  // Each event with the graph's version when it was last looked at.
  std::vector<std::pair<rclcpp::Event::WeakPtr, int32_t>> events_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
