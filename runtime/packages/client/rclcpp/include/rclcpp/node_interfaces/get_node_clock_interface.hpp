// get_node_clock_interface: of a node, a pointer to one, or the interface itself.
#pragma once

#include "rclcpp/node_interfaces/node_clock_interface.hpp"
