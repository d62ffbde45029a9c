// Calls of a controller manager's services.
#include "manager_client.hpp"

#include <algorithm>
#include <utility>

#include "controller_manager_msgs/srv/configure_controller.hpp"
#include "controller_manager_msgs/srv/list_controllers.hpp"
#include "controller_manager_msgs/srv/load_controller.hpp"
#include "controller_manager_msgs/srv/unload_controller.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"

namespace controller_manager {

namespace srv = controller_manager_msgs::srv;

std::string full_manager_name(const std::string& name, const std::string& name_space) {
  if (!name.empty() && name.front() == '/') {
    return name;
  }
  return (name_space == "/" ? "" : name_space) + "/" + name;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "'" : ", '") + name + "'";
  }
  return "[" + text + "]";
}

ManagerClient::ManagerClient(rclcpp::Node::SharedPtr node, std::string manager,
                             double service_timeout, double call_timeout)
    : node_(std::move(node)),
      manager_(std::move(manager)),
      service_timeout_(service_timeout),
      call_timeout_(call_timeout) {}

void ManagerClient::wait_for(rclcpp::ClientBase& client, const std::string& name) const {
  // A client that has just been made takes a moment to find a service that has long been there.
  constexpr std::chrono::milliseconds kDiscovery(250);
  client.wait_for_service(kDiscovery);
  while (!client.service_is_ready()) {
    RCLCPP_INFO(node_->get_logger(), "waiting for service %s to become available...", name.c_str());
    const double seconds = service_timeout_ > 0.0 ? service_timeout_ : 10.0;
    if (client.wait_for_service(std::chrono::duration<double>(seconds))) {
      return;
    }
    if (!rclcpp::ok()) {
      throw Interrupted();
    }
    if (service_timeout_ > 0.0) {
      throw ServiceNotFound("Could not contact service " + name);
    }
    RCLCPP_WARN(node_->get_logger(), "Could not contact service %s", name.c_str());
  }
}

void ManagerClient::report_no_answer(const std::string& name, int attempt) const {
  if (!rclcpp::ok()) {
    throw Interrupted();
  }
  RCLCPP_WARN(node_->get_logger(),
              "Failed getting a result from calling %s in %.1f. (Attempt %d of %d.)", name.c_str(),
              call_timeout_, attempt, kAttempts);
}

bool ManagerClient::is_loaded(const std::string& controller) {
  const auto answer =
      call<srv::ListControllers>("list_controllers", srv::ListControllers::Request());
  return std::any_of(answer->controller.begin(), answer->controller.end(),
                     [&controller](const auto& one) { return one.name == controller; });
}
bool ManagerClient::load(const std::string& controller) {
  return call_named<srv::LoadController>("load_controller", controller);
}
bool ManagerClient::configure(const std::string& controller) {
  return call_named<srv::ConfigureController>("configure_controller", controller);
}
bool ManagerClient::unload(const std::string& controller) {
  return call_named<srv::UnloadController>("unload_controller", controller);
}

bool ManagerClient::switch_controllers(const std::vector<std::string>& deactivate,
                                       const std::vector<std::string>& activate, bool asap,
                                       double timeout) {
  srv::SwitchController::Request request;
  request.deactivate_controllers = deactivate;
  request.activate_controllers = activate;
  request.strictness = srv::SwitchController::Request::STRICT;
  request.activate_asap = asap;
  request.timeout = rclcpp::Duration::from_seconds(timeout);
  return call<srv::SwitchController>("switch_controller", request)->ok;
}

bool ManagerClient::set_controller_parameter(const std::string& controller, const std::string& name,
                                             const rclcpp::ParameterValue& value) {
  const rclcpp::Parameter parameter(controller + "." + name, value);
  rcl_interfaces::srv::SetParameters::Request request;
  request.parameters.push_back(parameter.to_parameter_msg());
  const auto answer = call<rcl_interfaces::srv::SetParameters>("set_parameters", request);
  const bool done = answer->results.size() == 1 && answer->results[0].successful;
  const std::string text = value.get_type() == rclcpp::PARAMETER_STRING_ARRAY
                               ? listed(value.get<std::vector<std::string>>())
                               : value.get<std::string>();
  if (done) {
    RCLCPP_INFO(node_->get_logger(), "Setting controller param \"%s\" to \"%s\" for %s",
                name.c_str(), text.c_str(), controller.c_str());
  } else {
    RCLCPP_FATAL(node_->get_logger(), "Could not set controller param \"%s\" to \"%s\" for %s",
                 name.c_str(), text.c_str(), controller.c_str());
  }
  return done;
}

}  // namespace controller_manager
