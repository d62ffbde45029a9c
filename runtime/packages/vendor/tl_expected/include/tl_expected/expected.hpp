// tl::expected, as ROS 2 packages include it.
#pragma once

#include "tl/expected.hpp"
