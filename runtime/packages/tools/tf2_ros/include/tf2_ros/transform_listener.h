// The older name of this header. Sources of its time take the buffer from it too.
#pragma once

#include "tf2_ros/buffer.hpp"
#include "tf2_ros/transform_listener.hpp"
