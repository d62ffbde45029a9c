// Reads descriptions of plugins: from the index which there are, from each file its classes.
#pragma once

#include <string>
#include <vector>

#include "pluginlib/class_desc.hpp"

namespace pluginlib::impl {

/// The descriptions that packages have for the plugins of `package`, in the order of the packages.
std::vector<std::string> description_paths(const std::string& package,
                                           const std::string& attribute);

/// Throws InvalidXMLException.
std::vector<ClassDesc> read_description(const std::string& path);

}  // namespace pluginlib::impl
