// The functions with which tf2/utils.hpp makes quaternions.
#pragma once

#include "tf2/utils.hpp"
