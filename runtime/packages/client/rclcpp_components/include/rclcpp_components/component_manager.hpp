// The node of a container: it loads, unloads and lists components when it is asked to. What it can
// load was linked into the program.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "composition_interfaces/srv/list_nodes.hpp"
#include "composition_interfaces/srv/load_node.hpp"
#include "composition_interfaces/srv/unload_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components {

class ComponentManagerException : public std::runtime_error {
 public:
  explicit ComponentManagerException(const std::string& error_desc)
      : std::runtime_error(error_desc) {}
};

class ComponentManager : public rclcpp::Node {
 public:
  using LoadNode = composition_interfaces::srv::LoadNode;
  using UnloadNode = composition_interfaces::srv::UnloadNode;
  using ListNodes = composition_interfaces::srv::ListNodes;
  /// Class and library.
  using ComponentResource = std::pair<std::string, std::string>;

  explicit ComponentManager(
      std::weak_ptr<rclcpp::Executor> executor =
          std::weak_ptr<rclcpp::executors::MultiThreadedExecutor>(),
      std::string node_name = "ComponentManager",
      const rclcpp::NodeOptions& node_options = rclcpp::NodeOptions()
                                                    .start_parameter_services(false)
                                                    .start_parameter_event_publisher(false));
  ~ComponentManager() override;

  /// Those of the program, of whichever package: it has no index of them by package.
  virtual std::vector<ComponentResource> get_component_resources(
      const std::string& package_name,
      const std::string& resource_index = "rclcpp_components") const;
  /// Makes a component of class `plugin` and runs it: its number; nothing when no library has the
  /// class. `arguments`: of its node, such as `--ros-args -r __node:=n`; `extras`: as in requests.
  std::optional<uint64_t> load(const std::string& plugin, const std::vector<std::string>& arguments,
                               const std::vector<rclcpp::Parameter>& extras);
  /// Null when the library has no such class.
  virtual std::shared_ptr<rclcpp_components::NodeFactory> create_component_factory(
      const ComponentResource& resource);
  virtual void set_executor(const std::weak_ptr<rclcpp::Executor> executor);

 private:
  std::optional<uint64_t> instantiate(const std::string& plugin,
                                      const std::function<rclcpp::NodeOptions()>& options);

 protected:
  virtual rclcpp::NodeOptions create_node_options(const std::shared_ptr<LoadNode::Request> request);
  virtual void add_node_to_executor(uint64_t node_id);
  virtual void remove_node_from_executor(uint64_t node_id);
  virtual void on_load_node(const std::shared_ptr<rmw_request_id_t> request_header,
                            const std::shared_ptr<LoadNode::Request> request,
                            std::shared_ptr<LoadNode::Response> response);
  virtual void on_unload_node(const std::shared_ptr<rmw_request_id_t> request_header,
                              const std::shared_ptr<UnloadNode::Request> request,
                              std::shared_ptr<UnloadNode::Response> response);
  virtual void on_list_nodes(const std::shared_ptr<rmw_request_id_t> request_header,
                             const std::shared_ptr<ListNodes::Request> request,
                             std::shared_ptr<ListNodes::Response> response);

  std::weak_ptr<rclcpp::Executor> executor_;
  uint64_t unique_id_ = 1;
  std::map<std::string, std::unique_ptr<class_loader::ClassLoader>> loaders_;
  std::map<uint64_t, rclcpp_components::NodeInstanceWrapper> node_wrappers_;
  rclcpp::Service<LoadNode>::SharedPtr load_node_srv_;
  rclcpp::Service<UnloadNode>::SharedPtr unload_node_srv_;
  rclcpp::Service<ListNodes>::SharedPtr list_nodes_srv_;
};

}  // namespace rclcpp_components
