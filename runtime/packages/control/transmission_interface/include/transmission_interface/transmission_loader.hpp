// Makes transmissions from their descriptions: the base of plugins.
#pragma once

#include <memory>

#include "hardware_interface/hardware_info.hpp"
#include "transmission_interface/transmission.hpp"

namespace transmission_interface {

class TransmissionLoader {
 public:
  virtual ~TransmissionLoader() = default;
  /// Null, after a logged error, for a description that does not fit.
  virtual std::shared_ptr<Transmission> load(
      const hardware_interface::TransmissionInfo& transmission_info) = 0;
};

}  // namespace transmission_interface
