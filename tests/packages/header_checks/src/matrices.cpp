// Compatibility, works: Armadillo (`armadillo`, `find_package(Armadillo)`): arithmetic, statistics,
// determinants up to four rows, inverses of two rows, and of up to four with `arma::inv_opts::tiny`

// Compatibility, differs: Armadillo's solvers, decompositions and larger inverses -> throw
// std::logic_error that names LAPACK, which a site lacks; Eigen has its own

#include <armadillo>

#include "expect.hpp"

void check_matrices(Expectations& expectations) {
  const arma::mat rotation = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  const arma::vec axis = {1, 2, 3};
  const arma::vec turned = rotation * axis;
  EXPECT(turned(0) == -2 && turned(1) == 1 && turned(2) == 3);
  EXPECT(arma::approx_equal(arma::inv(rotation, arma::inv_opts::tiny), rotation.t(), "absdiff",
                            1e-12));
  EXPECT(near(arma::det(rotation), 1.0) && near(arma::norm(axis), std::sqrt(14.0)));
  EXPECT(near(arma::mean(axis), 2.0) && near(arma::var(axis), 1.0));
  arma::mat large(6, 6, arma::fill::eye);
  EXPECT(near(arma::accu(large % large), 6.0));
  EXPECT_THROWS(std::logic_error, arma::vec(arma::solve(large, arma::vec(6, arma::fill::ones))));
}
