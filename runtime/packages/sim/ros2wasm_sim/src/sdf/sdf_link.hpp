// Links of SDF with all that is in them, and elements that URDF's <gazebo> tags have as well.
#pragma once

#include "sdf/sdf_frames.hpp"
#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// A link whose place is known in `scope`.
Link read_link(Context& context, const Node& node, const Scope& scope, bool is_static);

/// `link` names the link that the sensor or light is in, `pose` is that of the link in its model.
Sensor read_sensor(Context& context, const Node& node, const Scope& scope, const std::string& link,
                   const Pose& pose);
/// The caller sets its pose.
Light read_light(Context& context, const Node& node);
Plugin read_plugin(Context& context, const Node& node);

/// Reads what a <visual> has besides its geometry and pose.
void read_visual_properties(Context& context, const Node& node, Visual& visual);

/// Checks a link that moves: a mass of 0 is an error, impossible moments are a warning.
void check_inertial(Context& context, const Node& where, const std::string& link,
                    const Inertial& inertial);

}  // namespace ros2wasm_sim
