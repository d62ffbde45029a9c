// The newer name of this header.
#pragma once

#include "urdf/model.h"
