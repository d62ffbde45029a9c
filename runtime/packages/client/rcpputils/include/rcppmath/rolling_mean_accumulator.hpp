// The older name of rcpputils/rolling_mean_accumulator.hpp.
#pragma once

#include "rcpputils/rolling_mean_accumulator.hpp"

namespace rcppmath {
using rcpputils::RollingMeanAccumulator;
}  // namespace rcppmath
