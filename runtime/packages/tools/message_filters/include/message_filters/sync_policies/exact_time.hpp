// The newer name of this header.
#pragma once

#include "message_filters/sync_policies/exact_time.h"
