// The parts that plugins of Gazebo are made of. One plugin is one file and one row in table.cpp.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "core/simulation.hpp"
#include "plugins/parameters.hpp"
#include "render/scene.hpp"
#include "ros/host.hpp"

namespace ros2wasm_sim {

/// The scene of all cameras, made when the first one asks for it.
class SharedScene {
 public:
  explicit SharedScene(SceneFiles files) : files_(std::move(files)) {}

  RenderScene& of(Simulation& simulation) {
    if (scene_ == nullptr) scene_ = std::make_unique<RenderScene>(simulation, files_);
    return *scene_;
  }

 private:
  SceneFiles files_;
  std::unique_ptr<RenderScene> scene_;
};

/// Where a plugin is, and what it may use. Valid while the plugin is made only, but for the
/// simulation, the host and the scene, which outlive it.
struct PluginContext {
  Simulation& simulation;
  Host& host;
  SharedScene& scene;
  const Plugin& plugin;
  const Model* model = nullptr;    ///< null: of the world
  const Link* link = nullptr;      ///< of the sensor
  const Sensor* sensor = nullptr;  ///< null: not of a sensor
  const Joint* joint = nullptr;    ///< of the sensor, in place of a link

  Physics& physics() const { return simulation.physics(); }
};

/// Why a plugin does not work; the text is an error of its node.
class PluginError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using MakePlugin = std::unique_ptr<System> (*)(const PluginContext& context);

// Gazebo Classic.
std::unique_ptr<System> make_classic_ackermann_drive(const PluginContext& context);
std::unique_ptr<System> make_classic_diff_drive(const PluginContext& context);
std::unique_ptr<System> make_classic_force(const PluginContext& context);
std::unique_ptr<System> make_classic_joint_pose_trajectory(const PluginContext& context);
std::unique_ptr<System> make_classic_joint_state_publisher(const PluginContext& context);
std::unique_ptr<System> make_classic_camera(const PluginContext& context);
std::unique_ptr<System> make_classic_ray_sensor(const PluginContext& context);
std::unique_ptr<System> make_classic_imu_sensor(const PluginContext& context);
std::unique_ptr<System> make_classic_bumper(const PluginContext& context);
std::unique_ptr<System> make_classic_ft_sensor(const PluginContext& context);
std::unique_ptr<System> make_classic_gps_sensor(const PluginContext& context);
std::unique_ptr<System> make_classic_p3d(const PluginContext& context);
std::unique_ptr<System> make_classic_planar_move(const PluginContext& context);

// Gazebo Classic, plugins of a world.
std::unique_ptr<System> make_classic_properties(const PluginContext& context);
std::unique_ptr<System> make_classic_state(const PluginContext& context);

// Gazebo Sim.
std::unique_ptr<System> make_ackermann_steering(const PluginContext& context);
std::unique_ptr<System> make_apply_joint_force(const PluginContext& context);
std::unique_ptr<System> make_detachable_joint(const PluginContext& context);
std::unique_ptr<System> make_diff_drive(const PluginContext& context);
std::unique_ptr<System> make_joint_controller(const PluginContext& context);
std::unique_ptr<System> make_joint_position_controller(const PluginContext& context);
std::unique_ptr<System> make_joint_state_publisher(const PluginContext& context);
std::unique_ptr<System> make_joint_trajectory_controller(const PluginContext& context);
std::unique_ptr<System> make_mecanum_drive(const PluginContext& context);
std::unique_ptr<System> make_odometry_publisher(const PluginContext& context);
std::unique_ptr<System> make_pose_publisher(const PluginContext& context);
std::unique_ptr<System> make_velocity_control(const PluginContext& context);
/// This one is of a world.
std::unique_ptr<System> make_apply_link_wrench(const PluginContext& context);
/// Sensors have no plugin of their own there: a system of the world brings those of its types to
/// life.
std::unique_ptr<System> make_gz_camera(const PluginContext& context);
std::unique_ptr<System> make_gz_depth_camera(const PluginContext& context);
std::unique_ptr<System> make_gz_rgbd_camera(const PluginContext& context);
std::unique_ptr<System> make_gz_lidar(const PluginContext& context);
std::unique_ptr<System> make_gz_imu(const PluginContext& context);
std::unique_ptr<System> make_gz_air_pressure(const PluginContext& context);
std::unique_ptr<System> make_gz_altimeter(const PluginContext& context);
std::unique_ptr<System> make_gz_contact(const PluginContext& context);
std::unique_ptr<System> make_gz_force_torque(const PluginContext& context);
std::unique_ptr<System> make_gz_magnetometer(const PluginContext& context);
std::unique_ptr<System> make_gz_navsat(const PluginContext& context);

/// The joint of the plugin's model. Throws PluginError in upstream's words.
JointHandle joint_of(const PluginContext& context, const std::string& name);

}  // namespace ros2wasm_sim
