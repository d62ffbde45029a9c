// The services of the manager.
#include "manager_services.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "controller_manager/controller_manager.hpp"
#include "controller_manager_msgs/srv/cleanup_controller.hpp"
#include "controller_manager_msgs/srv/configure_controller.hpp"
#include "controller_manager_msgs/srv/list_controller_types.hpp"
#include "controller_manager_msgs/srv/load_controller.hpp"
#include "controller_manager_msgs/srv/reload_controller_libraries.hpp"
#include "controller_manager_msgs/srv/unload_controller.hpp"
#include "hardware_interface/helpers.hpp"
#include "switch_plan.hpp"

namespace controller_manager {

namespace srv = controller_manager_msgs::srv;
using ReturnType = controller_interface::return_type;
using Lock = std::lock_guard<std::recursive_mutex>;

namespace {

/// The names of exported interfaces without the controller's own.
std::vector<std::string> without_prefix(const std::vector<std::string>& names,
                                        const std::string& controller) {
  std::vector<std::string> result;
  for (const std::string& name : names) {
    result.push_back(name.substr(std::min(name.size(), controller.size() + 1)));
  }
  return result;
}

/// To whom the commands of a controller go that are references of others.
void add_connections(controller_manager_msgs::msg::ControllerState& state,
                     const std::set<std::string>& controllers) {
  std::map<std::string, std::vector<std::string>> by_name;
  for (const std::string& command : state.required_command_interfaces) {
    const std::string owner = command.substr(0, command.find('/'));
    if (controllers.count(owner) > 0) {
      by_name[owner].push_back(command.substr(std::min(command.size(), owner.size() + 1)));
    }
  }
  for (const auto& [name, references] : by_name) {
    controller_manager_msgs::msg::ChainConnection connection;
    connection.name = name;
    connection.reference_interfaces = references;
    state.chain_connections.push_back(connection);
  }
}

}  // namespace

ManagerServices::ManagerServices(ControllerManager& manager)
    : manager_(manager),
      activity_(manager.create_publisher<controller_manager_msgs::msg::ControllerManagerActivity>(
          "~/activity", rclcpp::QoS(1).reliable().transient_local())) {}

template <typename ServiceT, typename CallbackT>
void ManagerServices::add(const char* name, CallbackT callback) {
  services_.push_back(manager_.create_service<ServiceT>(
      std::string("~/") + name,
      [this, callback](const std::shared_ptr<typename ServiceT::Request> request,
                       std::shared_ptr<typename ServiceT::Response> response) {
        const std::lock_guard<std::mutex> one_at_a_time(manager_.services_lock_);
        callback(*request, *response);
      },
      rclcpp::ServicesQoS(), group_));
}

void ManagerServices::start() {
  if (!services_.empty()) {
    return;
  }
  group_ = manager_.create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  add_listing();
  add_steering();
}

void ManagerServices::add_listing() {
  add<srv::ListControllers>("list_controllers",
                            [this](const auto&, auto& response) { list_controllers(response); });
  add<srv::ListControllerTypes>("list_controller_types", [this](const auto&, auto& response) {
    list_types(response.types, response.base_classes);
  });
  add<srv::ListHardwareComponents>("list_hardware_components", [this](const auto&, auto& response) {
    list_components(response);
  });
  add<srv::ListHardwareInterfaces>("list_hardware_interfaces", [this](const auto&, auto& response) {
    list_interfaces(response);
  });
}

void ManagerServices::add_steering() {
  add<srv::LoadController>("load_controller", [this](const auto& request, auto& response) {
    response.ok = manager_.load_controller(request.name) != nullptr;
  });
  add<srv::ConfigureController>(
      "configure_controller", [this](const auto& request, auto& response) {
        response.ok = manager_.configure_controller(request.name) == ReturnType::OK;
      });
  add<srv::SwitchController>("switch_controller", [this](const auto& request, auto& response) {
    response.ok =
        manager_.switch_controller_cb(
            request.activate_controllers, request.deactivate_controllers, request.strictness,
            request.activate_asap, rclcpp::Duration(request.timeout.sec, request.timeout.nanosec),
            response.message) == ReturnType::OK;
  });
  add<srv::UnloadController>("unload_controller", [this](const auto& request, auto& response) {
    response.ok = manager_.unload_controller(request.name) == ReturnType::OK;
  });
  add<srv::CleanupController>("cleanup_controller", [this](const auto& request, auto& response) {
    response.ok = manager_.cleanup_controller(request.name) == ReturnType::OK;
  });
  // The libraries are part of the program, so there is nothing to read again. As in ROS 2 it is
  // refused while controllers are loaded, unless forced.
  add<srv::ReloadControllerLibraries>(
      "reload_controller_libraries", [this](const auto& request, auto& response) {
        const auto loaded = manager_.get_loaded_controllers();
        if (!loaded.empty() && !request.force_kill) {
          RCLCPP_ERROR(manager_.get_logger(),
                       "Controller manager: Cannot reload controller libraries because there are "
                       "still %zu active controllers",
                       loaded.size());
          response.ok = false;
          return;
        }
        std::vector<std::string> names;
        for (const ControllerSpec& spec : loaded) {
          names.push_back(spec.info.name);
        }
        {
          const Lock lock(manager_.controllers_lock_);
          manager_.deactivate_controllers(names);
        }
        response.ok = true;
        for (const std::string& name : names) {
          response.ok = manager_.unload_controller(name) == ReturnType::OK && response.ok;
        }
      });
  add<srv::SetHardwareComponentState>(
      "set_hardware_component_state",
      [this](const auto& request, auto& response) { set_component_state(request, response); });
}

void ManagerServices::list_controllers(srv::ListControllers::Response& response) {
  const Lock lock(manager_.controllers_lock_);
  std::set<std::string> names;
  for (const ControllerSpec& spec : manager_.controllers_) {
    names.insert(spec.info.name);
  }
  const std::vector<ControllerView> views = manager_.controller_views();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const ControllerSpec& spec = manager_.controllers_[i];
    controller_manager_msgs::msg::ControllerState state;
    state.name = spec.info.name;
    state.type = spec.info.type;
    state.is_async = spec.c->is_async();
    state.update_rate = static_cast<uint16_t>(spec.c->get_update_rate());
    state.claimed_interfaces = spec.info.claimed_interfaces;
    state.state = spec.c->get_lifecycle_state().label();
    state.is_chainable = views[i].is_chainable;
    state.is_chained = views[i].is_in_chained_mode;
    state.required_command_interfaces = views[i].commands;
    state.required_state_interfaces = views[i].states;
    state.reference_interfaces = without_prefix(views[i].references, state.name);
    state.exported_state_interfaces = without_prefix(views[i].exported_states, state.name);
    add_connections(state, names);
    response.controller.push_back(state);
  }
}

void ManagerServices::list_types(std::vector<std::string>& types, std::vector<std::string>& bases) {
  manager_.make_loaders();
  const auto add_all = [&](const std::vector<std::string>& found, const std::string& base) {
    types.insert(types.end(), found.begin(), found.end());
    bases.insert(bases.end(), found.size(), base);
  };
  add_all(manager_.loader_->getDeclaredClasses(), manager_.loader_->getBaseClassType());
  add_all(manager_.chainable_loader_->getDeclaredClasses(),
          manager_.chainable_loader_->getBaseClassType());
}

void ManagerServices::list_components(srv::ListHardwareComponents::Response& response) {
  auto& resources = *manager_.resource_manager_;
  const auto& known = resources.get_components_status();
  std::vector<std::string> names;
  for (const auto& entry : known) {
    names.push_back(entry.first);
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    const auto& info = known.at(name);
    controller_manager_msgs::msg::HardwareComponentState state;
    state.name = info.name;
    state.type = info.type;
    state.is_async = info.is_async;
    state.rw_rate = static_cast<uint16_t>(info.rw_rate);
    state.plugin_name = info.plugin_name;
    state.state.id = info.state.id();
    state.state.label = info.state.label();
    const auto add_interface = [](auto& into, const std::string& interface_name,
                                  const std::string& type, bool available, bool claimed) {
      controller_manager_msgs::msg::HardwareInterface interface;
      interface.name = interface_name;
      interface.data_type = type;
      interface.is_available = available;
      interface.is_claimed = claimed;
      into.push_back(interface);
    };
    for (const std::string& command : info.command_interfaces) {
      add_interface(state.command_interfaces, command,
                    resources.get_command_interface_data_type(command),
                    resources.command_interface_is_available(command),
                    resources.command_interface_is_claimed(command));
    }
    for (const std::string& one : info.state_interfaces) {
      add_interface(state.state_interfaces, one, resources.get_state_interface_data_type(one),
                    resources.state_interface_is_available(one), false);
    }
    response.component.push_back(state);
  }
}

void ManagerServices::list_interfaces(srv::ListHardwareInterfaces::Response& response) {
  auto& resources = *manager_.resource_manager_;
  for (const std::string& name : resources.state_interface_keys()) {
    controller_manager_msgs::msg::HardwareInterface interface;
    interface.name = name;
    interface.data_type = resources.get_state_interface_data_type(name);
    interface.is_available = resources.state_interface_is_available(name);
    response.state_interfaces.push_back(interface);
  }
  for (const std::string& name : resources.command_interface_keys()) {
    controller_manager_msgs::msg::HardwareInterface interface;
    interface.name = name;
    interface.data_type = resources.get_command_interface_data_type(name);
    interface.is_available = resources.command_interface_is_available(name);
    interface.is_claimed = resources.command_interface_is_claimed(name);
    response.command_interfaces.push_back(interface);
  }
}

void ManagerServices::set_component_state(const srv::SetHardwareComponentState::Request& request,
                                          srv::SetHardwareComponentState::Response& response) {
  auto& resources = *manager_.resource_manager_;
  const std::string& name = request.name;
  RCLCPP_DEBUG(manager_.get_logger(), "set hardware component state '%s'", name.c_str());
  if (resources.get_components_status().count(name) == 0) {
    RCLCPP_ERROR(manager_.get_logger(), "hardware component with name '%s' does not exist",
                 name.c_str());
    response.ok = false;
    return;
  }
  rclcpp_lifecycle::State target(request.target_state.id, request.target_state.label.empty()
                                                              ? "unknown"
                                                              : request.target_state.label);
  response.ok = resources.set_component_state(name, target) == hardware_interface::return_type::OK;
  const auto& now = resources.get_components_status().at(name).state;
  response.state.id = now.id();
  response.state.label = now.label();
}

void ManagerServices::publish_activity() {
  controller_manager_msgs::msg::ControllerManagerActivity message;
  message.header.stamp = manager_.get_clock()->now();
  const auto add_state = [](auto& into, const std::string& name,
                            const rclcpp_lifecycle::State& state) {
    controller_manager_msgs::msg::NamedLifecycleState named;
    named.name = name;
    named.state.id = state.id();
    named.state.label = state.label();
    into.push_back(named);
  };
  for (const ControllerSpec& spec : manager_.get_loaded_controllers()) {
    add_state(message.controllers, spec.info.name, spec.c->get_lifecycle_state());
  }
  if (manager_.resource_manager_) {
    const auto& known = manager_.resource_manager_->get_components_status();
    std::vector<std::string> names;
    for (const auto& entry : known) {
      names.push_back(entry.first);
    }
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) {
      add_state(message.hardware_components, name, known.at(name).state);
    }
  }
  activity_->publish(message);
}

}  // namespace controller_manager
