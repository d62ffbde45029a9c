// Parts of URDF's links: origins, shapes, colours and masses.
#pragma once

#include <unordered_map>

#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// The <origin> of an element.
Pose urdf_origin(Context& context, const Node& parent);
/// A number that an attribute has; the default when there is none and it is not required.
double urdf_number(Context& context, const Node& node, const std::string& name,
                   std::optional<double> by_default, Range range = Range::kFinite);
std::optional<Inertial> urdf_inertial(Context& context, const Node& link);

using UrdfMaterials = std::unordered_map<std::string, Material>;
/// All materials that have a colour or picture, by name.
UrdfMaterials urdf_materials(Context& context, const Node& robot);

Collision urdf_collision(Context& context, const Node& node);
Visual urdf_visual(Context& context, const Node& node, const UrdfMaterials& materials);

}  // namespace ros2wasm_sim
