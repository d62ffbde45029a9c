// Questions about the graph, answered from a snapshot.
#include "rclcpp/node_interfaces/node_graph.hpp"

#include <functional>

#include "rclcpp/detail/background.hpp"
#include "rclcpp/detail/bus_qos.hpp"
#include "ros2wasm/graph.hpp"
#include "ros2wasm/names.hpp"

namespace rclcpp {
namespace node_interfaces {
namespace {

using ros2wasm::EndpointKind;
using ros2wasm::Graph;
using ros2wasm::GraphEndpoint;

using NamesAndTypes = NodeGraphInterface::NamesAndTypes;

NamesAndTypes collect(const Graph& graph, const std::function<bool(const GraphEndpoint&)>& wanted) {
  NamesAndTypes result;
  for (const GraphEndpoint& endpoint : graph.endpoints) {
    if (!wanted(endpoint)) {
      continue;
    }
    auto& types = result[endpoint.name];
    if (std::find(types.begin(), types.end(), endpoint.type) == types.end()) {
      types.insert(std::upper_bound(types.begin(), types.end(), endpoint.type), endpoint.type);
    }
  }
  return result;
}

NamesAndTypes collect_of_node(const std::string& node_name, const std::string& ns,
                              EndpointKind kind) {
  const Graph graph = ros2wasm::take_graph_snapshot();
  return collect(graph, [&](const GraphEndpoint& endpoint) {
    const ros2wasm::GraphNode& node = graph.nodes[endpoint.node_index];
    return endpoint.kind == kind && node.name == node_name && node.ns == ns;
  });
}

size_t count(const std::string& full_name, EndpointKind kind) {
  const Graph graph = ros2wasm::take_graph_snapshot();
  return static_cast<size_t>(std::count_if(
      graph.endpoints.begin(), graph.endpoints.end(),
      [&](const auto& endpoint) { return endpoint.kind == kind && endpoint.name == full_name; }));
}

std::vector<TopicEndpointInfo> describe(const std::string& full_name, EndpointKind kind,
                                        EndpointType type) {
  const Graph graph = ros2wasm::take_graph_snapshot();
  std::vector<TopicEndpointInfo> result;
  for (const GraphEndpoint& endpoint : graph.endpoints) {
    if (endpoint.kind == kind && endpoint.name == full_name) {
      const ros2wasm::GraphNode& node = graph.nodes[endpoint.node_index];
      result.emplace_back(node.name, node.ns, endpoint.type, type, endpoint.gid,
                          ::rclcpp::detail::from_bus(endpoint.qos), endpoint.hash);
    }
  }
  return result;
}

}  // namespace

NamesAndTypes NodeGraph::get_topic_names_and_types(bool) const {
  return collect(ros2wasm::take_graph_snapshot(), [](const GraphEndpoint& endpoint) {
    return endpoint.kind == EndpointKind::publisher || endpoint.kind == EndpointKind::subscription;
  });
}

NamesAndTypes NodeGraph::get_service_names_and_types() const {
  return collect(ros2wasm::take_graph_snapshot(), [](const GraphEndpoint& endpoint) {
    return endpoint.kind == EndpointKind::server || endpoint.kind == EndpointKind::client;
  });
}

NamesAndTypes NodeGraph::get_service_names_and_types_by_node(const std::string& node_name,
                                                             const std::string& ns) const {
  return collect_of_node(node_name, ns, EndpointKind::server);
}

NamesAndTypes NodeGraph::get_client_names_and_types_by_node(const std::string& node_name,
                                                            const std::string& ns) const {
  return collect_of_node(node_name, ns, EndpointKind::client);
}

NamesAndTypes NodeGraph::get_publisher_names_and_types_by_node(const std::string& node_name,
                                                               const std::string& ns, bool) const {
  return collect_of_node(node_name, ns, EndpointKind::publisher);
}

NamesAndTypes NodeGraph::get_subscriber_names_and_types_by_node(const std::string& node_name,
                                                                const std::string& ns, bool) const {
  return collect_of_node(node_name, ns, EndpointKind::subscription);
}

std::vector<std::string> NodeGraph::get_node_names() const {
  std::vector<std::string> names;
  for (const ros2wasm::GraphNode& node : ros2wasm::take_graph_snapshot().nodes) {
    names.push_back(ros2wasm::join_name(node.ns, node.name));
  }
  return names;
}

std::vector<std::pair<std::string, std::string>> NodeGraph::get_node_names_and_namespaces() const {
  std::vector<std::pair<std::string, std::string>> names;
  for (const ros2wasm::GraphNode& node : ros2wasm::take_graph_snapshot().nodes) {
    names.emplace_back(node.name, node.ns);
  }
  return names;
}

size_t NodeGraph::count_publishers(const std::string& topic_name) const {
  return count(node_base_->resolve_topic_or_service_name(topic_name, false, true),
               EndpointKind::publisher);
}

size_t NodeGraph::count_subscribers(const std::string& topic_name) const {
  return count(node_base_->resolve_topic_or_service_name(topic_name, false, true),
               EndpointKind::subscription);
}

size_t NodeGraph::count_clients(const std::string& service_name) const {
  return count(node_base_->resolve_topic_or_service_name(service_name, true, true),
               EndpointKind::client);
}

size_t NodeGraph::count_services(const std::string& service_name) const {
  return count(node_base_->resolve_topic_or_service_name(service_name, true, true),
               EndpointKind::server);
}

std::vector<TopicEndpointInfo> NodeGraph::get_publishers_info_by_topic(
    const std::string& topic_name, bool) const {
  return describe(node_base_->resolve_topic_or_service_name(topic_name, false),
                  EndpointKind::publisher, EndpointType::Publisher);
}

std::vector<TopicEndpointInfo> NodeGraph::get_subscriptions_info_by_topic(
    const std::string& topic_name, bool) const {
  return describe(node_base_->resolve_topic_or_service_name(topic_name, false),
                  EndpointKind::subscription, EndpointType::Subscription);
}

std::vector<std::tuple<std::string, std::string, std::string>>
NodeGraph::get_node_names_with_enclaves() const {
  std::vector<std::tuple<std::string, std::string, std::string>> names;
  for (const ros2wasm::GraphNode& node : ros2wasm::take_graph_snapshot().nodes) {
    names.emplace_back(node.name, node.ns, "/");
  }
  return names;
}

size_t NodeGraph::count_graph_users() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<size_t>(std::count_if(
      events_.begin(), events_.end(), [](const auto& event) { return !event.first.expired(); }));
}

rclcpp::Event::SharedPtr NodeGraph::get_graph_event() {
  auto event = rclcpp::Event::make_shared();
  const std::lock_guard<std::mutex> lock(mutex_);
  events_.emplace_back(event, ros2wasm::graph_version());
  return event;
}

void NodeGraph::wait_for_graph_change(rclcpp::Event::SharedPtr event,
                                      std::chrono::nanoseconds timeout) {
  if (!event) {
    throw std::runtime_error("invalid event, the event is a nullptr");
  }
  const int64_t until = ros2wasm::steady_now_ns() + timeout.count();
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (auto& [weak, seen] : events_) {
        const auto known = weak.lock();
        if (known && seen != ros2wasm::graph_version()) {
          seen = ros2wasm::graph_version();
          known->set();
        }
      }
    }
    const int64_t left = timeout.count() < 0 ? -1 : until - ros2wasm::steady_now_ns();
    if (event->check() || !node_base_->get_context()->is_valid() ||
        (timeout.count() >= 0 && left <= 0)) {
      return;
    }
    ::rclcpp::detail::run_background();
    ros2wasm::wait(token, left);
  }
}

}  // namespace node_interfaces
}  // namespace rclcpp
