// A controller of the workspace: one command, one state.
#include <cmath>

#include "controller_interface/controller_interface.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/rclcpp.hpp"

namespace lift_control
{

class RideController : public controller_interface::ControllerInterface
{
public:
  controller_interface::CallbackReturn on_init() override
  {
    height_ = auto_declare<double>("height", 0.0);
    return controller_interface::CallbackReturn::SUCCESS;
  }

  controller_interface::InterfaceConfiguration command_interface_configuration() const override
  {
    return {controller_interface::interface_configuration_type::INDIVIDUAL, {"mast/position"}};
  }

  controller_interface::InterfaceConfiguration state_interface_configuration() const override
  {
    return {controller_interface::interface_configuration_type::REGEX, {"mast/.*"}};
  }

  controller_interface::CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    return controller_interface::CallbackReturn::SUCCESS;
  }

  controller_interface::CallbackReturn on_activate(const rclcpp_lifecycle::State &) override
  {
    return controller_interface::CallbackReturn::SUCCESS;
  }

  controller_interface::return_type update(const rclcpp::Time &, const rclcpp::Duration &) override
  {
    const double now = state_interfaces_[0].get_value();
    if (!command_interfaces_[0].set_value(height_)) {
      return controller_interface::return_type::ERROR;
    }
    if (std::abs(now - height_) < 1e-9 && !arrived_) {
      arrived_ = true;
      RCLCPP_INFO(get_node()->get_logger(), "the mast is at %.1f", now);
    }
    return controller_interface::return_type::OK;
  }

private:
  double height_ = 0.0;
  bool arrived_ = false;
};

}  // namespace lift_control

PLUGINLIB_EXPORT_CLASS(lift_control::RideController, controller_interface::ControllerInterface)
