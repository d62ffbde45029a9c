// The models that nearly every world includes, so that no download is needed.
#include <string>
#include <string_view>

#include "sdf/fuel.hpp"
#include "sdf/sdf_include.hpp"

namespace ros2wasm_sim {
namespace {

constexpr const char* kSun = R"(<?xml version="1.0"?>
<sdf version="1.6">
  <light type="directional" name="sun">
    <cast_shadows>true</cast_shadows>
    <pose>0 0 10 0 0 0</pose>
    <diffuse>0.8 0.8 0.8 1</diffuse>
    <specular>0.2 0.2 0.2 1</specular>
    <attenuation><range>1000</range></attenuation>
    <direction>-0.5 0.1 -0.9</direction>
  </light>
</sdf>
)";

constexpr const char* kGroundPlane = R"(<?xml version="1.0"?>
<sdf version="1.6">
  <model name="ground_plane">
    <static>true</static>
    <link name="link">
      <collision name="collision">
        <geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
        <surface><friction><ode><mu>100</mu><mu2>50</mu2></ode></friction></surface>
      </collision>
      <visual name="visual">
        <cast_shadows>false</cast_shadows>
        <geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
        <material><script><name>Gazebo/Grey</name></script></material>
      </visual>
    </link>
  </model>
</sdf>
)";

}  // namespace

const char* built_in_model(const std::string& uri) {
  constexpr std::string_view kModel = "model://";
  FuelModel model;
  if (uri.compare(0, kModel.size(), kModel) == 0) {
    model.name = uri.substr(kModel.size());
    model.name = model.name.substr(0, model.name.find('/'));
  } else if (const auto of_fuel = fuel_model(uri);
             of_fuel && (of_fuel->owner == "OpenRobotics" || of_fuel->owner == "openrobotics")) {
    model = *of_fuel;
  }
  const std::string name = fuel_folders(model).back();
  return name == "sun" ? kSun : name == "ground_plane" ? kGroundPlane : nullptr;
}

}  // namespace ros2wasm_sim
