// Two actuators that turn two joints together, as in a wrist.
#pragma once

#include <string>
#include <vector>

#include "transmission_interface/two_joint_transmission.hpp"

namespace transmission_interface {

class DifferentialTransmission : public detail::TwoJointTransmission {
 public:
  DifferentialTransmission(const std::vector<double>& actuator_reduction,
                           const std::vector<double>& joint_reduction,
                           const std::vector<double>& joint_offset = {0.0, 0.0})
      : TwoJointTransmission(actuator_reduction, joint_reduction, joint_offset) {}

  std::vector<std::string> get_supported_joint_interfaces() const override;

 protected:
  Two joint_motion(const Two& actuator) const override;
  Two actuator_motion(const Two& joint) const override;
  Two joint_effort(const Two& actuator) const override;
  Two actuator_effort(const Two& joint) const override;
};

}  // namespace transmission_interface
