// A robot that turns, drives straight, and turns again.
#pragma once

#include "nav2_amcl/motion_model/motion_model.hpp"

namespace nav2_amcl {

class DifferentialMotionModel : public MotionModel {
 public:
  void initialize(double alpha1, double alpha2, double alpha3, double alpha4,
                  double alpha5) override;
  void odometryUpdate(pf_t* pf, const pf_vector_t& pose, const pf_vector_t& delta) override;

 private:
  double alpha1_ = 0.0;
  double alpha2_ = 0.0;
  double alpha3_ = 0.0;
  double alpha4_ = 0.0;
};

}  // namespace nav2_amcl
