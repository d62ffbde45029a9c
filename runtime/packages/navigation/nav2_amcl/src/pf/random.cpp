// See random.hpp and pf_pdf.hpp.
#include "nav2_amcl/pf/random.hpp"

#include <cmath>
#include <stdexcept>

#include "nav2_amcl/pf/pf_pdf.hpp"

namespace nav2_amcl {
namespace {

thread_local Random* current_random = nullptr;

}  // namespace

double Random::gaussian() {
  if (has_second_) {
    has_second_ = false;
    return second_;
  }
  double x;
  double y;
  double square;
  do {
    x = 2 * uniform() - 1;
    y = 2 * uniform() - 1;
    square = x * x + y * y;
  } while (square >= 1 || square == 0);
  const double scale = std::sqrt(-2 * std::log(square) / square);
  second_ = y * scale;
  has_second_ = true;
  return x * scale;
}

RandomSource::RandomSource(Random& random) : before_(current_random) {
  current_random = &random;
}

RandomSource::~RandomSource() {
  current_random = before_;
}

}  // namespace nav2_amcl

double pf_ran_gaussian(double sigma) {
  if (nav2_amcl::current_random == nullptr) {
    throw std::logic_error("pf_ran_gaussian was called outside MotionModel::odometryUpdate");
  }
  return sigma * nav2_amcl::current_random->gaussian();
}
