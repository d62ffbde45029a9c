// See mujoco_forces.hpp.
#include "physics/mujoco_forces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace ros2wasm_sim {
namespace {

Vector3 vector(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

/// The columns of a rotation matrix of the engine are the axes of the frame.
Vector3 into_frame(const mjtNum* matrix, const Vector3& v) {
  return {matrix[0] * v.x + matrix[3] * v.y + matrix[6] * v.z,
          matrix[1] * v.x + matrix[4] * v.y + matrix[7] * v.z,
          matrix[2] * v.x + matrix[5] * v.y + matrix[8] * v.z};
}

/// The rows of a contact's frame are its axes: the first is the normal.
Vector3 out_of_contact(const mjtNum* frame, const mjtNum* v) {
  return v[0] * vector(frame) + v[1] * vector(frame + 3) + v[2] * vector(frame + 6);
}

/// Half the size of a box around a geom, along the geom's axes.
Vector3 half_size(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return {size[0], size[0], size[0]};
    case mjGEOM_CAPSULE:
      return {size[0], size[0], size[1] + size[0]};
    case mjGEOM_CYLINDER:
      return {size[0], size[0], size[1]};
    case mjGEOM_BOX:
    case mjGEOM_ELLIPSOID:
      return vector(size);
    default: {
      const mjtNum radius = model.geom_rbound[geom];
      return {radius, radius, radius};
    }
  }
}

/// The engine finds the contacts of a plane on a body that cannot move twice, each with half of the
/// force.
void add_point(const ContactPoint& point, std::vector<ContactPoint>& points) {
  for (ContactPoint& one : points)
    if (one.position == point.position && one.normal == point.normal) {
      one.wrench.force = one.wrench.force + point.wrench.force;
      one.wrench.torque = one.wrench.torque + point.wrench.torque;
      return;
    }
  points.push_back(point);
}

/// At most the distance to the geom.
double distance_to(const mjModel& model, const mjData& data, int geom, const Vector3& point) {
  const Vector3 at =
      into_frame(data.geom_xmat + 9 * geom, point - vector(data.geom_xpos + 3 * geom));
  if (model.geom_type[geom] == mjGEOM_PLANE) return std::abs(at.z);
  const Vector3 half = half_size(model, geom);
  const auto outside = [](double where, double most) {
    return std::max(std::abs(where) - most, 0.0);
  };
  return length({outside(at.x, half.x), outside(at.y, half.y), outside(at.z, half.z)});
}

}  // namespace

std::vector<int> collisions_of_geoms(const mjModel& model) {
  std::vector<int> result(model.ngeom, -1);
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const char* name = mj_id2name(&model, mjOBJ_GEOM, geom);
    if (name != nullptr && name[0] == 'c') result[geom] = std::atoi(name + 1);
  }
  return result;
}

void read_touches(const mjModel& model, const mjData& data, const std::vector<int>& collisions,
                  std::vector<Touch>& touches) {
  touches.clear();
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    // Without an address the solver does not use it.
    if (contact.efc_address < 0) continue;
    mjtNum carried[6];
    mj_contactForce(&model, &data, i, carried);
    Touch touch;
    touch.first = collisions[contact.geom1];
    touch.second = collisions[contact.geom2];
    touch.point.position = vector(contact.pos);
    touch.point.depth = -contact.dist;
    // The engine's normal points from the first geom to the second, on which its force acts.
    touch.point.normal = -1.0 * vector(contact.frame);
    touch.point.wrench = {-1.0 * out_of_contact(contact.frame, carried),
                          -1.0 * out_of_contact(contact.frame, carried + 3)};
    touches.push_back(touch);
  }
}

std::vector<Contact> contacts_between(const std::vector<Touch>& touches,
                                      const std::vector<std::string>& names) {
  std::vector<Contact> result;
  std::map<std::pair<int, int>, std::size_t> pairs;
  for (const Touch& touch : touches) {
    const auto [known, is_new] = pairs.try_emplace({touch.first, touch.second}, result.size());
    if (is_new) result.push_back({names[touch.first], names[touch.second], {}});
    add_point(touch.point, result[known->second].points);
  }
  return result;
}

Wrench wrench_of_parent(const mjModel& model, const mjData& data, int body) {
  const mjtNum* carried = data.cfrc_int + 6 * body;
  const Vector3 force = vector(carried + 3);
  // The engine's torques are about the centre of mass of the whole tree.
  const Vector3 centre = vector(data.subtree_com + 3 * model.body_rootid[body]);
  const Vector3 arm = centre - vector(data.xpos + 3 * body);
  const Vector3 torque = vector(carried) + cross(arm, force);
  const mjtNum* axes = data.xmat + 9 * body;
  return {into_frame(axes, force), into_frame(axes, torque)};
}

bool is_geom_near(const mjModel& model, const mjData& data, const Vector3& point, double distance,
                  int group, int without_body) {
  for (int geom = 0; geom < model.ngeom; ++geom)
    if (model.geom_group[geom] == group && model.geom_bodyid[geom] != without_body &&
        distance_to(model, data, geom, point) <= distance)
      return true;
  return false;
}

}  // namespace ros2wasm_sim
