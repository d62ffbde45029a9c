// The name of this header in version 3.
#pragma once

#include "behaviortree_cpp/loggers/abstract_logger.h"
