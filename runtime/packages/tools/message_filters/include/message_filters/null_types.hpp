// The newer name of this header.
#pragma once

#include "message_filters/null_types.h"
