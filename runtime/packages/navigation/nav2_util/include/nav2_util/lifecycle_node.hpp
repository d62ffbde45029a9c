// The managed node that servers of Nav2 derive from. It has a bond with the lifecycle manager while
// it is active.
#pragma once

#include <memory>
#include <string>
#include <thread>

#include "bond/msg/constants.hpp"
#include "bondcpp/bond.hpp"
#include "nav2_util/node_thread.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_util {

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class LifecycleNode : public rclcpp_lifecycle::LifecycleNode {
 public:
  LifecycleNode(const std::string& node_name, const std::string& ns = "",
                const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  /// Deactivates and cleans up what is still active or configured.
  virtual ~LifecycleNode();

  struct floating_point_range {
    double from_value;
    double to_value;
    double step;
  };
  struct integer_range {
    int from_value;
    int to_value;
    int step;
  };

  void add_parameter(const std::string& name, const rclcpp::ParameterValue& default_value,
                     const std::string& description = "",
                     const std::string& additional_constraints = "", bool read_only = false);
  void add_parameter(const std::string& name, const rclcpp::ParameterValue& default_value,
                     const floating_point_range fp_range, const std::string& description = "",
                     const std::string& additional_constraints = "", bool read_only = false);
  void add_parameter(const std::string& name, const rclcpp::ParameterValue& default_value,
                     const integer_range int_range, const std::string& description = "",
                     const std::string& additional_constraints = "", bool read_only = false);

  std::shared_ptr<nav2_util::LifecycleNode> shared_from_this() {
    return std::static_pointer_cast<nav2_util::LifecycleNode>(
        rclcpp_lifecycle::LifecycleNode::shared_from_this());
  }

  nav2_util::CallbackReturn on_error(const rclcpp_lifecycle::State& state) override;

  /// Configures and activates the node once it spins.
  void autostart();
  /// Runs before the context shuts down.
  virtual void on_rcl_preshutdown();
  void createBond();
  void destroyBond();

 protected:
  void printLifecycleNodeNotification();
  void register_rcl_preshutdown_callback();
  void runCleanups();

  std::unique_ptr<rclcpp::PreShutdownCallbackHandle> rcl_preshutdown_cb_handle_{nullptr};
  std::shared_ptr<bond::Bond> bond_{nullptr};
  double bond_heartbeat_period;  // s; no bond when it is not positive
  rclcpp::TimerBase::SharedPtr autostart_timer_;
};

}  // namespace nav2_util
