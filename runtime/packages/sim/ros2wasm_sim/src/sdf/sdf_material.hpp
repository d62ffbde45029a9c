// Colours of visuals: of SDF's <material>, and of Gazebo's own materials by their names.
#pragma once

#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// Reads a <material>. The `transparency` of its visual is read elsewhere.
Material read_material(Context& context, const Node& node);

/// `Gazebo/Red`; an unknown name is reported once, and is grey.
Material named_material(Context& context, const Node& where, const std::string& name);

/// A material of one colour that light shades.
Material plain_material(const Color& color);

}  // namespace ros2wasm_sim
