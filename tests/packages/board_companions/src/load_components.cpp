// load_components CONTAINER PACKAGE WORD...: asks a container for what `ros2 component` would. A
// class is loaded (CLASS:=NAME: as a node of that name), a number is unloaded; at the end says what
// there is.

// Compatibility, works: component containers (`component_container` of the package with the
// components): load, unload, list, with remappings, parameters and extra arguments

// Compatibility, differs: the package of a component that is loaded into a container -> is not
// looked at, by the class alone it is found among those that the container was linked with

#include <cctype>
#include <cstdio>
#include <memory>
#include <string>

#include "composition_interfaces/srv/list_nodes.hpp"
#include "composition_interfaces/srv/load_node.hpp"
#include "composition_interfaces/srv/unload_node.hpp"
#include "rclcpp/rclcpp.hpp"

using composition_interfaces::srv::ListNodes;
using composition_interfaces::srv::LoadNode;
using composition_interfaces::srv::UnloadNode;

namespace {

template <typename ServiceT>
typename ServiceT::Response::SharedPtr ask(
    const std::shared_ptr<rclcpp::Node>& node, const std::string& service,
    const std::shared_ptr<typename ServiceT::Request>& request) {
  auto client = node->create_client<ServiceT>(service);
  client->wait_for_service();
  auto answer = client->async_send_request(request);
  rclcpp::spin_until_future_complete(node, answer);
  return answer.get();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (words.size() < 3) return 2;
  const auto node = std::make_shared<rclcpp::Node>("load_components");
  const std::string container = words[1] + "/_container/";
  for (std::size_t i = 3; i < words.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(words[i].front())) != 0) {
      const auto request = std::make_shared<UnloadNode::Request>();
      request->unique_id = std::stoull(words[i]);
      const auto answer = ask<UnloadNode>(node, container + "unload_node", request);
      std::printf("unload %s: %s\n", words[i].c_str(),
                  answer->success ? "done" : answer->error_message.c_str());
      continue;
    }
    const auto request = std::make_shared<LoadNode::Request>();
    const auto given = words[i].find(":=");
    request->package_name = words[2];
    request->plugin_name = words[i].substr(0, given);
    request->node_name = given == std::string::npos ? "" : words[i].substr(given + 2);
    const auto answer = ask<LoadNode>(node, container + "load_node", request);
    std::printf("load %s: %s\n", request->plugin_name.c_str(),
                answer->success ? answer->full_node_name.c_str() : answer->error_message.c_str());
  }
  const auto there =
      ask<ListNodes>(node, container + "list_nodes", std::make_shared<ListNodes::Request>());
  for (std::size_t i = 0; i < there->unique_ids.size(); ++i) {
    std::printf("%d %s\n", static_cast<int>(there->unique_ids[i]),
                there->full_node_names[i].c_str());
  }
  rclcpp::shutdown();
  return 0;
}
