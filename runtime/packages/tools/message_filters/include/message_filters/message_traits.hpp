// The newer name of this header.
#pragma once

#include "message_filters/message_traits.h"
