// Random numbers for motion models.
#pragma once

#include "nav2_amcl/pf/random.hpp"

/// A number with mean 0 and standard deviation `sigma`, from the generator of the filter that is
/// being moved. Only for use within nav2_amcl::MotionModel::odometryUpdate.
double pf_ran_gaussian(double sigma);

namespace nav2_amcl {

/// While it exists, `pf_ran_gaussian` of this thread draws from `random`.
class RandomSource {
 public:
  explicit RandomSource(Random& random);
  ~RandomSource();
  RandomSource(const RandomSource&) = delete;
  RandomSource& operator=(const RandomSource&) = delete;

 private:
  Random* before_;
};

}  // namespace nav2_amcl
