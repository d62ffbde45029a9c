// get_node_logging_interface: of a node, a pointer to one, or the interface itself.
#pragma once

#include "rclcpp/node_interfaces/node_logging_interface.hpp"
