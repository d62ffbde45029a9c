// The older name of env.hpp.
#pragma once

#include "rcpputils/env.hpp"
