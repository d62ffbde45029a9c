// The components of a robot and the steps of their lives. Locking is the resource manager's.
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "hardware_interface/hardware_component.hpp"
#include "hardware_interface/hardware_component_info.hpp"
#include "hardware_interface/resource_manager.hpp"
#include "interface_ledger.hpp"
#include "joint_limits/data_structures.hpp"
#include "joint_limits/joint_limits.hpp"

namespace hardware_interface {

class ResourceStorage {
 public:
  ResourceStorage(rclcpp::Logger logger, bool handle_exceptions);

  /// Null, after a logged error, when the plugin cannot be made.
  std::unique_ptr<HardwareComponentInterface> load(const HardwareInfo& info);
  /// Initializes the component and adds its interfaces. False, after a logged error, when it
  /// refuses.
  bool add(std::unique_ptr<HardwareComponentInterface> plugin,
           const HardwareComponentParams& params);
  void clear();

  /// Leads a component to a primary state, step by step. False when a step fails.
  bool lead_to(HardwareComponent& component, uint8_t target);
  /// After an error the interfaces of a component are gone until it is configured again.
  void withdraw(const std::string& component);

  /// In the order in which they are read and written: actuators, sensors, systems, each in the
  /// order of the description.
  [[nodiscard]] std::vector<HardwareComponent*> components();
  HardwareComponent* find(const std::string& name);
  [[nodiscard]] std::size_t count(const std::string& type) const;
  HardwareComponentInfo& info(const std::string& name) { return infos_.at(name); }
  std::unordered_map<std::string, HardwareComponentInfo>& refreshed_infos();

  /// A component that fails fails its group.
  return_type with_group(const std::string& group, return_type result);
  /// Calls `action`; an exception is logged and becomes `otherwise`, unless they are to pass.
  template <typename ResultT>
  ResultT guarded(const char* doing, const std::string& component,
                  const std::function<ResultT()>& action, ResultT otherwise);

  InterfaceLedger ledger;
  std::map<std::string, std::vector<std::string>> exported_states;      ///< by controller
  std::map<std::string, std::vector<std::string>> exported_references;  ///< by controller
  std::map<std::string, std::vector<std::string>> users;  ///< controllers by component
  std::map<std::string, joint_limits::JointInterfacesCommandLimiterData> limited_joints;
  std::unordered_map<std::string, joint_limits::JointLimits> hard_limits;
  std::unordered_map<std::string, joint_limits::SoftJointLimits> soft_limits;
  std::function<void()> on_state_switch;

 private:
  struct Loaders;
  bool step(HardwareComponent& component, const char* name,
            const rclcpp_lifecycle::State& (HardwareComponent::*action)(), uint8_t wanted);
  bool configure(HardwareComponent& component);
  void log_exception(const char* doing, const std::string& component, const std::exception& error);

  std::list<HardwareComponent> components_;
  std::unordered_map<std::string, HardwareComponentInfo> infos_;
  std::map<std::string, return_type> groups_;
  std::shared_ptr<Loaders> loaders_;  ///< made with the first component of a description
  rclcpp::Logger logger_;
  bool handle_exceptions_;
};

template <typename ResultT>
ResultT ResourceStorage::guarded(const char* doing, const std::string& component,
                                 const std::function<ResultT()>& action, ResultT otherwise) {
  try {
    return action();
  } catch (const std::exception& error) {
    log_exception(doing, component, error);
    if (!handle_exceptions_) {
      throw;
    }
  }
  return otherwise;
}

}  // namespace hardware_interface
