// See component_manager.hpp.
#include "rclcpp_components/component_manager.hpp"

#include <algorithm>
#include <thread>
#include <typeinfo>

namespace rclcpp_components {
namespace {

constexpr char kFactoryOf[] = "rclcpp_components::NodeFactoryTemplate<";

/// The name of a factory's class, such as `composition::Talker`, as it was written when it was
/// registered.
std::string component_of(const std::string& factory) {
  const size_t begin = factory.rfind(kFactoryOf, 0) == 0 ? sizeof(kFactoryOf) - 1 : 0;
  return begin == 0 ? factory : factory.substr(begin, factory.rfind('>') - begin);
}

bool flag(const rclcpp::Parameter& argument) {
  if (argument.get_type() != rclcpp::ParameterType::PARAMETER_BOOL) {
    throw ComponentManagerException("Extra component argument '" + argument.get_name() +
                                    "' must be a boolean");
  }
  return argument.get_value<bool>();
}

void set_extras(const std::vector<rclcpp::Parameter>& extras, rclcpp::NodeOptions& options) {
  for (const auto& extra : extras) {
    if (extra.get_name() == "use_intra_process_comms") {
      options.use_intra_process_comms(flag(extra));
    } else if (extra.get_name() == "forward_global_arguments") {
      options.use_global_arguments(flag(extra));
    }
  }
}

}  // namespace

ComponentManager::ComponentManager(std::weak_ptr<rclcpp::Executor> executor, std::string node_name,
                                   const rclcpp::NodeOptions& node_options)
    : Node(std::move(node_name), node_options), executor_(std::move(executor)) {
  const auto threads = static_cast<int64_t>(std::max(std::thread::hardware_concurrency(), 1U));
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = "Number of threads";
  descriptor.read_only = true;
  declare_parameter("thread_num", threads, descriptor);
  using std::placeholders::_1;
  using std::placeholders::_2;
  using std::placeholders::_3;
  load_node_srv_ = create_service<LoadNode>(
      "~/_container/load_node", std::bind(&ComponentManager::on_load_node, this, _1, _2, _3));
  unload_node_srv_ = create_service<UnloadNode>(
      "~/_container/unload_node", std::bind(&ComponentManager::on_unload_node, this, _1, _2, _3));
  list_nodes_srv_ = create_service<ListNodes>(
      "~/_container/list_nodes", std::bind(&ComponentManager::on_list_nodes, this, _1, _2, _3));
}

ComponentManager::~ComponentManager() {
  if (const auto executor = executor_.lock()) {
    for (auto& [id, wrapper] : node_wrappers_) {
      executor->remove_node(wrapper.get_node_base_interface());
    }
  }
}

std::vector<ComponentManager::ComponentResource> ComponentManager::get_component_resources(
    const std::string&, const std::string&) const {
  std::vector<ComponentResource> resources;
  for (const auto& [name, library] :
       class_loader::impl::classes_and_libraries(typeid(NodeFactory).name())) {
    resources.emplace_back(component_of(name), library);
  }
  return resources;
}

std::shared_ptr<NodeFactory> ComponentManager::create_component_factory(
    const ComponentResource& resource) {
  const auto& [component, library] = resource;
  auto& loader = loaders_[library];
  if (loader == nullptr) {
    RCLCPP_INFO(get_logger(), "Load Library: %s", library.c_str());
    try {
      loader = std::make_unique<class_loader::ClassLoader>(library);
    } catch (const std::exception& error) {
      throw ComponentManagerException("Failed to load library: " + std::string(error.what()));
    }
  }
  for (const std::string& name : loader->getAvailableClasses<NodeFactory>()) {
    RCLCPP_INFO(get_logger(), "Found class: %s", name.c_str());
    if (name == component || component_of(name) == component) {
      RCLCPP_INFO(get_logger(), "Instantiate class: %s", name.c_str());
      return loader->createInstance<NodeFactory>(name);
    }
  }
  return nullptr;
}

rclcpp::NodeOptions ComponentManager::create_node_options(
    const std::shared_ptr<LoadNode::Request> request) {
  std::vector<rclcpp::Parameter> parameters;
  for (const auto& parameter : request->parameters) {
    parameters.push_back(rclcpp::Parameter::from_parameter_msg(parameter));
  }
  std::vector<std::string> arguments = {"--ros-args"};
  const auto remap = [&arguments](const std::string& rule) {
    arguments.insert(arguments.end(), {"-r", rule});
  };
  for (const std::string& rule : request->remap_rules) {
    remap(rule);
  }
  if (!request->node_name.empty()) {
    remap("__node:=" + request->node_name);
  }
  if (!request->node_namespace.empty()) {
    remap("__ns:=" + request->node_namespace);
  }
  rclcpp::NodeOptions options;
  options.use_global_arguments(false).parameter_overrides(parameters).arguments(arguments);
  std::vector<rclcpp::Parameter> extras;
  for (const auto& argument : request->extra_arguments) {
    extras.push_back(rclcpp::Parameter::from_parameter_msg(argument));
  }
  set_extras(extras, options);
  return options;
}

void ComponentManager::set_executor(const std::weak_ptr<rclcpp::Executor> executor) {
  executor_ = executor;
}

void ComponentManager::add_node_to_executor(uint64_t node_id) {
  if (const auto executor = executor_.lock()) {
    executor->add_node(node_wrappers_.at(node_id).get_node_base_interface(), true);
  }
}

void ComponentManager::remove_node_from_executor(uint64_t node_id) {
  if (const auto executor = executor_.lock()) {
    executor->remove_node(node_wrappers_.at(node_id).get_node_base_interface());
  }
}

std::optional<uint64_t> ComponentManager::instantiate(
    const std::string& plugin, const std::function<rclcpp::NodeOptions()>& options) {
  for (const ComponentResource& resource : get_component_resources({})) {
    const auto factory = resource.first == plugin ? create_component_factory(resource) : nullptr;
    if (factory == nullptr) {
      continue;
    }
    const rclcpp::NodeOptions chosen = options();
    const uint64_t node_id = unique_id_++;
    try {
      node_wrappers_[node_id] = factory->create_node_instance(chosen);
    } catch (const std::exception& error) {
      node_wrappers_.erase(node_id);
      throw ComponentManagerException("Component constructor threw an exception: " +
                                      std::string(error.what()));
    } catch (...) {
      node_wrappers_.erase(node_id);
      throw ComponentManagerException("Component constructor threw an exception");
    }
    add_node_to_executor(node_id);
    return node_id;
  }
  RCLCPP_ERROR(get_logger(),
               "Failed to find class with the requested plugin name '%s' in the loaded library",
               plugin.c_str());
  return std::nullopt;
}

std::optional<uint64_t> ComponentManager::load(const std::string& plugin,
                                               const std::vector<std::string>& arguments,
                                               const std::vector<rclcpp::Parameter>& extras) {
  return instantiate(plugin, [&] {
    rclcpp::NodeOptions options;
    options.use_global_arguments(false).arguments(arguments);
    set_extras(extras, options);
    return options;
  });
}

void ComponentManager::on_load_node(const std::shared_ptr<rmw_request_id_t>,
                                    const std::shared_ptr<LoadNode::Request> request,
                                    std::shared_ptr<LoadNode::Response> response) {
  try {
    const auto node_id =
        instantiate(request->plugin_name, [&] { return create_node_options(request); });
    response->success = node_id.has_value();
    if (!node_id) {
      response->error_message = "Failed to find class with the requested plugin name.";
      return;
    }
    response->full_node_name =
        node_wrappers_[*node_id].get_node_base_interface()->get_fully_qualified_name();
    response->unique_id = *node_id;
  } catch (const ComponentManagerException& error) {
    RCLCPP_ERROR(get_logger(), "%s", error.what());
    response->error_message = error.what();
    response->success = false;
  }
}

void ComponentManager::on_unload_node(const std::shared_ptr<rmw_request_id_t>,
                                      const std::shared_ptr<UnloadNode::Request> request,
                                      std::shared_ptr<UnloadNode::Response> response) {
  if (node_wrappers_.count(request->unique_id) == 0) {
    response->success = false;
    response->error_message = "No node found with unique_id: " + std::to_string(request->unique_id);
    RCLCPP_WARN(get_logger(), "%s", response->error_message.c_str());
    return;
  }
  remove_node_from_executor(request->unique_id);
  node_wrappers_.erase(request->unique_id);
  response->success = true;
}

void ComponentManager::on_list_nodes(const std::shared_ptr<rmw_request_id_t>,
                                     const std::shared_ptr<ListNodes::Request>,
                                     std::shared_ptr<ListNodes::Response> response) {
  for (auto& [id, wrapper] : node_wrappers_) {
    response->unique_ids.push_back(id);
    response->full_node_names.push_back(
        wrapper.get_node_base_interface()->get_fully_qualified_name());
  }
}

}  // namespace rclcpp_components
