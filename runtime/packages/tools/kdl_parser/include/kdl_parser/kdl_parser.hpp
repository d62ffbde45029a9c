// A robot's description as a tree of KDL: one segment for each link but the root.
#pragma once

#include <string>

#include "kdl/tree.hpp"
#include "kdl_parser/visibility_control.hpp"
#include "urdf_model/model.h"

namespace kdl_parser {

/// False, with a line in the log, when the description cannot be read; the tree is as before then.
bool treeFromFile(const std::string& file, KDL::Tree& tree);
bool treeFromString(const std::string& xml, KDL::Tree& tree);

/// False when the model has no root. The inertia of the root is lost, with a warning: KDL has no
/// place for it.
bool treeFromUrdfModel(const urdf::ModelInterface& robot_model, KDL::Tree& tree);

}  // namespace kdl_parser
