// See table.hpp.
#include "plugins/table.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "plugins/plugin.hpp"

namespace ros2wasm_sim {
namespace {

struct PluginRow {
  Flavour flavour;
  std::string_view
      name;  ///< of the library without `lib` and `.so`, or of the class without its namespaces
  MakePlugin make;
};

constexpr std::array kPlugins{
    PluginRow{Flavour::kClassic, "gazebo_ros_camera", make_classic_camera},
    PluginRow{Flavour::kClassic, "gazebo_ros_diff_drive", make_classic_diff_drive},
    PluginRow{Flavour::kClassic, "gazebo_ros_imu_sensor", make_classic_imu_sensor},
    PluginRow{Flavour::kClassic, "gazebo_ros_joint_state_publisher",
              make_classic_joint_state_publisher},
    PluginRow{Flavour::kClassic, "gazebo_ros_p3d", make_classic_p3d},
    PluginRow{Flavour::kClassic, "gazebo_ros_planar_move", make_classic_planar_move},
    PluginRow{Flavour::kClassic, "gazebo_ros_ray_sensor", make_classic_ray_sensor},
    PluginRow{Flavour::kSim, "DiffDrive", make_diff_drive},
    PluginRow{Flavour::kSim, "JointStatePublisher", make_joint_state_publisher},
    PluginRow{Flavour::kSim, "OdometryPublisher", make_odometry_publisher},
    PluginRow{Flavour::kSim, "PosePublisher", make_pose_publisher},
};

struct SensorRow {
  std::string_view type;
  MakePlugin make;
  std::string_view system;  ///< of the world that brings it to life
};

/// The sensors of Gazebo Sim. In Gazebo Classic the plugin of a sensor publishes what it measures.
constexpr std::array kSensors{
    SensorRow{"camera", make_gz_camera, "Sensors"},
    SensorRow{"depth", make_gz_depth_camera, "Sensors"},
    SensorRow{"depth_camera", make_gz_depth_camera, "Sensors"},
    SensorRow{"gpu_lidar", make_gz_lidar, "Sensors"},
    SensorRow{"gpu_ray", make_gz_lidar, "Sensors"},
    SensorRow{"imu", make_gz_imu, "Imu"},
    SensorRow{"lidar", make_gz_lidar, "Sensors"},
    SensorRow{"ray", make_gz_lidar, "Sensors"},
    SensorRow{"rgbd", make_gz_rgbd_camera, "Sensors"},
    SensorRow{"rgbd_camera", make_gz_rgbd_camera, "Sensors"},
};

/// Plugins whose work the simulator does itself, or that are for a window that a site does not
/// have.
constexpr std::array<std::string_view, 15> kBuiltIn{"Physics",
                                                    "UserCommands",
                                                    "SceneBroadcaster",
                                                    "Sensors",
                                                    "Imu",
                                                    "Contact",
                                                    "NavSat",
                                                    "ForceTorque",
                                                    "Altimeter",
                                                    "Magnetometer",
                                                    "gazebo_ros_init",
                                                    "gazebo_ros_factory",
                                                    "gazebo_ros_force_system",
                                                    "gazebo_ros_properties",
                                                    "gazebo_ros_state"};

bool is_built_in(std::string_view name) {
  return std::find(kBuiltIn.begin(), kBuiltIn.end(), name) != kBuiltIn.end();
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

/// Makes the plugins of one model or world.
class Maker {
 public:
  Maker(Host& host, Flavour flavour, Simulation& simulation, SharedScene& scene)
      : host_(host), flavour_(flavour), simulation_(simulation), scene_(scene) {}

  void add_plugin(const Plugin& plugin, const Model* model, const Link* link,
                  const Sensor* sensor) {
    const std::string name =
        flavour_ == Flavour::kClassic ? without_affixes(plugin.filename) : sim_name(plugin);
    const auto row = std::find_if(kPlugins.begin(), kPlugins.end(), [&](const PluginRow& one) {
      return one.flavour == flavour_ && one.name == name;
    });
    if (row != kPlugins.end() && model != nullptr) {
      make(row->make, {simulation_, host_, scene_, plugin, model, link, sensor});
    } else if (!is_built_in(name)) {
      const std::string shown = plugin.filename.empty() ? plugin.name : plugin.filename;
      RCLCPP_WARN(host_.node()->get_logger(),
                  "plugin [%s] (%s) is skipped: the simulator does not have it",
                  plugin.name.c_str(), shown.c_str());
    }
  }

  void add_sensor(const Sensor& sensor, const Model& model, const Link& link) {
    for (const Plugin& plugin : sensor.plugins) add_plugin(plugin, &model, &link, &sensor);
    if (flavour_ == Flavour::kClassic) return;
    const auto row = std::find_if(kSensors.begin(), kSensors.end(),
                                  [&](const SensorRow& one) { return one.type == sensor.type; });
    if (row == kSensors.end()) {
      RCLCPP_WARN(host_.node()->get_logger(),
                  "sensor [%s] of type [%s] is skipped: the simulator does not have it",
                  sensor.name.c_str(), sensor.type.c_str());
      return;
    }
    if (!world_has(row->system)) {
      RCLCPP_WARN(host_.node()->get_logger(),
                  "sensor [%s] of type [%s] is silent: the world lacks <plugin "
                  "filename=\"gz-sim-%s-system\" "
                  "name=\"gz::sim::systems::%s\"/>",
                  sensor.name.c_str(), sensor.type.c_str(),
                  row->system == "Imu" ? "imu" : "sensors", std::string(row->system).c_str());
      return;
    }
    const Plugin none;
    make(row->make, {simulation_, host_, scene_, none, &model, &link, &sensor});
  }

  std::vector<std::unique_ptr<System>> systems;

 private:
  void make(MakePlugin maker, const PluginContext& context) {
    try {
      systems.push_back(maker(context));
    } catch (const std::exception& error) {
      const std::string& name = context.plugin.name;
      RCLCPP_ERROR(name.empty() ? host_.node()->get_logger() : rclcpp::get_logger(name), "%s",
                   error.what());
    }
  }

  /// Upstream: a world with any plugin has only those that it lists.
  bool world_has(std::string_view system) const {
    const auto& plugins = simulation_.world().plugins;
    return std::any_of(plugins.begin(), plugins.end(),
                       [&](const Plugin& plugin) { return sim_name(plugin) == system; });
  }

  Host& host_;
  Flavour flavour_;
  Simulation& simulation_;
  SharedScene& scene_;
};

}  // namespace

JointHandle joint_of(const PluginContext& context, const std::string& name) {
  const JointHandle joint =
      context.physics().joint(context.model->name, context.plugin.model_scope + name);
  if (!joint.valid()) throw PluginError("Joint [" + name + "] not found, plugin will not work.");
  return joint;
}

std::vector<std::unique_ptr<System>> PluginTable::systems_of(const Model& model,
                                                             Simulation& simulation) {
  Maker maker(host_, flavour_, simulation, scene_);
  for (const Link& link : model.links)
    for (const Sensor& sensor : link.sensors) maker.add_sensor(sensor, model, link);
  for (const Plugin& plugin : model.plugins) maker.add_plugin(plugin, &model, nullptr, nullptr);
  return std::move(maker.systems);
}

std::vector<std::unique_ptr<System>> PluginTable::systems_of(const World& world,
                                                             Simulation& simulation) {
  Maker maker(host_, flavour_, simulation, scene_);
  for (const Plugin& plugin : world.plugins) maker.add_plugin(plugin, nullptr, nullptr, nullptr);
  return std::move(maker.systems);
}

}  // namespace ros2wasm_sim
