// The older name of this header.
#pragma once

#include "tf2_eigen/tf2_eigen.hpp"
