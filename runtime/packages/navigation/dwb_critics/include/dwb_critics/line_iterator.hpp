// The cells on a line.
#pragma once

#include "nav2_util/line_iterator.hpp"

namespace dwb_critics {

using nav2_util::LineIterator;

}  // namespace dwb_critics
