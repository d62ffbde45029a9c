// The common part of transmissions between two actuators and two joints.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "transmission_interface/exception.hpp"
#include "transmission_interface/transmission.hpp"

namespace transmission_interface {
namespace detail {

class TwoJointTransmission : public Transmission {
 public:
  void configure(const std::vector<JointHandle>& joint_handles,
                 const std::vector<ActuatorHandle>& actuator_handles) override;
  void actuator_to_joint() override;
  void joint_to_actuator() override;
  std::size_t num_actuators() const override { return 2; }
  std::size_t num_joints() const override { return 2; }
  const std::vector<double>& get_actuator_reduction() const { return actuator_reduction_; }
  const std::vector<double>& get_joint_reduction() const { return joint_reduction_; }
  const std::vector<double>& get_joint_offset() const { return joint_offset_; }
  std::string get_handles_info() const;

 protected:
  using Two = std::array<double, 2>;

  /// Throws Exception for vectors of another size than 2, and reductions of zero.
  TwoJointTransmission(const std::vector<double>& actuator_reduction,
                       const std::vector<double>& joint_reduction,
                       const std::vector<double>& joint_offset);
  /// Motions are positions without offsets, and velocities; efforts are torques and forces too.
  virtual Two joint_motion(const Two& actuator) const = 0;
  virtual Two actuator_motion(const Two& joint) const = 0;
  virtual Two joint_effort(const Two& actuator) const = 0;
  virtual Two actuator_effort(const Two& joint) const = 0;

  std::vector<double> actuator_reduction_;
  std::vector<double> joint_reduction_;
  std::vector<double> joint_offset_;

 private:
  struct Row {
    std::string interface;
    std::vector<JointHandle> joints;
    std::vector<ActuatorHandle> actuators;
  };
  std::vector<Row> rows_;  ///< of all interfaces that are supported
};

}  // namespace detail
}  // namespace transmission_interface
