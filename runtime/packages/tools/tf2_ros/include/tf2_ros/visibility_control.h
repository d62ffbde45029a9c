// The older name of this header.
#pragma once

#include "tf2_ros/visibility_control.hpp"
