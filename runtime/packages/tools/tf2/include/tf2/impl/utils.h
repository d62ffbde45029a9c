// What tf2/utils.hpp makes quaternions with.
#pragma once

#include "tf2/utils.hpp"
