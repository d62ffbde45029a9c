// The newer name of this header.
#pragma once

#include "message_filters/simple_filter.h"
