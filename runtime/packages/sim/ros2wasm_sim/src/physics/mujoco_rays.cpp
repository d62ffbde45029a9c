// See mujoco_rays.hpp.
#include "physics/mujoco_rays.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "physics/mjcf.hpp"

namespace ros2wasm_sim {
namespace {

/// A group that no ray looks for.
constexpr int kHiddenGroup = 5;
/// A ray that begins on the surface comes from inside (m).
constexpr double kOnSurface = 1e-6;

/// For the shapes that files describe by formulas; a mesh has no inside here.
bool is_inside(const mjModel& model, const mjData& data, int geom, const Ray& ray) {
  const mjtNum offset[3] = {ray.origin.x - data.geom_xpos[3 * geom],
                            ray.origin.y - data.geom_xpos[3 * geom + 1],
                            ray.origin.z - data.geom_xpos[3 * geom + 2]};
  mjtNum at[3];
  mju_rotVecMatT(at, offset, data.geom_xmat + 9 * geom);
  const mjtNum* size = model.geom_size + 3 * geom;
  const double across = std::hypot(at[0], at[1]);
  const double up = std::fabs(at[2]);
  switch (model.geom_type[geom]) {
    case mjGEOM_BOX:
      return std::fabs(at[0]) <= size[0] + kOnSurface && std::fabs(at[1]) <= size[1] + kOnSurface &&
             up <= size[2] + kOnSurface;
    case mjGEOM_SPHERE:
      return std::hypot(across, up) <= size[0] + kOnSurface;
    case mjGEOM_CYLINDER:
      return across <= size[0] + kOnSurface && up <= size[1] + kOnSurface;
    case mjGEOM_CAPSULE:
      return std::hypot(across, std::fmax(0, up - size[1])) <= size[0] + kOnSurface;
    case mjGEOM_ELLIPSOID:
      return std::hypot(at[0] / size[0], at[1] / size[1], at[2] / size[2]) <= 1 + kOnSurface;
    default:
      return false;
  }
}

}  // namespace

double distance_along(mjModel& model, const mjData& data, const Ray& ray, RaySees sees,
                      int without_body) {
  const int group = sees == RaySees::kCollisions ? kCollisionGroup : kVisualGroup;
  std::array<mjtByte, mjNGROUP> groups{};
  groups[group] = 1;
  const mjtNum from[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const mjtNum along[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
  std::vector<int> hidden;
  double distance = kInfinity;
  while (true) {
    int geom = -1;
    const mjtNum far = mj_ray(&model, &data, from, along, groups.data(), 1, without_body, &geom);
    if (far < 0) break;
    if (sees == RaySees::kVisuals && is_inside(model, data, geom, ray)) {
      model.geom_group[geom] = kHiddenGroup;
      hidden.push_back(geom);
      continue;
    }
    distance = far;
    break;
  }
  for (const int geom : hidden) model.geom_group[geom] = group;
  return distance;
}

}  // namespace ros2wasm_sim
