// A controller that measures when it is updated: the distance of each update from its time.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "controller_interface/controller_interface.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace control_bench {

class Meter : public controller_interface::ControllerInterface {
 public:
  controller_interface::CallbackReturn on_init() override {
    return controller_interface::CallbackReturn::SUCCESS;
  }
  controller_interface::InterfaceConfiguration command_interface_configuration() const override {
    return {controller_interface::interface_configuration_type::NONE, {}};
  }
  controller_interface::InterfaceConfiguration state_interface_configuration() const override {
    return {controller_interface::interface_configuration_type::ALL, {}};
  }
  controller_interface::return_type update(const rclcpp::Time&, const rclcpp::Duration&) override {
    const auto now = std::chrono::steady_clock::now();
    if (++updates_ > kWarmUp) {
      const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
      jitter_.push_back(std::abs(ms - 1000.0 / get_update_rate()));
    }
    last_ = now;
    if (jitter_.size() == kUpdates) {
      std::sort(jitter_.begin(), jitter_.end());
      RCLCPP_INFO(get_node()->get_logger(), "jitter of %zu updates: median %.3f, p99 %.3f, worst %.3f ms",
                  kUpdates, jitter_[kUpdates / 2], jitter_[kUpdates * 99 / 100], jitter_.back());
    }
    return controller_interface::return_type::OK;
  }

 private:
  static constexpr std::size_t kWarmUp = 200, kUpdates = 1000;
  std::size_t updates_ = 0;
  std::chrono::steady_clock::time_point last_;
  std::vector<double> jitter_;
};

}  // namespace control_bench

PLUGINLIB_EXPORT_CLASS(control_bench::Meter, controller_interface::ControllerInterface)
