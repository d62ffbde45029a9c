// get_node_waitables_interface: of a node, a pointer to one, or the interface itself.
#pragma once

#include "rclcpp/node_interfaces/node_waitables_interface.hpp"
