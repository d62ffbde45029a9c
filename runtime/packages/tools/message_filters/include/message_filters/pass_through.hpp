// The newer name of this header.
#pragma once

#include "message_filters/pass_through.h"
