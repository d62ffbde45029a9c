// The physics by MuJoCo. Only the files named after it know its types.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "physics/mjcf.hpp"
#include "physics/mujoco_forces.hpp"
#include "physics/mujoco_friction.hpp"
#include "physics/mujoco_model.hpp"
#include "physics/mujoco_rays.hpp"
#include "physics/mujoco_state.hpp"
#include "physics/mujoco_values.hpp"
#include "physics/mujoco_welds.hpp"
#include "physics/physics.hpp"

namespace ros2wasm_sim {
namespace {

/// MuJoCo's own errors, which natively end the process.
void throw_engine_error(const char* message) {
  throw PhysicsError(message);
}
void ignore_warning(const char*) {}

constexpr int kMostContacts = 1000;
/// How fast what overlaps is pushed apart (m/s). A robot that is put half into the ground rises out
/// of it, where the engine's spring alone would throw it into the sky.
constexpr double kSeparationSpeed = 0.3;
constexpr int kMostStack = 40'000'000;  // 320 MB

class MujocoPhysics final : public Physics {
 public:
  explicit MujocoPhysics(MeshReader meshes) : meshes_(std::move(meshes)) {
    mju_user_error = throw_engine_error;
    mju_user_warning = ignore_warning;
  }

  void set_world(const World& world) override {
    check_size(world);
    MjcfLimits limits = limits_;
    while (true) {
      try {
        build(world, limits);
        break;
      } catch (const PhysicsError& error) {
        // Large worlds need more work memory already to be compiled.
        const bool overflows = std::string(error.what()).find("tack overflow") != std::string::npos;
        if (!overflows || limits.stack >= kMostStack) throw;
        limits.stack = std::min(4 * limits.stack, kMostStack);
      }
    }
    world_ = world;
  }

  std::vector<std::string> take_warnings() override { return std::exchange(warnings_, {}); }

  double step_size() const override { return model_ ? model_->opt.timestep : 0.001; }

  void step() override {
    try {
      step_once();
    } catch (const PhysicsError&) {
      if (!grow()) throw;
      step_once();
    }
    if (data_->warning[mjWARN_BADQPOS].number + data_->warning[mjWARN_BADQVEL].number +
            data_->warning[mjWARN_BADQACC].number >
        0)
      report_explosion();
    if (data_->warning[mjWARN_CONTACTFULL].number + data_->warning[mjWARN_CNSTRFULL].number > 0)
      grow();
  }

  void reset() override {
    mj_resetData(model_.get(), data_.get());
    for (const auto& [name, roots] : names_.roots)
      for (const int number : roots) {
        const Model* model = model_named(name);
        place_root(number, model->pose * link_pose(*model, names_.link_names[number].second), true);
      }
    for (JointRow& row : joints_) {
      row.motor = {};
      row.effort = 0;
    }
    forget_forces();
    apply_motors();
    refresh();
  }

  LinkHandle link(const std::string& model, const std::string& link) override {
    const auto known = names_.links.find({model, link});
    if (known == names_.links.end()) return {};
    for (std::size_t i = 0; i < links_.size(); ++i)
      if (links_[i].body == bodies_[known->second]) return {static_cast<int>(i)};
    links_.push_back({model, link, bodies_[known->second]});
    return {static_cast<int>(links_.size()) - 1};
  }

  JointHandle joint(const std::string& model, const std::string& joint) override {
    for (std::size_t i = 0; i < joints_.size(); ++i)
      if (joints_[i].id >= 0 && joints_[i].name == joint && joints_[i].model == model)
        return {static_cast<int>(i)};
    return {};
  }

  Pose pose(LinkHandle link) const override {
    const int body = body_of(link);
    if (body < 0) return {};
    return {vector(data_->xpos + 3 * body), quaternion(data_->xquat + 4 * body)};
  }

  Motion velocity(LinkHandle link) const override {
    const int body = body_of(link);
    if (body < 0) return {};
    std::array<mjtNum, 6> both{};
    mj_objectVelocity(model_.get(), data_.get(), mjOBJ_XBODY, body, both.data(), 0);
    return {vector(both.data() + 3), vector(both.data())};
  }

  Motion proper_acceleration(LinkHandle link) override {
    const int body = body_of(link);
    if (body < 0) return {};
    mj_rnePostConstraint(model_.get(), data_.get());
    std::array<mjtNum, 6> both{};
    mj_objectAcceleration(model_.get(), data_.get(), mjOBJ_XBODY, body, both.data(), 0);
    return {vector(both.data() + 3), vector(both.data())};
  }

  double position(JointHandle joint) const override {
    const JointRow* row = row_of(joint);
    return row == nullptr || row->dof < 0 ? 0 : data_->qpos[row->position];
  }
  double velocity(JointHandle joint) const override {
    const JointRow* row = row_of(joint);
    return row == nullptr || row->dof < 0 ? 0 : data_->qvel[row->dof];
  }
  double effort(JointHandle joint) const override {
    const JointRow* row = row_of(joint);
    return row == nullptr ? 0 : row->effort;
  }

  void set_motor(JointHandle joint, double velocity, double max_effort) override {
    JointRow* row = row_of(joint);
    if (row != nullptr && std::isfinite(velocity)) {
      is_moved_ |= !row->motor.on;  // what limits the joint is another constraint now
      row->motor = {true, velocity, max_effort};
      apply_motor(*row);
    }
  }
  void release_motor(JointHandle joint) override {
    if (JointRow* row = row_of(joint)) {
      is_moved_ |= row->motor.on;
      row->motor = {};
      apply_motor(*row);
    }
  }
  void set_position(JointHandle joint, double position) override {
    JointRow* row = row_of(joint);
    if (row == nullptr || row->dof < 0 || !std::isfinite(position)) return;
    data_->qpos[row->position] = position;
    data_->qvel[row->dof] = 0;
    mj_kinematics(model_.get(), data_.get());
    is_moved_ = true;
  }
  void set_velocity(JointHandle joint, double velocity) override {
    JointRow* row = row_of(joint);
    if (row == nullptr || row->dof < 0 || !std::isfinite(velocity)) return;
    data_->qvel[row->dof] = velocity;
    mj_fwdVelocity(model_.get(), data_.get());
  }
  void add_effort(JointHandle joint, double effort) override {
    JointRow* row = row_of(joint);
    if (row == nullptr || row->dof < 0 || !std::isfinite(effort)) return;
    mjtNum& applied = data_->qfrc_applied[row->dof];
    applied = std::clamp(applied + effort, -row->effort_limit, row->effort_limit);
  }
  double effort_limit(JointHandle joint) const override {
    const JointRow* row = row_of(joint);
    return row == nullptr ? kInfinity : row->effort_limit;
  }

  void add_wrench(LinkHandle link, const Vector3& force, const Vector3& torque,
                  const Vector3& point) override {
    const int body = body_of(link);
    if (body < 0) return;
    const Vector3 turning = torque + cross(point - centre_of_mass(link), force);
    if (!std::isfinite(dot(force, force) + dot(turning, turning))) return;
    mjtNum* applied = data_->xfrc_applied + 6 * body;
    put(vector(applied) + force, applied);
    put(vector(applied + 3) + turning, applied + 3);
  }
  Vector3 centre_of_mass(LinkHandle link) const override {
    const int body = body_of(link);
    return body < 0 ? Vector3{} : vector(data_->xipos + 3 * body);
  }

  bool attach(LinkHandle parent, LinkHandle child) override {
    if (body_of(parent) < 0 || body_of(child) < 0) return false;
    detach(parent, child);
    if (welds_.size() >= static_cast<std::size_t>(kSpareWelds)) return false;
    welds_.push_back({parent, child, inverse(pose(parent)) * pose(child)});
    apply_welds();
    return true;
  }
  void detach(LinkHandle parent, LinkHandle child) override {
    welds_.erase(std::remove_if(welds_.begin(), welds_.end(),
                                [&](const Weld& one) {
                                  return one.parent.index == parent.index &&
                                         one.child.index == child.index;
                                }),
                 welds_.end());
    apply_welds();
  }

  bool set_model_pose(const std::string& model, const Pose& pose, bool at_rest) override {
    const auto roots = names_.roots.find(model);
    if (roots == names_.roots.end() || roots->second.empty()) return false;
    const Model* described = model_named(model);
    for (const int number : roots->second) {
      const std::string& link = names_.link_names[number].second;
      const Pose offset = link_pose(*described, link);
      place_root(number, pose * offset, at_rest);
    }
    if (at_rest) rest_joints(model);
    refresh();
    return true;
  }

  bool set_model_velocity(const std::string& model, const Motion& velocity) override {
    const auto roots = names_.roots.find(model);
    if (roots == names_.roots.end()) return false;
    for (const int number : roots->second) {
      const int joint = free_joint_of(*model_, number);
      if (joint < 0) continue;
      mjtNum* speeds = data_->qvel + model_->jnt_dofadr[joint];
      const Quaternion turned = quaternion(data_->qpos + model_->jnt_qposadr[joint] + 3);
      put(velocity.linear, speeds);
      put(rotate(inverse(turned), velocity.angular),
          speeds + 3);  // of free joints: in the body's axes
    }
    mj_fwdVelocity(model_.get(), data_.get());
    return true;
  }

  void cast(const std::vector<Ray>& rays, RaySees sees, LinkHandle exclude,
            std::vector<double>& distances) override {
    distances.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
      distances[i] = distance_along(*model_, *data_, rays[i], sees, body_of(exclude));
  }

  bool is_near(const Vector3& point, double distance, RaySees sees,
               LinkHandle exclude) const override {
    const int group = sees == RaySees::kCollisions ? kCollisionGroup : kVisualGroup;
    return is_geom_near(*model_, *data_, point, distance, group, body_of(exclude));
  }

  void watch_contacts() override { watches_contacts_ = true; }
  void watch_wrench(LinkHandle child) override {
    if (child.valid()) links_[child.index].is_watched = true;
  }
  std::vector<Contact> contacts() const override {
    return contacts_between(touches_, names_.collisions);
  }
  Wrench wrench(LinkHandle child) const override {
    return child.valid() ? links_[child.index].wrench : Wrench{};
  }

  std::uint64_t state_hash() const override { return hash_of_state(*model_, *data_); }

 private:
  void build(const World& world, const MjcfLimits& limits) {
    auto [written, model] = compile_world(world, limits);
    DataPointer data(mj_makeData(model.get()));
    if (!data) throw PhysicsError("there is not enough memory for the world");
    const WorldState state =
        model_ ? state_of(*model_, *data_, names_, bodies_, joints_) : WorldState{};
    for (std::string& warning : written.warnings)
      if (said_.insert(warning).second) warnings_.push_back(std::move(warning));
    model_ = std::move(model);
    data_ = std::move(data);
    names_ = std::move(written.names);
    limits_ = limits;
    forget_forces();
    refresh_handles();
    for (const Model& one : world.models)
      for (const Joint& joint : one.joints)
        if (!joint.axes.empty()) set_effort_limit(one.name, joint);
    directions_ = friction_directions(*model_, names_);
    restore(state, *model_, *data_, names_, bodies_, joints_);
    apply_motors();
    apply_welds();
    refresh();
  }

  /// A limit that is negative is none.
  void set_effort_limit(const std::string& model, const Joint& joint) {
    const auto row = joint_rows_.find({model, joint.name});
    const double limit = joint.axes.front().effort;
    if (row != joint_rows_.end())
      joints_[row->second].effort_limit = limit >= 0 ? limit : kInfinity;
  }

  /// All that follows from positions and velocities, accelerations too.
  void refresh() {
    is_moved_ = false;
    begin_step(model_.get(), data_.get(), directions_);
    mj_forwardSkip(model_.get(), data_.get(), mjSTAGE_VEL, 1);
  }

  /// The spare welds hold what is attached, as far as it is there.
  void apply_welds() {
    for (int i = 0; i < model_->neq; ++i)
      if (model_->eq_type[i] == mjEQ_WELD) model_->eq_active[i] = 0;
    std::size_t next = 0;
    for (int i = 0; i < model_->neq && next < welds_.size(); ++i) {
      if (model_->eq_type[i] != mjEQ_WELD) continue;
      const Weld& weld = welds_[next++];
      const int parent = body_of(weld.parent), child = body_of(weld.child);
      if (parent >= 0 && child >= 0) hold(*model_, i, parent, child, weld.offset);
    }
    is_moved_ = true;
  }

  /// Without the meshes that the engine refuses, such as flat ones.
  std::pair<Mjcf, ModelPointer> compile_world(const World& world, const MjcfLimits& limits) {
    const MeshReader meshes = [this](const Mesh& mesh) {
      return refused_meshes_.count(mesh.path) != 0 || !meshes_ ? nullptr : meshes_(mesh);
    };
    while (true) {
      Mjcf written = write_mjcf(world, meshes, limits);
      try {
        ModelPointer model = compile_model(written.xml);
        set_heights(*model, written.names);
        return {std::move(written), std::move(model)};
      } catch (const PhysicsError& error) {
        if (!refuse_mesh(error.what(), written.names)) throw;
      }
    }
  }

  /// The engine counts rows from the south.
  static void set_heights(mjModel& model, const MjcfNames& names) {
    for (std::size_t i = 0; i < names.heights.size(); ++i) {
      const int id = mj_name2id(&model, mjOBJ_HFIELD, ("heights" + std::to_string(i)).c_str());
      if (id < 0) continue;
      const TriangleMesh& grid = *names.heights[i];
      auto* heights = model.hfield_data + model.hfield_adr[id];
      for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
          const std::size_t from = static_cast<std::size_t>(row) * grid.columns + column;
          const std::size_t to =
              static_cast<std::size_t>(grid.rows - 1 - row) * grid.columns + column;
          heights[to] = grid.vertices[3 * from + 2];
        }
    }
  }

  /// The engine names the mesh that it refuses at the end of its message.
  bool refuse_mesh(const std::string& message, const MjcfNames& names) {
    for (const auto& [name, path] : names.meshes) {
      const std::size_t at = message.find(name);
      const std::size_t end = at + name.size();
      if (at == std::string::npos ||
          (end < message.size() && std::isdigit(static_cast<unsigned char>(message[end]))))
        continue;
      if (!refused_meshes_.insert(path).second) return false;
      std::string reason = message.substr(0, message.find('\n'));
      warnings_.push_back("mesh `" + path + "` is skipped: " + reason);
      return true;
    }
    return false;
  }

  /// Tables from our numbers to MuJoCo's.
  void refresh_handles() {
    bodies_.assign(names_.link_names.size(), -1);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      bodies_[i] = mj_name2id(model_.get(), mjOBJ_BODY, ("b" + std::to_string(i)).c_str());
    for (LinkRow& row : links_) {
      const auto known = names_.links.find({row.model, row.name});
      row.body = known == names_.links.end() ? -1 : bodies_[known->second];
    }
    for (JointRow& row : joints_) row.id = row.dof = row.position = -1;
    for (const auto& [name, number] : names_.joints) {
      JointRow& row = joint_row(name.first, name.second);
      row.id = mj_name2id(model_.get(), mjOBJ_JOINT, ("j" + std::to_string(number)).c_str());
      const bool single =
          model_->jnt_type[row.id] == mjJNT_HINGE || model_->jnt_type[row.id] == mjJNT_SLIDE;
      row.dof = single ? model_->jnt_dofadr[row.id] : -1;
      row.position = model_->jnt_qposadr[row.id];
      row.base_friction = single ? model_->dof_frictionloss[row.dof] : 0;
    }
    // A model that comes back with the same name begins without commands.
    for (JointRow& row : joints_)
      if (row.id < 0) row.motor = {};
    collision_of_geom_ = collisions_of_geoms(*model_);
    weightless_.clear();
    for (const int number : names_.weightless) weightless_.push_back(bodies_[number]);
  }

  JointRow& joint_row(const std::string& model, const std::string& name) {
    const auto [known, is_new] = joint_rows_.try_emplace({model, name}, joints_.size());
    if (is_new) joints_.push_back({model, name});
    return joints_[known->second];
  }

  void apply_motors() {
    for (JointRow& row : joints_) apply_motor(row);
  }

  /// A motor is a dry friction that is at rest at the wanted velocity: see drive_motors().
  void apply_motor(const JointRow& row) {
    if (row.dof < 0) return;
    model_->dof_frictionloss[row.dof] =
        row.motor.on ? std::max(row.motor.max_effort, 1e-9) : row.base_friction;
  }

  /// The first half of MuJoCo's step comes last, so that poses, velocities and contacts are those
  /// of the new state; refresh() has done it before the first step.
  void step_once() {
    if (std::exchange(is_moved_, false)) begin_step(model_.get(), data_.get(), directions_);
    drive_motors();
    separate_slowly();
    for (const int body : weightless_) {
      mjtNum* applied = data_->xfrc_applied + 6 * body;
      for (int i = 0; i < 3; ++i) applied[i] -= model_->body_mass[body] * model_->opt.gravity[i];
    }
    mj_step2(model_.get(), data_.get());
    read_efforts();
    measure_forces();
    std::fill_n(data_->xfrc_applied, 6 * model_->nbody, 0.0);
    std::fill_n(data_->qfrc_applied, model_->nv, 0.0);
    begin_step(model_.get(), data_.get(), directions_);
  }

  /// The solver takes friction along a joint as a force, limited by `frictionloss`, that brings the
  /// joint's velocity to 0, together with all contacts. Its reference is shifted here, so that the
  /// velocity comes to that of the motor: a motor with a limited torque, as Gazebo's engines have.
  void drive_motors() {
    motor_rows_.assign(model_->nv, -1);
    for (int row = data_->ne; row < data_->ne + data_->nf; ++row)
      if (data_->efc_type[row] == mjCNSTR_FRICTION_DOF) motor_rows_[data_->efc_id[row]] = row;
    for (const JointRow& joint : joints_) {
      if (joint.dof < 0 || !joint.motor.on || motor_rows_[joint.dof] < 0) continue;
      const int row = motor_rows_[joint.dof];
      data_->efc_aref[row] += data_->efc_KBIP[4 * row + 1] * joint.motor.velocity;
    }
  }

  /// The spring of a contact is critically damped: at a depth d it comes to the speed d / 2T, with
  /// its time constant T. Deeper contacts push as if they were at the depth of the greatest speed.
  void separate_slowly() {
    for (int i = 0; i < data_->ncon; ++i) {
      const mjContact& contact = data_->contact[i];
      const double deep = -contact.dist - 2 * contact.solref[0] * kSeparationSpeed;
      const int row = contact.efc_address;
      if (row >= 0 && contact.solref[0] > 0 && deep > 0)
        data_->efc_aref[row] -= data_->efc_KBIP[4 * row] * data_->efc_KBIP[4 * row + 2] * deep;
    }
  }

  void read_efforts() {
    for (JointRow& joint : joints_) {
      if (joint.dof < 0) continue;
      const int row = joint.motor.on ? motor_rows_[joint.dof] : -1;
      joint.effort = (row >= 0 ? data_->efc_force[row] : 0) + data_->qfrc_applied[joint.dof];
    }
  }

  /// Between the halves of a step, as the next one begins with other contacts.
  void measure_forces() {
    if (watches_contacts_) read_touches(*model_, *data_, collision_of_geom_, touches_);
    if (std::none_of(links_.begin(), links_.end(),
                     [](const LinkRow& row) { return row.is_watched; }))
      return;
    mj_rnePostConstraint(model_.get(), data_.get());
    for (LinkRow& row : links_)
      if (row.is_watched && row.body >= 0) row.wrench = wrench_of_parent(*model_, *data_, row.body);
  }

  void forget_forces() {
    touches_.clear();
    for (LinkRow& row : links_) row.wrench = {};
  }

  /// More work memory, for worlds with many contacts. False when it is as large as it may be.
  bool grow() {
    MjcfLimits limits = limits_;
    limits.contacts = std::min(2 * limits.contacts, kMostContacts);
    limits.stack = std::min(2 * limits.stack, kMostStack);
    std::fill_n(data_->warning, mjNWARNING, mjWarningStat{});
    if (limits.contacts == limits_.contacts && limits.stack == limits_.stack) return false;
    build(world_, limits);
    return true;
  }

  [[noreturn]] void report_explosion() {
    const int dof = dof_of_warning(*model_, *data_);
    std::string model = "a model";
    if (dof >= 0 && dof < model_->nv) {
      const int body = model_->dof_bodyid[dof];
      for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i] == body)
          model = "model `" + names_.link_names[i].first + "`, link `" +
                  names_.link_names[i].second + "`,";
    }
    std::fill_n(data_->warning, mjNWARNING, mjWarningStat{});
    throw PhysicsError(
        model +
        " moves faster than can be computed: the world is reset and paused; look at its "
        "masses, moments of inertia and overlapping collisions");
  }

  void place_root(int number, const Pose& pose, bool at_rest) {
    const int joint = free_joint_of(*model_, number);
    if (joint < 0) {
      put(pose.position, model_->body_pos + 3 * bodies_[number]);
      put(pose.orientation, model_->body_quat + 4 * bodies_[number]);
      return;
    }
    mjtNum* where = data_->qpos + model_->jnt_qposadr[joint];
    put(pose.position, where);
    put(pose.orientation, where + 3);
    if (at_rest) std::fill_n(data_->qvel + model_->jnt_dofadr[joint], 6, 0.0);
  }

  void rest_joints(const std::string& model) {
    for (const JointRow& row : joints_)
      if (row.model == model && row.dof >= 0) data_->qvel[row.dof] = 0;
  }

  const Model* model_named(const std::string& name) const {
    const auto found = std::find_if(world_.models.begin(), world_.models.end(),
                                    [&](const Model& one) { return one.name == name; });
    return found == world_.models.end() ? nullptr : &*found;
  }
  static Pose link_pose(const Model& model, const std::string& link) {
    const auto found = std::find_if(model.links.begin(), model.links.end(),
                                    [&](const Link& one) { return one.name == link; });
    return found == model.links.end() ? Pose{} : found->pose;
  }

  int body_of(LinkHandle link) const { return link.valid() ? links_[link.index].body : -1; }
  const JointRow* row_of(JointHandle joint) const {
    return joint.valid() && joints_[joint.index].id >= 0 ? &joints_[joint.index] : nullptr;
  }
  JointRow* row_of(JointHandle joint) {
    return joint.valid() && joints_[joint.index].id >= 0 ? &joints_[joint.index] : nullptr;
  }

  MeshReader meshes_;
  std::set<std::string> refused_meshes_;  ///< by path
  std::set<std::string> said_;
  std::vector<std::string> warnings_;
  World world_;
  MjcfLimits limits_;
  ModelPointer model_;
  DataPointer data_;
  MjcfNames names_;
  std::vector<int> bodies_;  ///< MuJoCo's number of our body
  std::vector<LinkRow> links_;
  std::vector<JointRow> joints_;
  std::map<std::pair<std::string, std::string>, std::size_t> joint_rows_;
  std::vector<int> weightless_;
  std::vector<int> motor_rows_;
  bool watches_contacts_ = false;
  std::vector<int> collision_of_geom_;  ///< -1 for those that are only seen
  std::vector<Touch> touches_;
  std::vector<Weld> welds_;
  std::vector<FrictionDirection> directions_;
  bool is_moved_ = false;  ///< positions or constraints were set after the last refresh()
};

}  // namespace

std::unique_ptr<Physics> make_physics(MeshReader meshes) {
  return std::make_unique<MujocoPhysics>(std::move(meshes));
}

}  // namespace ros2wasm_sim
