// Names of the models that a CameraInfo's distortion coefficients belong to.
#pragma once

#include <string>

namespace sensor_msgs {
namespace distortion_models {

const std::string PLUMB_BOB = "plumb_bob";
const std::string RATIONAL_POLYNOMIAL = "rational_polynomial";
const std::string EQUIDISTANT = "equidistant";

}  // namespace distortion_models
}  // namespace sensor_msgs
