// See recovery.h.
#include "recovery.h"

#include "user/user_objects.h"

extern "C" void ros2wasm_mujoco_hull_error(int number) {
  throw mjCError(nullptr, "the convex hull of a mesh cannot be made (qhull error %d)", nullptr,
                 number);
}
