// The hardware of a robot that is simulated: its joints and sensors as ros2_control sees them.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/simulation.hpp"
#include "hardware_interface/system_interface.hpp"
#include "plugins/table.hpp"

namespace ros2wasm_sim {

struct SimHardwareSettings {
  Flavour flavour = Flavour::kSim;
  std::string model;
  double position_gain = 0.1;  ///< of Gazebo Sim, per control period
  double update_rate = 100;    ///< of the controller manager, in Hz
  bool hold_joints = true;     ///< joints without a command rest
};

class SimHardware final : public hardware_interface::SystemInterface {
 public:
  SimHardware(Simulation& simulation, SimHardwareSettings settings)
      : simulation_(simulation), settings_(std::move(settings)) {}

  hardware_interface::CallbackReturn on_init(
      const hardware_interface::HardwareComponentInterfaceParams& params) override;
  hardware_interface::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  hardware_interface::return_type perform_command_mode_switch(
      const std::vector<std::string>& start, const std::vector<std::string>& stop) override;
  hardware_interface::return_type read(const rclcpp::Time& time,
                                       const rclcpp::Duration& period) override;
  hardware_interface::return_type write(const rclcpp::Time& time,
                                        const rclcpp::Duration& period) override;

 private:
  enum class Mode { kNone, kPosition, kVelocity, kEffort };
  struct DrivenJoint {
    std::string name;
    JointHandle joint;
    Mode mode = Mode::kNone;
    bool has_commands = false;
    double initial = 0;  ///< position, in rad or m
    bool has_initial = false;
    hardware_interface::StateInterface::SharedPtr position, velocity, effort;
    hardware_interface::CommandInterface::SharedPtr position_command, velocity_command,
        effort_command;
  };
  /// One value of a sensor.
  struct Reading {
    hardware_interface::StateInterface::SharedPtr state;
    std::function<double()> value;
  };

  void add_joint(const hardware_interface::ComponentInfo& info, JointHandle joint);
  void find_interfaces(DrivenJoint& joint);
  void find_readings(const hardware_interface::ComponentInfo& sensor);
  /// Nothing: the model has no such sensor, or it measures something else.
  std::function<double()> reading_of(const std::string& sensor, const std::string& interface);
  void command(const DrivenJoint& joint);

  Simulation& simulation_;
  SimHardwareSettings settings_;
  std::vector<DrivenJoint> driven_;
  std::vector<Reading> readings_;
};

}  // namespace ros2wasm_sim
