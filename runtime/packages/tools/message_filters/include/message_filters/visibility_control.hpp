// The newer name of this header.
#pragma once

#include "message_filters/visibility_control.h"
