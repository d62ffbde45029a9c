// A model of SDF as a robot description: natively the parser plugin sdformat_urdf does that, so
// that robot_state_publisher takes a model.sdf.
#pragma once

#include "ros2wasm_xml/xml_document.hpp"
#include "urdf_model/model.h"

namespace urdf {

/// Fills in name, links and joints of the one <model> below <sdf>. The frame of a link is that of
/// the joint which it hangs on, as URDF has it. Throws ParseError.
void read_sdf(const ros2wasm_xml::XmlDocument& xml, ModelInterface& model);

}  // namespace urdf
