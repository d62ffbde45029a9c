// The part of parse.hpp that knows YAML.
#pragma once

#include "camera_calibration_parsers/parse.hpp"
