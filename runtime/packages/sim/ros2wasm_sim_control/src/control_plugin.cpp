// See control_plugin.hpp.
#include "control_plugin.hpp"

#include <memory>
#include <string>
#include <utility>

#include "controller_manager/controller_manager.hpp"
#include "ros/resources.hpp"
#include "sim_resource_manager.hpp"

namespace ros2wasm_sim {
namespace {

using controller_manager::ControllerManager;

rclcpp::Time time_of(std::int64_t time_ns) {
  return rclcpp::Time(time_ns, RCL_ROS_TIME);
}

/// Commands act in every step: at the rate of the controllers alone the joints would tremble.
class ControlPlugin final : public System {
 public:
  ControlPlugin(const PluginContext& context, Flavour flavour)
      : simulation_(context.simulation), host_(context.host) {
    const Parameters parameters(context.plugin.xml);
    const rclcpp::Logger logger = host_.node()->get_logger();
    rclcpp::NodeOptions options = controller_manager::get_cm_node_options();
    options.arguments(arguments_of(parameters, logger));
    SimHardwareSettings settings;
    settings.flavour = flavour;
    settings.model = context.model->name;
    settings.hold_joints = parameters.flag("hold_joints", true);
    settings.position_gain = parameters.number("position_proportional_gain", 0.1);
    hardware_interface::ResourceManagerParams params;
    params.clock = host_.node()->get_clock();
    auto hardware = std::make_unique<SimResourceManager>(params, simulation_, settings);
    SimResourceManager& made = *hardware;
    RCLCPP_INFO(logger, flavour == Flavour::kClassic ? "Loading gazebo_ros2_control plugin"
                                                     : "Loading controller_manager");
    const std::string name = flavour == Flavour::kClassic
                                 ? std::string("controller_manager")
                                 : parameters.text("controller_manager_name", "controller_manager");
    manager_ =
        std::make_shared<ControllerManager>(std::move(hardware), host_.executor(), name,
                                            namespace_of(context.plugin, parameters), options);
    made.set_update_rate(manager_->get_update_rate());
    host_.executor()->add_node(manager_);
    period_ns_ = 1'000'000'000 / static_cast<std::int64_t>(manager_->get_update_rate());
    check_period(logger);
    if (flavour == Flavour::kClassic) RCLCPP_INFO(logger, "Loaded gazebo_ros2_control.");
  }

  ~ControlPlugin() override {
    manager_->shutdown_controllers();
    host_.executor()->remove_node(manager_);
  }

  void before_step(const Now& now) override {
    if (!manager_->is_resource_manager_initialized()) return;
    manager_->write(time_of(now.time_ns),
                    rclcpp::Duration::from_nanoseconds(static_cast<std::int64_t>(now.step * 1e9)));
  }

  void after_step(const Now& now) override {
    if (!manager_->is_resource_manager_initialized()) return;
    const std::int64_t passed = now.time_ns - last_ns_;
    if (passed < period_ns_) return;
    last_ns_ = now.time_ns;
    const rclcpp::Time time = time_of(now.time_ns);
    const rclcpp::Duration period = rclcpp::Duration::from_nanoseconds(passed);
    manager_->read(time, period);
    manager_->update(time, period);
  }

  void on_reset() override { last_ns_ = simulation_.time_ns(); }

 private:
  static std::string namespace_of(const Plugin& plugin, const Parameters& parameters) {
    return plugin.robot_namespace.empty() ? parameters.inside("ros").text("namespace", "")
                                          : plugin.robot_namespace;
  }

  /// Files of parameters, remappings, and the time of the simulation.
  static std::vector<std::string> arguments_of(const Parameters& parameters,
                                               const rclcpp::Logger& logger) {
    std::vector<std::string> arguments{"--ros-args"};
    for (const std::string& file : parameters.all("parameters")) {
      std::vector<std::string> searched;
      const auto found = site_resources().find(file, searched);
      if (found) {
        arguments.insert(arguments.end(), {"--params-file", *found});
      } else {
        RCLCPP_ERROR(logger, "the file of parameters [%s] is not found (searched: %s)",
                     file.c_str(), listed(searched).c_str());
      }
    }
    for (const std::string& rule : parameters.inside("ros").all("remapping"))
      arguments.insert(arguments.end(), {"-r", rule});
    arguments.insert(arguments.end(), {"-p", "use_sim_time:=true"});
    return arguments;
  }

  void check_period(const rclcpp::Logger& logger) const {
    const double control = static_cast<double>(period_ns_) * 1e-9;
    const double step = static_cast<double>(simulation_.step_ns()) * 1e-9;
    if (period_ns_ < simulation_.step_ns())
      RCLCPP_ERROR(logger,
                   "Desired controller update period (%g s) is faster than the gazebo simulation "
                   "period (%g s).",
                   control, step);
    else if (period_ns_ > simulation_.step_ns())
      RCLCPP_WARN(logger,
                  "Desired controller update period (%g s) is slower than the gazebo simulation "
                  "period (%g s).",
                  control, step);
  }

  Simulation& simulation_;
  Host& host_;
  std::shared_ptr<ControllerManager> manager_;
  std::int64_t period_ns_ = 0;
  std::int64_t last_ns_ = 0;
};

template <Flavour flavour>
std::unique_ptr<System> make_control(const PluginContext& context) {
  return std::make_unique<ControlPlugin>(context, flavour);
}

}  // namespace

std::vector<PluginRow> control_plugins() {
  return {
      {Flavour::kClassic, "gazebo_ros2_control", make_control<Flavour::kClassic>},
      {Flavour::kSim, "GazeboSimROS2ControlPlugin", make_control<Flavour::kSim>},
      {Flavour::kSim, "IgnitionROS2ControlPlugin", make_control<Flavour::kSim>},
  };
}

}  // namespace ros2wasm_sim
