// The models that nearly every world includes, so that no download is needed.
#include <string_view>

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

/// In small letters, with `_` for spaces.
std::string plain(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char letter = text[i];
    if (text.substr(i, 3) == "%20") {
      letter = '_';
      i += 2;
    }
    letter = letter == ' ' ? '_' : letter;
    result += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return result;
}

}  // namespace

const char* built_in_model(const std::string& uri) {
  if (uri.size() > 200) {
    return nullptr;
  }
  std::string name = plain(uri);
  const auto skip = [&name](std::string_view prefix) {
    const bool is_there = name.compare(0, prefix.size(), prefix) == 0;
    name.erase(0, is_there ? prefix.size() : 0);
    return is_there;
  };
  if (!skip("model://")) {
    if (!skip("https://") && !skip("http://")) {
      return nullptr;
    }
    if (!skip("fuel.gazebosim.org/") && !skip("fuel.ignitionrobotics.org/") &&
        !skip("app.gazebosim.org/") && !skip("app.ignitionrobotics.org/")) {
      return nullptr;
    }
    skip("1.0/");
    if (!skip("openrobotics/")) {
      return nullptr;
    }
    skip("fuel/");
    if (!skip("models/")) {
      return nullptr;
    }
  }
  // A version, such as /2, /tip or a slash at the end.
  name = name.substr(0, name.find('/'));
  return name == "sun" ? kSun : name == "ground_plane" ? kGroundPlane : nullptr;
}

}  // namespace ros2wasm_sim
