// A hardware component of this kind.
#pragma once

#include "hardware_interface/hardware_component.hpp"

namespace hardware_interface {

using Actuator = HardwareComponent;

}  // namespace hardware_interface
