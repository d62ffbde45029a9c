// The newer name of this header.
#pragma once

#include "message_filters/time_sequencer.h"
