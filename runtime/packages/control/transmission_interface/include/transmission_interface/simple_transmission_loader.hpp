// The loader of SimpleTransmission.
#pragma once

#include <memory>

#include "transmission_interface/transmission_loader.hpp"

namespace transmission_interface {

class SimpleTransmissionLoader : public TransmissionLoader {
 public:
  std::shared_ptr<Transmission> load(
      const hardware_interface::TransmissionInfo& transmission_info) override;
};

}  // namespace transmission_interface
