// The older name of this header.
#pragma once

#include "tf2_ros/static_transform_broadcaster.hpp"
