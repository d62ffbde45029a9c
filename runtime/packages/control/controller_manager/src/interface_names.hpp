// The interfaces that a controller's configuration names.
#pragma once

#include <string>
#include <vector>

#include "controller_interface/controller_interface_base.hpp"

namespace controller_manager {

/// `available` are the names that exist now, sorted. Throws std::runtime_error for a pattern that
/// is not a regular expression.
std::vector<std::string> names_of(const controller_interface::InterfaceConfiguration& configuration,
                                  const std::vector<std::string>& available);

}  // namespace controller_manager
