// Calls of a controller manager's services, as the spawners make them.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "controller_manager_msgs/srv/switch_controller.hpp"
#include "rclcpp/client.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/utilities.hpp"

namespace controller_manager {

/// The manager did not appear in time.
struct ServiceNotFound : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// SIGINT or SIGTERM came while waiting.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

/// The manager's name with the namespace of the spawner; a name with a slash stays as it is.
std::string full_manager_name(const std::string& name, const std::string& name_space);

class ManagerClient {
 public:
  /// Seconds; a service timeout of 0 waits for ever.
  ManagerClient(rclcpp::Node::SharedPtr node, std::string manager, double service_timeout,
                double call_timeout);

  /// Throws ServiceNotFound, Interrupted, and std::runtime_error after three calls without answer.
  template <typename ServiceT>
  typename ServiceT::Response::SharedPtr call(const std::string& name,
                                              const typename ServiceT::Request& request) {
    const std::string full = manager_ + "/" + name;
    auto& kept = clients_[full];
    if (!kept) {
      kept = node_->create_client<ServiceT>(full);
    }
    const auto client = std::static_pointer_cast<rclcpp::Client<ServiceT>>(kept);
    wait_for(*client, full);
    for (int attempt = 1; attempt <= kAttempts; ++attempt) {
      auto answer =
          client->async_send_request(std::make_shared<typename ServiceT::Request>(request));
      const auto result = rclcpp::spin_until_future_complete(
          node_, answer, std::chrono::duration<double>(call_timeout_));
      if (result == rclcpp::FutureReturnCode::SUCCESS) {
        return answer.get();
      }
      report_no_answer(full, attempt);
    }
    throw std::runtime_error("Could not successfully call service " + full + " after " +
                             std::to_string(kAttempts) + " attempts.");
  }

  /// The services that take a name and answer whether it was done.
  template <typename ServiceT>
  bool call_named(const std::string& service, const std::string& controller) {
    typename ServiceT::Request request;
    request.name = controller;
    return call<ServiceT>(service, request)->ok;
  }

  bool is_loaded(const std::string& controller);
  bool load(const std::string& controller);
  bool configure(const std::string& controller);
  bool unload(const std::string& controller);
  /// STRICT; `timeout` in seconds.
  bool switch_controllers(const std::vector<std::string>& deactivate,
                          const std::vector<std::string>& activate, bool asap, double timeout);
  /// Sets `<controller>.<name>` on the manager. False when it is refused.
  bool set_controller_parameter(const std::string& controller, const std::string& name,
                                const rclcpp::ParameterValue& value);

 private:
  static constexpr int kAttempts = 3;
  void wait_for(rclcpp::ClientBase& client, const std::string& name) const;
  void report_no_answer(const std::string& name, int attempt) const;

  rclcpp::Node::SharedPtr node_;
  std::string manager_;
  double service_timeout_;
  double call_timeout_;
  std::map<std::string, rclcpp::ClientBase::SharedPtr> clients_;
};

/// A list as Python prints it: ['a', 'b'].
std::string listed(const std::vector<std::string>& names);

}  // namespace controller_manager
