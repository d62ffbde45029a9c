// The older name of this header.
#pragma once

#include "tf2/transform_datatypes.hpp"
