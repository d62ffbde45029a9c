// The older name of exception.hpp, and its class.
#pragma once

#include "transmission_interface/exception.hpp"

namespace transmission_interface {

using TransmissionInterfaceException = Exception;

}  // namespace transmission_interface
