// URDF with its <gazebo> tags, by the rules of SDFormat: fixed joints are lumped, links without
// mass vanish.
#pragma once

#include <memory>
#include <string>

#include "sdf/reading.hpp"

namespace ros2wasm_sim {

Reading<Model> read_urdf(const std::shared_ptr<const ros2wasm_xml::XmlDocument>& document,
                         const std::string& file, const Resources& resources);

}  // namespace ros2wasm_sim
