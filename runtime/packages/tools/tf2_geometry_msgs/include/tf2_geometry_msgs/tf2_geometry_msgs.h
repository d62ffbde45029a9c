// The older name of this header.
#pragma once

#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
