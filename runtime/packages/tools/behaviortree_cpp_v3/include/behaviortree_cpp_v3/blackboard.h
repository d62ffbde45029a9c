// The name of this header in version 3.
#pragma once

#include "behaviortree_cpp/blackboard.h"
