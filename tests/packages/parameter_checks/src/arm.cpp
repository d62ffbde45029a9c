// A node with parameters of every type, which says what it has at the start and after each change.
#include <cmath>
#include <memory>
#include <parameter_checks/arm_parameters.hpp>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <vector>

namespace {

template <typename T>
std::string joined(const T& values) {
  return fmt::format("{}", fmt::join(values.begin(), values.end(), ","));
}

double sum(tcb::span<const double> values) {
  double result = 0.0;
  for (const double value : values) result += value;
  return result;
}

class Arm : public rclcpp::Node {
 public:
  Arm() : Node("arm"), listener_(get_node_parameters_interface(), get_logger()) {
    params_ = listener_.get_params();
    say();
    RCLCPP_INFO(get_logger(), "stack %.1f %ld %s", listener_.get_stack_params().rate,
                static_cast<long>(listener_.get_stack_params().pid.period),
                std::string(listener_.get_stack_params().mode).c_str());
    const arm::ParamListener left(this, "left");
    RCLCPP_INFO(get_logger(), "left %s",
                has_parameter("left.pid.a.x.limit") ? "is there" : "is missing");
    listener_.setUserCallback([this](const arm::Params& params) { changed_rate_ = params.rate; });
    timer_ = create_wall_timer(std::chrono::milliseconds(20), [this] { look(); });
  }

 private:
  void look() {
    if (!listener_.is_old(params_)) return;
    listener_.refresh_dynamic_parameters();
    if (!listener_.try_get_params(params_) || listener_.try_update_params(params_)) return;
    say();
  }

  void say() {
    const arm::Params& now = params_;
    RCLCPP_INFO(get_logger(),
                "rate %g tries %ld slow %d title %s offset %d base %s serial %ld changed %g",
                now.rate, static_cast<long>(now.tries), now.is_slow ? 1 : 0, now.title.c_str(),
                std::isnan(now.offset) ? 1 : 0, now.base.c_str(), static_cast<long>(now.serial),
                changed_rate_);
    RCLCPP_INFO(get_logger(), "joints %s axes %s flags %zu counts %s weights %s",
                joined(now.joints).c_str(), joined(now.axes).c_str(), now.flags.size(),
                joined(now.counts).c_str(), joined(now.weights).c_str());
    RCLCPP_INFO(get_logger(), "mode %s gains %s (%g) names %s parity %ld",
                rsl::to_string(now.mode).c_str(), joined(now.gains).c_str(), sum(now.gains),
                joined(now.names).c_str(), static_cast<long>(now.parity));
    std::string pids;
    for (const auto& [joint, pid] : now.pid.joints_map) {
      pids += fmt::format(" {}={}", joint, pid.p);
      for (const auto& [axis, entry] : pid.axes_map)
        pids += fmt::format("/{}={}", axis, entry.limit);
    }
    RCLCPP_INFO(get_logger(), "period %ld%s", static_cast<long>(now.pid.period), pids.c_str());
  }

  arm::ParamListener listener_;
  arm::Params params_;
  double changed_rate_ = 0.0;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Arm>());
  rclcpp::shutdown();
  return 0;
}
