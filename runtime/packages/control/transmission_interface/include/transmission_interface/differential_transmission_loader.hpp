// The loader of DifferentialTransmission.
#pragma once

#include <memory>

#include "transmission_interface/transmission_loader.hpp"

namespace transmission_interface {

class DifferentialTransmissionLoader : public TransmissionLoader {
 public:
  std::shared_ptr<Transmission> load(
      const hardware_interface::TransmissionInfo& transmission_info) override;
};

}  // namespace transmission_interface
