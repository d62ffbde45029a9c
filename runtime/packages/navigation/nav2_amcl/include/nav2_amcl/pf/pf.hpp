// The particles as a motion model sees them. A `pf_t` is a view that is valid during one call; the
// particles belong to nav2_amcl::ParticleFilter.
#pragma once

#include "nav2_amcl/pf/pf_vector.hpp"

struct pf_sample_t {
  pf_vector_t pose;
  double weight;  // all weights of a set sum to 1
};

struct pf_sample_set_t {
  int sample_count;
  pf_sample_t* samples;
};

struct pf_t {
  int current_set;
  pf_sample_set_t sets[2];
};
