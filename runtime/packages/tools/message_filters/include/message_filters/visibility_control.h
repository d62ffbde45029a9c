// All that is linked is visible.
#pragma once

#define MESSAGE_FILTERS_PUBLIC
