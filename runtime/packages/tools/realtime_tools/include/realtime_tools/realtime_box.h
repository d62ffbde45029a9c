// The older name of this header.
#pragma once

#include "realtime_tools/realtime_box.hpp"
