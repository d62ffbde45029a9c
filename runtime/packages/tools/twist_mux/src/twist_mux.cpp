// Several sources of velocities, one output: the source with the highest priority drives.
#include <chrono>
#include <diagnostic_updater/diagnostic_updater.hpp>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "mux_rules.hpp"
#include "std_msgs/msg/bool.hpp"

namespace twist_mux {
namespace {

/// How deep parameters of one input may be nested.
constexpr uint64_t kDepth = 10;

class TwistMux : public rclcpp::Node {
 public:
  TwistMux()
      : Node("twist_mux", "",
             rclcpp::NodeOptions()
                 .allow_undeclared_parameters(true)
                 .automatically_declare_parameters_from_overrides(true)),
        diagnostics_(this) {
    if (!has_parameter("use_stamped")) declare_parameter("use_stamped", true);
    const bool is_stamped = get_parameter("use_stamped").as_bool();
    std::vector<Input> topics = inputs("topics");
    std::vector<Input> locks = inputs("locks");
    rules_ = MuxRules(std::move(topics), std::move(locks));
    if (is_stamped) {
      connect<geometry_msgs::msg::TwistStamped>();
    } else {
      connect<geometry_msgs::msg::Twist>();
    }
    diagnostics_.setHardwareID("none");
    diagnostics_.add("Twist mux status", this, &TwistMux::report);
  }

 private:
  double now_s() { return now().seconds(); }

  /// The inputs below a prefix, in the order of their names.
  std::vector<Input> inputs(const std::string& kind) {
    std::vector<Input> result;
    try {
      for (const std::string& name : list_parameters({kind}, kDepth).prefixes) {
        result.emplace_back(name, fetch<std::string>(name + ".topic"),
                            fetch<double>(name + ".timeout"), fetch<int>(name + ".priority"));
        say(result.back());
      }
    } catch (const std::exception& error) {
      RCLCPP_FATAL(get_logger(), "Error parsing params '%s':\n\t%s", kind.c_str(), error.what());
      throw;
    }
    return result;
  }

  template <typename T>
  T fetch(const std::string& name) {
    rclcpp::Parameter parameter;
    if (!get_parameter(name, parameter)) {
      throw std::runtime_error("could not load parameter '" + name +
                               "'. (namespace: " + get_namespace() + ")");
    }
    return parameter.get_value<T>();
  }

  void say(const Input& input) {
    const std::string timeout =
        input.timeout_s > 0 ? std::to_string(input.timeout_s) + "s" : "None";
    RCLCPP_INFO(get_logger(),
                "Topic handler '%s' subscribed to topic '%s': timeout = %s , priority = %d.",
                input.name.c_str(), input.topic.c_str(), timeout.c_str(), input.priority);
  }

  template <typename VelocityT>
  void connect() {
    const auto output =
        create_publisher<VelocityT>("cmd_vel_out", rclcpp::QoS(rclcpp::KeepLast(1)));
    for (size_t i = 0; i < rules_.topics().size(); ++i) {
      subscriptions_.push_back(
          create_subscription<VelocityT>(rules_.topics()[i].topic, rclcpp::SystemDefaultsQoS(),
                                         [this, output, i](const VelocityT& message) {
                                           if (rules_.receive(i, now_s())) output->publish(message);
                                         }));
    }
    for (size_t i = 0; i < rules_.locks().size(); ++i) {
      subscriptions_.push_back(create_subscription<std_msgs::msg::Bool>(
          rules_.locks()[i].topic, rclcpp::SystemDefaultsQoS(),
          [this, i](const std_msgs::msg::Bool& message) {
            rules_.receive_lock(i, message.data, now_s());
          }));
    }
  }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status) {
    const double now = now_s();
    const int lock_priority = rules_.lock_priority(now);
    status.summary(diagnostic_msgs::msg::DiagnosticStatus::OK, "ok");
    const auto add = [&status](const char* kind, const Input& input, const char* state) {
      status.addf(std::string(kind) + input.name, " %s (listening to %s @ %fs with priority #%d)",
                  state, input.topic.c_str(), input.timeout_s, input.priority);
    };
    for (const Input& topic : rules_.topics()) {
      add("velocity ", topic, topic.is_masked(lock_priority, now) ? "masked" : "unmasked");
    }
    for (const Input& lock : rules_.locks()) {
      add("lock ", lock, lock.is_locked(now) ? "locked" : "free");
    }
    status.add("current priority", lock_priority);
  }

  MuxRules rules_;
  diagnostic_updater::Updater diagnostics_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
};

}  // namespace
}  // namespace twist_mux

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<twist_mux::TwistMux>());
  rclcpp::shutdown();
  return 0;
}
