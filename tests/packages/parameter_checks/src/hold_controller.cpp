// A controller as those of ros2_controllers are written: its parameters are of a YAML file.
#include <controller_interface/controller_interface.hpp>
#include <cstdio>
#include <memory>
#include <parameter_checks/hold_controller_parameters.hpp>
#include <pluginlib/class_list_macros.hpp>

namespace hold_controller {

class HoldController : public controller_interface::ControllerInterface {
 public:
  controller_interface::CallbackReturn on_init() override {
    try {
      param_listener_ = std::make_shared<ParamListener>(get_node());
      params_ = param_listener_->get_params();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
      return controller_interface::CallbackReturn::ERROR;
    }
    return controller_interface::CallbackReturn::SUCCESS;
  }

  controller_interface::InterfaceConfiguration command_interface_configuration() const override {
    controller_interface::InterfaceConfiguration result{
        controller_interface::interface_configuration_type::INDIVIDUAL, {}};
    for (const auto& joint : params_.joints)
      result.names.push_back(joint + "/" + params_.interface_name);
    return result;
  }

  controller_interface::InterfaceConfiguration state_interface_configuration() const override {
    return command_interface_configuration();
  }

  controller_interface::CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    param_listener_->refresh_dynamic_parameters();
    params_ = param_listener_->get_params();
    return controller_interface::CallbackReturn::SUCCESS;
  }

  controller_interface::return_type update(const rclcpp::Time&, const rclcpp::Duration&) override {
    param_listener_->try_update_params(params_);
    double error = 0.0;
    for (size_t i = 0; i < params_.joints.size(); ++i) {
      const double at = params_.hold.joints_map.at(params_.joints[i]).at;
      if (!command_interfaces_[i].set_value(at)) return controller_interface::return_type::ERROR;
      error += std::abs(state_interfaces_[i].get_optional().value_or(99.0) - at);
    }
    if (error < 1e-9 && said_ != params_.hold.joints_map.at("lift").at) {
      said_ = params_.hold.joints_map.at("lift").at;
      RCLCPP_INFO(get_node()->get_logger(), "lift is held at %.2f", said_);
    }
    return controller_interface::return_type::OK;
  }

 private:
  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  double said_ = 99.0;
};

}  // namespace hold_controller

PLUGINLIB_EXPORT_CLASS(hold_controller::HoldController, controller_interface::ControllerInterface)
