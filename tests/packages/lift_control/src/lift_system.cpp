// Hardware in the older form: doubles of its own, exported as vectors of handles.
#include <string>
#include <vector>

#include "hardware_interface/system_interface.hpp"
#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/rclcpp.hpp"

namespace lift_control
{

class LiftSystem : public hardware_interface::SystemInterface
{
public:
  hardware_interface::CallbackReturn on_init(const hardware_interface::HardwareInfo & info) override
  {
    if (hardware_interface::SystemInterface::on_init(info) != hardware_interface::CallbackReturn::SUCCESS) {
      return hardware_interface::CallbackReturn::ERROR;
    }
    const double floor = std::stod(info_.hardware_parameters.at("floor"));
    positions_.assign(info_.joints.size(), 0.0);
    positions_[0] = floor;
    commands_ = positions_;
    RCLCPP_INFO(rclcpp::get_logger("LiftSystem"), "the %s starts at %.1f", info_.joints[0].name.c_str(), floor);
    return hardware_interface::CallbackReturn::SUCCESS;
  }

  std::vector<hardware_interface::StateInterface> export_state_interfaces() override
  {
    std::vector<hardware_interface::StateInterface> states;
    for (std::size_t i = 0; i < info_.joints.size(); ++i) {
      states.emplace_back(hardware_interface::StateInterface(
        info_.joints[i].name, hardware_interface::HW_IF_POSITION, &positions_[i]));
    }
    return states;
  }

  std::vector<hardware_interface::CommandInterface> export_command_interfaces() override
  {
    std::vector<hardware_interface::CommandInterface> commands;
    for (std::size_t i = 0; i < info_.joints.size(); ++i) {
      commands.emplace_back(hardware_interface::CommandInterface(
        info_.joints[i].name, hardware_interface::HW_IF_POSITION, &commands_[i]));
    }
    return commands;
  }

  hardware_interface::return_type read(const rclcpp::Time &, const rclcpp::Duration & period) override
  {
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const double step = 2.0 * period.seconds();
      const double rest = commands_[i] - positions_[i];
      positions_[i] += rest > step ? step : rest < -step ? -step : rest;
    }
    return hardware_interface::return_type::OK;
  }

  hardware_interface::return_type write(const rclcpp::Time &, const rclcpp::Duration &) override
  {
    return hardware_interface::return_type::OK;
  }

private:
  std::vector<double> positions_;
  std::vector<double> commands_;
};

}  // namespace lift_control

PLUGINLIB_EXPORT_CLASS(lift_control::LiftSystem, hardware_interface::SystemInterface)
