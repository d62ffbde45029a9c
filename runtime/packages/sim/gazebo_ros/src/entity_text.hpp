// Descriptions of entities as texts. Pure.
#pragma once

#include <string>

namespace gazebo_ros {

/// Empty when it is XML; else where it stops being so.
std::string fault_of_xml(const std::string& text);

/// A world that includes a model of this name.
std::string database_entity(const std::string& name);

/// `package://` becomes `model://` in the file names of meshes.
std::string with_models_for_packages(const std::string& text);

}  // namespace gazebo_ros
