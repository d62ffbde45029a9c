// Leads the nodes of the parameter `node_names` through their states in order, and brings all of
// them down when the bond of one breaks.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bondcpp/bond.hpp"
#include "diagnostic_updater/diagnostic_updater.hpp"
#include "nav2_lifecycle_manager/detail/managed_node.hpp"
#include "nav2_msgs/srv/manage_lifecycle_nodes.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/empty.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace nav2_lifecycle_manager {

using nav2_msgs::srv::ManageLifecycleNodes;

enum NodeState {
  UNCONFIGURED,
  ACTIVE,
  INACTIVE,
  FINALIZED,
  UNKNOWN,
};

class LifecycleManager : public rclcpp::Node {
 public:
  /// Its services have a thread of their own, so its node can be in one executor with the nodes
  /// that it manages.
  explicit LifecycleManager(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~LifecycleManager();

 protected:
  /// Spins the executor until the result is let go of.
  using StartThread =
      std::shared_ptr<void> (*)(rclcpp::executors::SingleThreadedExecutor::SharedPtr executor);
  /// Without a thread (null), the node's own executor runs the services. That executor has no node
  /// that is managed: the manager waits for them.
  LifecycleManager(const rclcpp::NodeOptions& options, StartThread start_thread);

  void managerCallback(const std::shared_ptr<rmw_request_id_t> request_header,
                       const std::shared_ptr<ManageLifecycleNodes::Request> request,
                       std::shared_ptr<ManageLifecycleNodes::Response> response);
  void isActiveCallback(const std::shared_ptr<rmw_request_id_t> request_header,
                        const std::shared_ptr<std_srvs::srv::Trigger::Request> request,
                        std::shared_ptr<std_srvs::srv::Trigger::Response> response);

  bool startup();
  bool configure();
  bool cleanup();
  bool shutdown();
  /// Hard: goes on when a node does not obey.
  bool reset(bool hard_reset = false);
  bool pause();
  bool resume();

  /// Lets go of the nodes before the context shuts down.
  void onRclPreshutdown();
  void registerRclPreshutdownCallback();
  void createLifecycleServiceClients();
  void destroyLifecycleServiceClients();
  void shutdownAllNodes();

  bool createBondConnection(const std::string& node_name);
  void createBondTimer();
  void destroyBondTimer();
  void checkBondConnections();
  /// Starts all again once every node of a broken system is back.
  void checkBondRespawnConnection();

  bool changeStateForNode(const std::string& node_name, std::uint8_t transition);
  /// In the order of the names, or against it for what takes nodes down.
  bool changeStateForAllNodes(std::uint8_t transition, bool hard_change = false);

  /// Logs in bold blue.
  void message(const std::string& msg);
  void CreateDiagnostic(diagnostic_updater::DiagnosticStatusWrapper& stat);
  bool isActive();

 private:
  using NodePtr = std::shared_ptr<detail::ManagedNode>;

  void read_parameters();
  void begin();
  NodePtr node_of(const std::string& name) const;
  bool has_bonds() const;
  void drop_bonds();
  /// Logs the error, and notes that the state of the nodes is unknown. Always false.
  bool fail(const char* text);

  const StartThread start_thread_;
  std::shared_ptr<void> thread_;
  /// The services and timers.
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp::executors::SingleThreadedExecutor::SharedPtr services_executor_;
  std::shared_ptr<detail::NodeLink> link_;

  rclcpp::Service<ManageLifecycleNodes>::SharedPtr manager_srv_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr is_active_srv_;
  rclcpp::TimerBase::SharedPtr init_timer_;
  rclcpp::TimerBase::SharedPtr link_timer_;
  rclcpp::TimerBase::SharedPtr bond_timer_;
  rclcpp::TimerBase::SharedPtr bond_respawn_timer_;
  std::unique_ptr<rclcpp::PreShutdownCallbackHandle> preshutdown_;

  std::vector<std::string> node_names_;
  std::map<std::string, NodePtr> nodes_;
  NodeState managed_nodes_state_{NodeState::UNCONFIGURED};
  bool autostart_ = false;
  bool attempt_respawn_reconnection_ = true;
  std::chrono::milliseconds bond_timeout_{0};
  rclcpp::Duration bond_respawn_max_duration_{std::chrono::seconds(10)};
  rclcpp::Time bond_respawn_start_time_{0};
  diagnostic_updater::Updater diagnostics_updater_;
};

}  // namespace nav2_lifecycle_manager
