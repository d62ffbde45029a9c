// Poses in the plane, under the names that motion models use.
#pragma once

#include <cmath>

/// x [m], y [m] and yaw [rad].
struct pf_vector_t {
  double v[3];
};

struct pf_matrix_t {
  double m[3][3];
};

inline pf_vector_t pf_vector_zero() {
  return {};
}
inline pf_matrix_t pf_matrix_zero() {
  return {};
}

/// Component by component; the angle is not normalized.
inline pf_vector_t pf_vector_sub(pf_vector_t a, pf_vector_t b) {
  return {{a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]}};
}

/// The pose `a`, which is relative to `b`, in the frame that `b` is in. Yaw is within [-pi, pi].
inline pf_vector_t pf_vector_coord_add(pf_vector_t a, pf_vector_t b) {
  const double c = std::cos(b.v[2]);
  const double s = std::sin(b.v[2]);
  const double yaw = a.v[2] + b.v[2];
  return {{b.v[0] + a.v[0] * c - a.v[1] * s, b.v[1] + a.v[0] * s + a.v[1] * c,
           std::atan2(std::sin(yaw), std::cos(yaw))}};
}
