// The newer name of this header.
#pragma once

#include "message_filters/parameter_adapter.h"
