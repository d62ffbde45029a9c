// One actuator, one joint, a reduction and an offset: joint = actuator / reduction + offset, and
// efforts times the reduction.
#pragma once

#include <string>
#include <vector>

#include "transmission_interface/exception.hpp"
#include "transmission_interface/transmission.hpp"

namespace transmission_interface {

class SimpleTransmission : public Transmission {
 public:
  /// Throws Exception for a reduction of zero.
  explicit SimpleTransmission(const double joint_to_actuator_reduction,
                              const double joint_offset = 0.0);

  void configure(const std::vector<JointHandle>& joint_handles,
                 const std::vector<ActuatorHandle>& actuator_handles) override;
  void actuator_to_joint() override;
  /// Absolute positions are states only.
  void joint_to_actuator() override;
  std::size_t num_actuators() const override { return 1; }
  std::size_t num_joints() const override { return 1; }
  double get_actuator_reduction() const { return reduction_; }
  double get_joint_offset() const { return jnt_offset_; }
  std::vector<std::string> get_supported_joint_interfaces() const override;

 protected:
  double reduction_;
  double jnt_offset_;

 private:
  struct Pair {
    std::string interface;
    JointHandle joint;
    ActuatorHandle actuator;
  };
  std::vector<Pair> pairs_;  ///< of the interfaces that both sides have
};

}  // namespace transmission_interface
