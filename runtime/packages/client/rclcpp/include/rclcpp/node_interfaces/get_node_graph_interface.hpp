// get_node_graph_interface: of a node, a pointer to one, or the interface itself.
#pragma once

#include "rclcpp/node_interfaces/node_graph_interface.hpp"
