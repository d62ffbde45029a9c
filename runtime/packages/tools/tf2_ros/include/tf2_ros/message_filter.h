// The older name of this header.
#pragma once

#include "tf2_ros/message_filter.hpp"
