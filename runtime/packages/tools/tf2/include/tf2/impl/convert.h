// The older name of this header.
#pragma once

#include "tf2/impl/convert.hpp"
