// The older name of this header.
#pragma once

#include "tf2/LinearMath/Scalar.hpp"
