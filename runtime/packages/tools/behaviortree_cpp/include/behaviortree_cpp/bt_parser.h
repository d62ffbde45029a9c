// Trees are read by the factory; this name is where user code expects that.
#pragma once

#include "behaviortree_cpp/bt_factory.h"
