// The elements of a description, each as the type of the model that it stands for. They throw
// ParseError for what is missing or wrong.
#pragma once

#include "ros2wasm_xml/xml_document.hpp"
#include "urdf_model/joint.h"
#include "urdf_model/link.h"

namespace urdf {

using ros2wasm_xml::XmlDocument;
using ros2wasm_xml::XmlElement;

/// The value; ParseError, naming `what`, when there is none.
const std::string& required(const XmlElement& element, const std::string& key,
                            const std::string& what);
MaterialSharedPtr material_of(const XmlDocument& xml, const XmlElement& element, bool may_be_name);
LinkSharedPtr link_of(const XmlDocument& xml, const XmlElement& element);
JointSharedPtr joint_of(const XmlDocument& xml, const XmlElement& element);

}  // namespace urdf
