// The base class of motion models: how particles follow odometry. Plugins derive from it.
#pragma once

#include "nav2_amcl/pf/pf.hpp"
#include "nav2_amcl/pf/pf_pdf.hpp"

namespace nav2_amcl {

class MotionModel {
 public:
  virtual ~MotionModel() = default;

  /// Noise: 1 rotation by rotation, 2 rotation by translation, 3 translation by translation,
  /// 4 translation by rotation, 5 strafe by translation.
  virtual void initialize(double alpha1, double alpha2, double alpha3, double alpha4,
                          double alpha5) = 0;
  /// Moves the particles of the current set. `pose` is where odometry sees the robot now, `delta`
  /// the change of that pose.
  virtual void odometryUpdate(pf_t* pf, const pf_vector_t& pose, const pf_vector_t& delta) = 0;
};

}  // namespace nav2_amcl
