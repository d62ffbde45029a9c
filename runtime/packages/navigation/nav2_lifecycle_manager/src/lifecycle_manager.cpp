// See lifecycle_manager.hpp.
#include "nav2_lifecycle_manager/lifecycle_manager.hpp"

#include <algorithm>
#include <stdexcept>

#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"

namespace nav2_lifecycle_manager {
namespace {

using namespace std::chrono_literals;
using diagnostic_msgs::msg::DiagnosticStatus;
using lifecycle_msgs::msg::State;
using lifecycle_msgs::msg::Transition;

/// How often the bonds get their messages while the manager has nothing else to do.
constexpr auto kLinkPeriod = 50ms;
constexpr auto kCheckPeriod = 200ms;
constexpr auto kRespawnPeriod = 1s;

struct Change {
  std::uint8_t transition;
  const char* label;
  std::uint8_t state;  // after it
  bool goes_up;        // in the order of the names
};

constexpr Change kChanges[] = {
    {Transition::TRANSITION_CONFIGURE, "Configuring ", State::PRIMARY_STATE_INACTIVE, true},
    {Transition::TRANSITION_CLEANUP, "Cleaning up ", State::PRIMARY_STATE_UNCONFIGURED, false},
    {Transition::TRANSITION_ACTIVATE, "Activating ", State::PRIMARY_STATE_ACTIVE, true},
    {Transition::TRANSITION_DEACTIVATE, "Deactivating ", State::PRIMARY_STATE_INACTIVE, false},
    {Transition::TRANSITION_UNCONFIGURED_SHUTDOWN, "Shutting down ", State::PRIMARY_STATE_FINALIZED,
     false},
};

const Change& change_of(std::uint8_t transition) {
  const Change* found =
      std::find_if(std::begin(kChanges), std::end(kChanges),
                   [transition](const Change& one) { return one.transition == transition; });
  if (found == std::end(kChanges)) throw std::runtime_error("not a transition of the manager");
  return *found;
}

}  // namespace

LifecycleManager::LifecycleManager(const rclcpp::NodeOptions& options, StartThread start_thread)
    : Node("lifecycle_manager", options),
      start_thread_(start_thread),
      services_executor_(std::make_shared<rclcpp::executors::SingleThreadedExecutor>()),
      link_(std::make_shared<detail::NodeLink>()),
      diagnostics_updater_(this) {
  RCLCPP_INFO(get_logger(), "Creating");
  read_parameters();
  registerRclPreshutdownCallback();
  const bool has_thread = start_thread_ != nullptr;
  callback_group_ =
      create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, !has_thread);
  if (has_thread) {
    services_executor_->add_callback_group(callback_group_, get_node_base_interface());
  }
  link_->node = this;
  link_->group = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  link_->executor.add_callback_group(link_->group, get_node_base_interface());

  using std::placeholders::_1;
  using std::placeholders::_2;
  using std::placeholders::_3;
  const std::string prefix = std::string(get_name()) + "/";
  manager_srv_ = create_service<ManageLifecycleNodes>(
      prefix + "manage_nodes", std::bind(&LifecycleManager::managerCallback, this, _1, _2, _3),
      rclcpp::SystemDefaultsQoS(), callback_group_);
  is_active_srv_ = create_service<std_srvs::srv::Trigger>(
      prefix + "is_active", std::bind(&LifecycleManager::isActiveCallback, this, _1, _2, _3),
      rclcpp::SystemDefaultsQoS(), callback_group_);
  init_timer_ = create_wall_timer(0s, [this] { begin(); });
  diagnostics_updater_.setHardwareID("Nav2");
  diagnostics_updater_.add("Nav2 Health", this, &LifecycleManager::CreateDiagnostic);
}

LifecycleManager::~LifecycleManager() {
  RCLCPP_INFO(get_logger(), "Destroying %s", get_name());
  thread_.reset();
  get_node_base_interface()->get_context()->remove_pre_shutdown_callback(*preshutdown_);
}

void LifecycleManager::read_parameters() {
  declare_parameter("node_names", rclcpp::PARAMETER_STRING_ARRAY);
  declare_parameter("autostart", false);
  declare_parameter("bond_timeout", 4.0);
  declare_parameter("bond_respawn_max_duration", 10.0);
  declare_parameter("attempt_respawn_reconnection", true);
  node_names_ = get_parameter("node_names").as_string_array();
  autostart_ = get_parameter("autostart").as_bool();
  bond_timeout_ = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::duration<double>(get_parameter("bond_timeout").as_double()));
  bond_respawn_max_duration_ =
      rclcpp::Duration::from_seconds(get_parameter("bond_respawn_max_duration").as_double());
  attempt_respawn_reconnection_ = get_parameter("attempt_respawn_reconnection").as_bool();
}

void LifecycleManager::begin() {
  init_timer_->cancel();
  createLifecycleServiceClients();
  if (!rclcpp::ok()) return;
  // Bonds talk while nothing waits for a node; whatever waits spins them itself.
  link_timer_ = create_wall_timer(
      kLinkPeriod,
      [this] {
        if (has_bonds()) link_->executor.spin_all(kLinkPeriod);
      },
      callback_group_);
  if (autostart_) {
    init_timer_ = create_wall_timer(
        0s,
        [this] {
          init_timer_->cancel();
          startup();
        },
        callback_group_);
  }
  if (start_thread_ != nullptr) thread_ = start_thread_(services_executor_);
}

void LifecycleManager::managerCallback(const std::shared_ptr<rmw_request_id_t>,
                                       const std::shared_ptr<ManageLifecycleNodes::Request> request,
                                       std::shared_ptr<ManageLifecycleNodes::Response> response) {
  using Command = ManageLifecycleNodes::Request;
  switch (request->command) {
    case Command::STARTUP:
      response->success = startup();
      break;
    case Command::CONFIGURE:
      response->success = configure();
      break;
    case Command::CLEANUP:
      response->success = cleanup();
      break;
    case Command::RESET:
      response->success = reset();
      break;
    case Command::SHUTDOWN:
      response->success = shutdown();
      break;
    case Command::PAUSE:
      response->success = pause();
      break;
    case Command::RESUME:
      response->success = resume();
      break;
    default:
      break;
  }
}

bool LifecycleManager::isActive() {
  return managed_nodes_state_ == NodeState::ACTIVE;
}

void LifecycleManager::isActiveCallback(
    const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<std_srvs::srv::Trigger::Request>,
    std::shared_ptr<std_srvs::srv::Trigger::Response> response) {
  response->success = isActive();
}

void LifecycleManager::CreateDiagnostic(diagnostic_updater::DiagnosticStatusWrapper& stat) {
  switch (managed_nodes_state_) {
    case NodeState::ACTIVE:
      stat.summary(DiagnosticStatus::OK, "Managed nodes are active");
      break;
    case NodeState::INACTIVE:
      stat.summary(DiagnosticStatus::OK, "Managed nodes are inactive");
      break;
    case NodeState::UNCONFIGURED:
      stat.summary(DiagnosticStatus::OK, "Managed nodes are unconfigured");
      break;
    case NodeState::FINALIZED:
      stat.summary(DiagnosticStatus::WARN, "Managed nodes have been shut down");
      break;
    case NodeState::UNKNOWN:
      stat.summary(DiagnosticStatus::ERROR, "An error has occurred during a node state transition");
      break;
  }
}

void LifecycleManager::createLifecycleServiceClients() {
  message("Creating and initializing lifecycle service clients");
  const std::vector<std::string> names = node_names_;
  for (const std::string& name : names) {
    const auto node = std::make_shared<detail::ManagedNode>(name, link_);
    nodes_[name] = node;
    node->wait_for_services();
  }
}

void LifecycleManager::destroyLifecycleServiceClients() {
  message("Destroying lifecycle service clients");
  nodes_.clear();
}

LifecycleManager::NodePtr LifecycleManager::node_of(const std::string& name) const {
  const auto found = nodes_.find(name);
  if (found == nodes_.end()) throw std::runtime_error("its clients were destroyed");
  return found->second;
}

bool LifecycleManager::has_bonds() const {
  return std::any_of(nodes_.begin(), nodes_.end(),
                     [](const auto& one) { return one.second->has_bond(); });
}

void LifecycleManager::drop_bonds() {
  for (const auto& [name, node] : nodes_) node->drop_bond();
}

bool LifecycleManager::createBondConnection(const std::string& node_name) {
  const NodePtr node = node_of(node_name);
  if (node->has_bond() || bond_timeout_.count() <= 0) return true;
  if (!node->form_bond(bond_timeout_)) {
    RCLCPP_ERROR(get_logger(),
                 "Server %s was unable to be reached after %0.2fs by bond. "
                 "This server may be misconfigured.",
                 node_name.c_str(), std::chrono::duration<double>(bond_timeout_).count());
    return false;
  }
  RCLCPP_INFO(get_logger(), "Server %s connected with bond.", node_name.c_str());
  return true;
}

bool LifecycleManager::changeStateForNode(const std::string& node_name, std::uint8_t transition) {
  const Change& change = change_of(transition);
  message(change.label + node_name);
  const NodePtr node = node_of(node_name);
  if (!node->change_state(transition) || node->get_state() != change.state) {
    RCLCPP_ERROR(get_logger(), "Failed to change state for node: %s", node_name.c_str());
    return false;
  }
  if (transition == Transition::TRANSITION_ACTIVATE) return createBondConnection(node_name);
  if (transition == Transition::TRANSITION_DEACTIVATE) node->drop_bond();
  return true;
}

bool LifecycleManager::changeStateForAllNodes(std::uint8_t transition, bool hard_change) {
  std::vector<std::string> names = node_names_;
  if (!change_of(transition).goes_up) std::reverse(names.begin(), names.end());
  for (const std::string& name : names) {
    try {
      if (!changeStateForNode(name, transition) && !hard_change) return false;
    } catch (const std::runtime_error& error) {
      RCLCPP_ERROR(get_logger(), "Failed to change state for node: %s. Exception: %s.",
                   name.c_str(), error.what());
      return false;
    }
  }
  return true;
}

void LifecycleManager::shutdownAllNodes() {
  message("Deactivate, cleanup, and shutdown nodes");
  managed_nodes_state_ = NodeState::FINALIZED;
  changeStateForAllNodes(Transition::TRANSITION_DEACTIVATE);
  changeStateForAllNodes(Transition::TRANSITION_CLEANUP);
  changeStateForAllNodes(Transition::TRANSITION_UNCONFIGURED_SHUTDOWN);
}

bool LifecycleManager::fail(const char* text) {
  RCLCPP_ERROR(get_logger(), "%s", text);
  managed_nodes_state_ = NodeState::UNKNOWN;
  return false;
}

bool LifecycleManager::startup() {
  message("Starting managed nodes bringup...");
  if (!changeStateForAllNodes(Transition::TRANSITION_CONFIGURE) ||
      !changeStateForAllNodes(Transition::TRANSITION_ACTIVATE)) {
    return fail("Failed to bring up all requested nodes. Aborting bringup.");
  }
  message("Managed nodes are active");
  managed_nodes_state_ = NodeState::ACTIVE;
  createBondTimer();
  return true;
}

bool LifecycleManager::configure() {
  message("Configuring managed nodes...");
  if (!changeStateForAllNodes(Transition::TRANSITION_CONFIGURE)) {
    return fail("Failed to configure all requested nodes. Aborting bringup.");
  }
  message("Managed nodes are now configured");
  managed_nodes_state_ = NodeState::INACTIVE;
  return true;
}

bool LifecycleManager::cleanup() {
  message("Cleaning up managed nodes...");
  if (!changeStateForAllNodes(Transition::TRANSITION_CLEANUP)) {
    return fail("Failed to cleanup all requested nodes. Aborting cleanup.");
  }
  message("Managed nodes have been cleaned up");
  managed_nodes_state_ = NodeState::UNCONFIGURED;
  return true;
}

bool LifecycleManager::shutdown() {
  destroyBondTimer();
  message("Shutting down managed nodes...");
  shutdownAllNodes();
  destroyLifecycleServiceClients();
  message("Managed nodes have been shut down");
  return true;
}

bool LifecycleManager::reset(bool hard_reset) {
  destroyBondTimer();
  message("Resetting managed nodes...");
  const bool is_down = changeStateForAllNodes(Transition::TRANSITION_DEACTIVATE, hard_reset) &&
                       changeStateForAllNodes(Transition::TRANSITION_CLEANUP, hard_reset);
  if (!is_down && !hard_reset) return fail("Failed to reset nodes: aborting reset");
  message("Managed nodes have been reset");
  managed_nodes_state_ = NodeState::UNCONFIGURED;
  return true;
}

bool LifecycleManager::pause() {
  destroyBondTimer();
  message("Pausing managed nodes...");
  if (!changeStateForAllNodes(Transition::TRANSITION_DEACTIVATE)) {
    return fail("Failed to pause nodes: aborting pause");
  }
  message("Managed nodes have been paused");
  managed_nodes_state_ = NodeState::INACTIVE;
  return true;
}

bool LifecycleManager::resume() {
  message("Resuming managed nodes...");
  if (!changeStateForAllNodes(Transition::TRANSITION_ACTIVATE)) {
    return fail("Failed to resume nodes: aborting resume");
  }
  message("Managed nodes are active");
  managed_nodes_state_ = NodeState::ACTIVE;
  createBondTimer();
  return true;
}

void LifecycleManager::createBondTimer() {
  if (bond_timeout_.count() <= 0) return;
  message("Creating bond timer...");
  bond_timer_ = create_wall_timer(
      kCheckPeriod, [this] { checkBondConnections(); }, callback_group_);
}

void LifecycleManager::destroyBondTimer() {
  if (!bond_timer_) return;
  message("Terminating bond timer...");
  bond_timer_->cancel();
  bond_timer_.reset();
}

void LifecycleManager::registerRclPreshutdownCallback() {
  preshutdown_ = std::make_unique<rclcpp::PreShutdownCallbackHandle>(
      get_node_base_interface()->get_context()->add_pre_shutdown_callback(
          [this] { onRclPreshutdown(); }));
}

void LifecycleManager::onRclPreshutdown() {
  RCLCPP_INFO(get_logger(), "Running Nav2 LifecycleManager rcl preshutdown (%s)", get_name());
  destroyBondTimer();
  // The thread may wait for a node.
  link_->is_ending = true;
  if (thread_) link_->executor.cancel();
  thread_.reset();
  node_names_.clear();
  nodes_.clear();
}

void LifecycleManager::checkBondConnections() {
  if (!isActive() || !rclcpp::ok() || !has_bonds()) return;
  const auto broken =
      std::find_if(node_names_.begin(), node_names_.end(),
                   [this](const auto& name) { return node_of(name)->has_broken_bond(); });
  if (broken == node_names_.end()) return;
  const std::string name = *broken;
  message("Have not received a heartbeat from " + name + ".");
  RCLCPP_ERROR(get_logger(),
               "CRITICAL FAILURE: SERVER %s IS DOWN after not receiving a heartbeat for %i ms."
               " Shutting down related nodes.",
               name.c_str(), static_cast<int>(bond_timeout_.count()));
  reset(true);
  drop_bonds();
  if (attempt_respawn_reconnection_) {
    bond_respawn_timer_ = create_wall_timer(
        kRespawnPeriod, [this] { checkBondRespawnConnection(); }, callback_group_);
  }
}

void LifecycleManager::checkBondRespawnConnection() {
  if (bond_respawn_start_time_.nanoseconds() == 0) bond_respawn_start_time_ = now();
  const auto end = [this] {
    bond_respawn_start_time_ = rclcpp::Time(0);
    bond_respawn_timer_.reset();
  };
  if (isActive() || !rclcpp::ok() || node_names_.empty()) {
    end();
    return;
  }
  const std::vector<std::string> names = node_names_;
  const bool are_back = std::all_of(names.begin(), names.end(), [this](const auto& name) {
    try {
      node_of(name)->get_state();
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  });
  if (are_back) {
    message("Successfully re-established connections from server respawns, starting back up.");
    end();
    startup();
  } else if (now() - bond_respawn_start_time_ >= bond_respawn_max_duration_) {
    message("Failed to re-establish connection from a server crash after maximum timeout.");
    end();
  }
}

void LifecycleManager::message(const std::string& msg) {
  RCLCPP_INFO(get_logger(), "\x1b[34m\33[1m%s\33[0m\x1b[0m", msg.c_str());
}

}  // namespace nav2_lifecycle_manager
