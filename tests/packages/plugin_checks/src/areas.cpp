// The part of the base class that is no header.
#include "plugin_checks/shape.hpp"

namespace plugin_checks {

int& Shape::ended() {
  static int count = 0;
  return count;
}

}  // namespace plugin_checks
