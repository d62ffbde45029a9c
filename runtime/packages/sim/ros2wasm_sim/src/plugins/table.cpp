// See table.hpp.
#include "plugins/table.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "checks/model_checks.hpp"
#include "checks/plugin_checks.hpp"
#include "plugins/plugin.hpp"

namespace ros2wasm_sim {
namespace {

constexpr std::array kPlugins{
    PluginRow{Flavour::kClassic, "gazebo_ros_ackermann_drive", make_classic_ackermann_drive},
    PluginRow{Flavour::kClassic, "gazebo_ros_bumper", make_classic_bumper, true},
    PluginRow{Flavour::kClassic, "gazebo_ros_camera", make_classic_camera, true},
    PluginRow{Flavour::kClassic, "gazebo_ros_diff_drive", make_classic_diff_drive},
    PluginRow{Flavour::kClassic, "gazebo_ros_force", make_classic_force},
    PluginRow{Flavour::kClassic, "gazebo_ros_ft_sensor", make_classic_ft_sensor},
    PluginRow{Flavour::kClassic, "gazebo_ros_gps_sensor", make_classic_gps_sensor, true},
    PluginRow{Flavour::kClassic, "gazebo_ros_imu_sensor", make_classic_imu_sensor, true},
    PluginRow{Flavour::kClassic, "gazebo_ros_joint_pose_trajectory",
              make_classic_joint_pose_trajectory},
    PluginRow{Flavour::kClassic, "gazebo_ros_joint_state_publisher",
              make_classic_joint_state_publisher},
    PluginRow{Flavour::kClassic, "gazebo_ros_p3d", make_classic_p3d},
    PluginRow{Flavour::kClassic, "gazebo_ros_planar_move", make_classic_planar_move},
    PluginRow{Flavour::kClassic, "gazebo_ros_ray_sensor", make_classic_ray_sensor, true},
    PluginRow{Flavour::kSim, "AckermannSteering", make_ackermann_steering},
    PluginRow{Flavour::kSim, "ApplyJointForce", make_apply_joint_force},
    PluginRow{Flavour::kSim, "DetachableJoint", make_detachable_joint},
    PluginRow{Flavour::kSim, "DiffDrive", make_diff_drive},
    PluginRow{Flavour::kSim, "JointController", make_joint_controller},
    PluginRow{Flavour::kSim, "JointPositionController", make_joint_position_controller},
    PluginRow{Flavour::kSim, "JointStatePublisher", make_joint_state_publisher},
    PluginRow{Flavour::kSim, "JointTrajectoryController", make_joint_trajectory_controller},
    PluginRow{Flavour::kSim, "MecanumDrive", make_mecanum_drive},
    PluginRow{Flavour::kSim, "OdometryPublisher", make_odometry_publisher},
    PluginRow{Flavour::kSim, "PosePublisher", make_pose_publisher},
    PluginRow{Flavour::kSim, "VelocityControl", make_velocity_control},
};

/// Those that a world has, in place of a model.
constexpr std::array kWorldPlugins{
    PluginRow{Flavour::kClassic, "gazebo_ros_properties", make_classic_properties},
    PluginRow{Flavour::kClassic, "gazebo_ros_state", make_classic_state},
    PluginRow{Flavour::kSim, "ApplyLinkWrench", make_apply_link_wrench},
};

struct SensorRow {
  std::string_view type;
  MakePlugin make;
  std::string_view system;               ///< of the world that brings it to life
  std::string_view library = "sensors";  ///< of that system, as in gz-sim-sensors-system
};

/// The sensors of Gazebo Sim. In Gazebo Classic the plugin of a sensor publishes what it measures.
constexpr std::array kSensors{
    SensorRow{"air_pressure", make_gz_air_pressure, "AirPressure", "air-pressure"},
    SensorRow{"altimeter", make_gz_altimeter, "Altimeter", "altimeter"},
    SensorRow{"camera", make_gz_camera, "Sensors"},
    SensorRow{"contact", make_gz_contact, "Contact", "contact"},
    SensorRow{"depth", make_gz_depth_camera, "Sensors"},
    SensorRow{"depth_camera", make_gz_depth_camera, "Sensors"},
    SensorRow{"force_torque", make_gz_force_torque, "ForceTorque", "forcetorque"},
    SensorRow{"gps", make_gz_navsat, "NavSat", "navsat"},
    SensorRow{"gpu_lidar", make_gz_lidar, "Sensors"},
    SensorRow{"gpu_ray", make_gz_lidar, "Sensors"},
    SensorRow{"imu", make_gz_imu, "Imu", "imu"},
    SensorRow{"lidar", make_gz_lidar, "Sensors"},
    SensorRow{"magnetometer", make_gz_magnetometer, "Magnetometer", "magnetometer"},
    SensorRow{"navsat", make_gz_navsat, "NavSat", "navsat"},
    SensorRow{"ray", make_gz_lidar, "Sensors"},
    SensorRow{"rgbd", make_gz_rgbd_camera, "Sensors"},
    SensorRow{"rgbd_camera", make_gz_rgbd_camera, "Sensors"},
};

/// Plugins whose work the simulator does itself, or that are for a window that a site does not
/// have.
constexpr std::string_view kBuiltIn[]{
    "Physics",         "UserCommands",       "SceneBroadcaster",
    "gazebo_ros_init", "gazebo_ros_factory", "gazebo_ros_force_system"};

bool is_built_in(std::string_view name) {
  return std::find(std::begin(kBuiltIn), std::end(kBuiltIn), name) != std::end(kBuiltIn);
}

std::string without_affixes(std::string name) {
  if (name.rfind("lib", 0) == 0) name.erase(0, 3);
  if (name.size() > 3 && name.compare(name.size() - 3, 3, ".so") == 0) name.erase(name.size() - 3);
  return name;
}

/// `gz::sim::systems::DiffDrive`, `ignition::gazebo::systems::DiffDrive`, or libraries such as
/// `gz-sim-diff-drive-system`.
std::string sim_name(const Plugin& plugin) {
  const std::size_t colons = plugin.name.rfind("::");
  if (colons != std::string::npos) return plugin.name.substr(colons + 2);
  std::string library = without_affixes(plugin.filename), name;
  for (const std::string_view prefix : {"gz-sim-", "ignition-gazebo-", "gz-sim8-", "gz-sim7-"})
    if (library.rfind(prefix, 0) == 0) library.erase(0, prefix.size());
  if (const std::size_t end = library.rfind("-system"); end != std::string::npos)
    library.erase(end);
  bool begins = true;
  for (const char sign : library) {
    if (sign == '-') {
      begins = true;
      continue;
    }
    name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(sign))) : sign;
    begins = false;
  }
  return name;
}

/// The system of a row, by its class or, without one, by its library.
bool is_system_of(const Plugin& plugin, const SensorRow& row) {
  if (plugin.name.find("::") != std::string::npos) return sim_name(plugin) == row.system;
  const std::string end = "-" + std::string(row.library) + "-system";
  const std::string library = without_affixes(plugin.filename);
  return library.size() > end.size() &&
         library.compare(library.size() - end.size(), end.size(), end) == 0;
}

/// Makes the plugins of one model or world.
class Maker {
 public:
  Maker(Host& host, Flavour flavour, Simulation& simulation, SharedScene& scene,
        const std::vector<PluginRow>& more)
      : host_(host), flavour_(flavour), simulation_(simulation), scene_(scene), more_(more) {}

  void add_plugin(const Plugin& plugin, const Model* model, const Link* link,
                  const Sensor* sensor) {
    const std::string name =
        flavour_ == Flavour::kClassic ? without_affixes(plugin.filename) : sim_name(plugin);
    const PluginRow* const row =
        row_of(kPlugins, name) ? row_of(kPlugins, name) : row_of(more_, name);
    const PluginRow* const of_world = row_of(kWorldPlugins, name);
    if (row != nullptr && row->is_of_sensor && link == nullptr) {
      RCLCPP_ERROR(host_.node()->get_logger(),
                   "plugin [%s] (%s) does not work here: it must be inside a <sensor> of a link",
                   plugin.name.c_str(), plugin.filename.c_str());
    } else if (row != nullptr && model != nullptr) {
      for (const std::string& remark : unread_elements(name, Parameters(plugin.xml)))
        RCLCPP_WARN(host_.node()->get_logger(), "plugin [%s] of [%s]: %s", plugin.name.c_str(),
                    model->name.c_str(), remark.c_str());
      make(row->make, {simulation_, host_, scene_, plugin, model, link, sensor});
    } else if (of_world != nullptr && model == nullptr) {
      make(of_world->make, {simulation_, host_, scene_, plugin, nullptr, nullptr, nullptr});
    } else if (!is_built_in(name) && !brings_sensors_to_life(plugin)) {
      const std::string shown = plugin.filename.empty() ? plugin.name : plugin.filename;
      const bool is_classic = flavour_ == Flavour::kClassic;
      std::string successor = successor_of(without_affixes(plugin.filename), is_classic);
      if (successor.empty()) successor = successor_of(sim_name(plugin), is_classic);
      RCLCPP_WARN(host_.node()->get_logger(),
                  "plugin [%s] (%s) is skipped: the simulator does not have it%s%s",
                  plugin.name.c_str(), shown.c_str(), successor.empty() ? "" : "; ",
                  successor.c_str());
    }
  }

  /// Says what is probably wrong with a model, where it begins.
  void check(const Model& model) const {
    const auto say = [&](const std::optional<std::string>& remark) {
      if (remark) RCLCPP_WARN(host_.node()->get_logger(), "%s", remark->c_str());
    };
    say(inertia_remark(model));
    if (const auto ground = ground_height(simulation_.world())) say(height_remark(model, *ground));
  }

  /// A sensor is of a link or of a joint; the other one is null.
  void add_sensor(const Sensor& sensor, const Model& model, const Link* link, const Joint* joint) {
    for (const Plugin& plugin : sensor.plugins) add_plugin(plugin, &model, link, &sensor);
    if (flavour_ == Flavour::kClassic) return;
    const auto row = std::find_if(kSensors.begin(), kSensors.end(),
                                  [&](const SensorRow& one) { return one.type == sensor.type; });
    if (row == kSensors.end()) {
      RCLCPP_WARN(host_.node()->get_logger(),
                  "sensor [%s] of type [%s] is skipped: the simulator does not have it",
                  sensor.name.c_str(), sensor.type.c_str());
      return;
    }
    if (!world_has(*row)) {
      RCLCPP_WARN(host_.node()->get_logger(),
                  "sensor [%s] of type [%s] is silent: the world lacks <plugin "
                  "filename=\"gz-sim-%s-system\" "
                  "name=\"gz::sim::systems::%s\"/>",
                  sensor.name.c_str(), sensor.type.c_str(), std::string(row->library).c_str(),
                  std::string(row->system).c_str());
      return;
    }
    const bool is_of_joint = row->system == "ForceTorque";
    if (is_of_joint != (joint != nullptr)) {
      RCLCPP_WARN(host_.node()->get_logger(),
                  "sensor [%s] of type [%s] is skipped: it must be in a <%s>", sensor.name.c_str(),
                  sensor.type.c_str(), is_of_joint ? "joint" : "link");
      return;
    }
    const Plugin none;
    make(row->make, {simulation_, host_, scene_, none, &model, link, &sensor, joint});
  }

  std::vector<std::unique_ptr<System>> systems;

 private:
  /// Null: there is none of that name.
  template <typename Rows>
  const PluginRow* row_of(const Rows& rows, std::string_view name) const {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const PluginRow& one) {
      return one.flavour == flavour_ && one.name == name;
    });
    return found == rows.end() ? nullptr : &*found;
  }

  void make(MakePlugin maker, const PluginContext& context) {
    try {
      systems.push_back(maker(context));
    } catch (const std::exception& error) {
      const std::string& name = context.plugin.name;
      RCLCPP_ERROR(name.empty() ? host_.node()->get_logger() : rclcpp::get_logger(name), "%s",
                   error.what());
    }
  }

  /// Upstream: a world with any plugin has only those that it lists. A system serves all sensors of
  /// the world, also when a model brings it along.
  bool world_has(const SensorRow& row) const {
    const auto lists = [&](const std::vector<Plugin>& plugins) {
      return std::any_of(plugins.begin(), plugins.end(),
                         [&](const Plugin& plugin) { return is_system_of(plugin, row); });
    };
    const World& world = simulation_.world();
    return lists(world.plugins) ||
           std::any_of(world.models.begin(), world.models.end(),
                       [&](const Model& model) { return lists(model.plugins); });
  }

  bool brings_sensors_to_life(const Plugin& plugin) const {
    return flavour_ == Flavour::kSim &&
           std::any_of(kSensors.begin(), kSensors.end(),
                       [&](const SensorRow& row) { return is_system_of(plugin, row); });
  }

  Host& host_;
  Flavour flavour_;
  Simulation& simulation_;
  SharedScene& scene_;
  const std::vector<PluginRow>& more_;
};

}  // namespace

JointHandle joint_of(const PluginContext& context, const std::string& name) {
  const JointHandle joint =
      context.physics().joint(context.model->name, context.plugin.model_scope + name);
  if (!joint.valid())
    throw PluginError("Joint [" + name + "] not found, plugin will not work." +
                      nearest_joint(*context.model, context.plugin.model_scope + name));
  return joint;
}

std::vector<std::unique_ptr<System>> PluginTable::systems_of(const Model& model,
                                                             Simulation& simulation) {
  Maker maker(host_, flavour_, simulation, scene_, more_);
  maker.check(model);
  for (const Link& link : model.links)
    for (const Sensor& sensor : link.sensors) maker.add_sensor(sensor, model, &link, nullptr);
  for (const Joint& joint : model.joints)
    for (const Sensor& sensor : joint.sensors) maker.add_sensor(sensor, model, nullptr, &joint);
  for (const Plugin& plugin : model.plugins) maker.add_plugin(plugin, &model, nullptr, nullptr);
  return std::move(maker.systems);
}

std::vector<std::unique_ptr<System>> PluginTable::systems_of(const World& world,
                                                             Simulation& simulation) {
  Maker maker(host_, flavour_, simulation, scene_, more_);
  for (const Plugin& plugin : world.plugins) maker.add_plugin(plugin, nullptr, nullptr, nullptr);
  return std::move(maker.systems);
}

}  // namespace ros2wasm_sim
