// See mujoco_friction.hpp.
#include "physics/mujoco_friction.hpp"

#include <algorithm>
#include <string>

namespace ros2wasm_sim {
namespace {

/// The engine divides by frictions.
constexpr double kLeastFriction = 1e-4;

const FrictionDirection* direction_of(int geom, const std::vector<FrictionDirection>& directions) {
  const auto found = std::find_if(directions.begin(), directions.end(),
                                  [&](const FrictionDirection& one) { return one.geom == geom; });
  return found == directions.end() ? nullptr : &*found;
}

/// The first tangent of the contact becomes the direction, as far as it is in the plane of contact.
void turn_contact(const mjModel* model, const mjData* data, const FrictionDirection& one, int other,
                  mjContact& contact) {
  if (contact.dim < 3) return;
  const mjtNum along[3] = {one.direction.x, one.direction.y, one.direction.z};
  mjtNum wanted[3], tangent[3];
  mju_rotVecQuat(wanted, along, data->xquat + 4 * one.frame);
  mju_addScl3(tangent, wanted, contact.frame, -mju_dot3(wanted, contact.frame));
  if (mju_normalize3(tangent) < 1e-6) return;
  mju_copy3(contact.frame + 3, tangent);
  mju_cross(contact.frame + 6, contact.frame, contact.frame + 3);
  const double most = model->geom_friction[3 * other];
  contact.friction[0] = std::max(std::min(one.mu, most), kLeastFriction);
  contact.friction[1] = std::max(std::min(one.mu2, most), kLeastFriction);
}

}  // namespace

std::vector<FrictionDirection> friction_directions(const mjModel& model, const MjcfNames& names) {
  std::vector<FrictionDirection> directions;
  for (const DirectedShape& shape : names.directed) {
    const std::string& owner = names.link_names[shape.body].first;
    const auto frame = names.links.find({owner, shape.frame});
    const int body = frame == names.links.end() ? shape.body : frame->second;
    FrictionDirection one;
    one.geom = mj_name2id(&model, mjOBJ_GEOM, shape.geom.c_str());
    one.frame = mj_name2id(&model, mjOBJ_BODY, ("b" + std::to_string(body)).c_str());
    one.mu = shape.mu;
    one.mu2 = shape.mu2;
    one.direction = shape.direction;
    if (one.geom >= 0 && one.frame >= 0) directions.push_back(one);
  }
  return directions;
}

void begin_step(const mjModel* model, mjData* data,
                const std::vector<FrictionDirection>& directions) {
  if (directions.empty()) {
    mj_step1(model, data);
    return;
  }
  mj_checkPos(model, data);
  mj_checkVel(model, data);
  mj_kinematics(model, data);
  mj_comPos(model, data);
  mj_camlight(model, data);
  mj_tendon(model, data);
  mj_crb(model, data);
  mj_factorM(model, data);
  mj_collision(model, data);
  for (int i = 0; i < data->ncon; ++i) {
    mjContact& contact = data->contact[i];
    if (const auto* one = direction_of(contact.geom1, directions))
      turn_contact(model, data, *one, contact.geom2, contact);
    else if (const auto* two = direction_of(contact.geom2, directions))
      turn_contact(model, data, *two, contact.geom1, contact);
  }
  mj_makeConstraint(model, data);
  mj_transmission(model, data);
  mj_projectConstraint(model, data);
  mj_sensorPos(model, data);
  mj_fwdVelocity(model, data);
  mj_sensorVel(model, data);
}

}  // namespace ros2wasm_sim
