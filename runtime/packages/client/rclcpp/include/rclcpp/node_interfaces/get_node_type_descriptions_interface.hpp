// get_node_type_descriptions_interface: of a node, a pointer to one, or the interface itself.
#pragma once

#include "rclcpp/node_interfaces/node_type_descriptions_interface.hpp"
