// The older name of this header.
#pragma once

#include "tf2_kdl/tf2_kdl.hpp"
