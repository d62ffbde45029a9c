// A part of the plugins that is a library of its own.
#include <cmath>

namespace plugin_shapes {

double root_of_three() {
  return std::sqrt(3.0);
}

}  // namespace plugin_shapes
