// The node that loads controllers, lends them the interfaces of the hardware, and updates them.
// A program calls read, update and write in turn, from one thread, and spins the executor in the
// same thread or in others.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "controller_interface/chainable_controller_interface.hpp"
#include "controller_interface/controller_interface.hpp"
#include "controller_interface/controller_interface_base.hpp"
#include "controller_manager/controller_spec.hpp"
#include "controller_manager_msgs/srv/switch_controller.hpp"
#include "hardware_interface/resource_manager.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/executor.hpp"
#include "rclcpp/node.hpp"
#include "std_msgs/msg/string.hpp"

namespace controller_manager {

rclcpp::NodeOptions get_cm_node_options();

class ManagerServices;
struct ControllerView;
struct SwitchPlan;

class ControllerManager : public rclcpp::Node {
 public:
  static constexpr bool kWaitForAllResources = false;
  static constexpr auto kInfiniteTimeout = 0;

  ControllerManager(std::unique_ptr<hardware_interface::ResourceManager> resource_manager,
                    std::shared_ptr<rclcpp::Executor> executor,
                    const std::string& manager_node_name = "controller_manager",
                    const std::string& node_namespace = "",
                    const rclcpp::NodeOptions& options = get_cm_node_options());
  ControllerManager(std::shared_ptr<rclcpp::Executor> executor,
                    const std::string& manager_node_name = "controller_manager",
                    const std::string& node_namespace = "",
                    const rclcpp::NodeOptions& options = get_cm_node_options());
  ControllerManager(std::shared_ptr<rclcpp::Executor> executor, const std::string& urdf,
                    bool activate_all_hw_components,
                    const std::string& manager_node_name = "controller_manager",
                    const std::string& node_namespace = "",
                    const rclcpp::NodeOptions& options = get_cm_node_options());
  ~ControllerManager() override;

  /// Within update() it is done when the update ends: a controller may end the program.
  bool shutdown_controllers();
  void robot_description_callback(const std_msgs::msg::String& msg);
  void init_resource_manager(const std::string& robot_description);

  /// Null when the type is unknown or the controller fails to initialize; the error is logged.
  controller_interface::ControllerInterfaceBaseSharedPtr load_controller(
      const std::string& controller_name, const std::string& controller_type);
  /// The type is the parameter `<name>.type`.
  controller_interface::ControllerInterfaceBaseSharedPtr load_controller(
      const std::string& controller_name);
  controller_interface::return_type unload_controller(const std::string& controller_name);
  controller_interface::return_type cleanup_controller(const std::string& controller_name);
  std::vector<ControllerSpec> get_loaded_controllers() const;

  template <typename T,
            typename std::enable_if<
                std::is_convertible<T*, controller_interface::ControllerInterfaceBase*>::value,
                T>::type* = nullptr>
  controller_interface::ControllerInterfaceBaseSharedPtr add_controller(
      std::shared_ptr<T> controller, const std::string& controller_name,
      const std::string& controller_type) {
    ControllerSpec controller_spec;
    controller_spec.c = controller;
    controller_spec.info.name = controller_name;
    controller_spec.info.type = controller_type;
    return add_controller_impl(controller_spec);
  }
  controller_interface::ControllerInterfaceBaseSharedPtr add_controller(
      const ControllerSpec& controller_spec) {
    return add_controller_impl(controller_spec);
  }

  controller_interface::return_type configure_controller(const std::string& controller_name);
  /// Waits until the loop has switched, when the loop is another thread.
  controller_interface::return_type switch_controller(
      const std::vector<std::string>& activate_controllers,
      const std::vector<std::string>& deactivate_controllers, int strictness,
      bool activate_asap = kWaitForAllResources,
      const rclcpp::Duration& timeout = rclcpp::Duration::from_nanoseconds(kInfiniteTimeout));
  /// `message` says what was done, or why not.
  controller_interface::return_type switch_controller_cb(
      const std::vector<std::string>& activate_controllers,
      const std::vector<std::string>& deactivate_controllers, int strictness, bool activate_asap,
      const rclcpp::Duration& timeout, std::string& message);

  void read(const rclcpp::Time& time, const rclcpp::Duration& period);
  controller_interface::return_type update(const rclcpp::Time& time,
                                           const rclcpp::Duration& period);
  void write(const rclcpp::Time& time, const rclcpp::Duration& period);

  bool is_resource_manager_initialized() const {
    return resource_manager_ && resource_manager_->are_components_initialized();
  }
  unsigned int get_update_rate() const { return update_rate_; }
  rclcpp::Clock::SharedPtr get_trigger_clock() const { return trigger_clock_; }

 protected:
  void init_services();
  controller_interface::ControllerInterfaceBaseSharedPtr add_controller_impl(
      const ControllerSpec& controller);
  void manage_switch();
  void deactivate_controllers(const std::vector<std::string>& controllers_to_deactivate);
  void switch_chained_mode(const std::vector<std::string>& chained_mode_switch_list,
                           bool to_chained_mode);
  void activate_controllers(const std::vector<std::string>& controllers_to_activate,
                            int strictness);

  unsigned int update_rate_ = 100;  ///< Hz
  std::unique_ptr<hardware_interface::ResourceManager> resource_manager_;

 private:
  friend class ManagerServices;
  using ReturnType = controller_interface::return_type;

  void init_controller_manager(const std::string& urdf);
  void initialize_parameters();
  void set_initial_hardware_components_state();
  void set_components_to(const std::vector<std::string>& components, uint8_t state,
                         const char* label, std::vector<std::string>& rest);
  void start_with_description(const std::string& urdf);

  void make_loaders();
  ControllerSpec* find_controller(const std::string& name);
  std::vector<ControllerView> controller_views() const;
  ReturnType cleanup(const ControllerSpec& controller);
  void remove_exported_interfaces(const ControllerSpec& controller);
  bool export_interfaces(const ControllerSpec& controller);
  bool interfaces_are_well_named(const ControllerSpec& controller) const;
  void sort_controllers();
  void read_controller_parameters(const std::string& name,
                                  hardware_interface::ControllerInfo& info);
  rclcpp::NodeOptions node_options_of(const ControllerSpec& controller) const;

  int known_strictness(int strictness);
  ReturnType switch_result(const SwitchPlan& plan, int strictness, std::string& message);
  bool activate_one(ControllerSpec& spec);
  bool claim_interfaces(ControllerSpec& spec);
  bool is_its_turn(const ControllerSpec& spec, const rclcpp::Time& time,
                   rclcpp::Duration& period) const;
  /// Adds the controllers that failed to `failed`, with those of their chains.
  ReturnType update_all(const rclcpp::Time& time, const rclcpp::Duration& period,
                        std::vector<std::string>& failed);
  ReturnType update_one(ControllerSpec& spec, const rclcpp::Time& time,
                        const rclcpp::Duration& period);
  void fall_back(const std::vector<std::string>& failed);
  void stop_users_of(const std::vector<std::string>& hardware, const char* cycle, bool is_error);
  std::vector<std::string> commands_of(const std::vector<std::string>& controllers);
  void publish_activity();

  std::shared_ptr<rclcpp::Executor> executor_;
  rclcpp::NodeOptions options_;
  /// Made with the first controller.
  std::shared_ptr<pluginlib::ClassLoader<controller_interface::ControllerInterface>> loader_;
  std::shared_ptr<pluginlib::ClassLoader<controller_interface::ChainableControllerInterface>>
      chainable_loader_;

  rclcpp::Clock::SharedPtr trigger_clock_;
  bool use_sim_time_ = false;
  bool updates_ = false;          ///< update() is in its list of controllers
  bool shutdown_is_due_ = false;  ///< it was asked for there
  bool handle_exceptions_ = true;
  bool enforce_command_limits_ = false;
  bool activate_all_hw_components_ = false;
  std::string robot_description_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr robot_description_subscription_;
  rclcpp::TimerBase::SharedPtr robot_description_notification_timer_;
  rclcpp::PreShutdownCallbackHandle shutdown_handle_;
  std::unique_ptr<ManagerServices> services_;

  /// The loop and the services take turns; held for one cycle at most.
  mutable std::recursive_mutex controllers_lock_;
  std::vector<ControllerSpec> controllers_;  ///< in the order of updates
  std::mutex services_lock_;                 ///< one service at a time

  /// The switch that is asked of the loop; null: none.
  std::unique_ptr<SwitchPlan> asked_switch_;
  int asked_strictness_ = 0;
  std::condition_variable_any switch_done_;
  std::thread::id loop_thread_;  ///< none before the first update
};

}  // namespace controller_manager
