// get_node_time_source_interface: of a node, a pointer to one, or the interface itself.
#pragma once

#include "rclcpp/node_interfaces/node_time_source_interface.hpp"
