// See mjcf.hpp.
#include "physics/mjcf.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <unordered_map>

#include "physics/mjcf_shapes.hpp"

namespace ros2wasm_sim {
namespace {

/// A driven or free joint needs a little inertia of its own, or light parts shake (kg m^2, or kg).
constexpr double kArmature = 1e-4;
constexpr double kLeastMass = 1e-3;
constexpr double kLeastInertia = 1e-7;

/// The moments along the axes of the link, which the engine can take.
std::string inertia(const Inertial& inertial, const std::string& name,
                    std::vector<std::string>& warnings) {
  const double m[3][3] = {{inertial.ixx, inertial.ixy, inertial.ixz},
                          {inertial.ixy, inertial.iyy, inertial.iyz},
                          {inertial.ixz, inertial.iyz, inertial.izz}};
  Vector3 columns[3];  // of R * M
  for (int c = 0; c < 3; ++c)
    columns[c] = rotate(inertial.pose.orientation, {m[0][c], m[1][c], m[2][c]});
  double r[3][3];  // R * M * R^T, a row after the other
  for (int row = 0; row < 3; ++row) {
    const auto at = [row](const Vector3& v) { return row == 0 ? v.x : row == 1 ? v.y : v.z; };
    const Vector3 turned =
        rotate(inertial.pose.orientation, {at(columns[0]), at(columns[1]), at(columns[2])});
    r[row][0] = turned.x;
    r[row][1] = turned.y;
    r[row][2] = turned.z;
  }
  for (int i = 0; i < 3; ++i) r[i][i] = std::max(r[i][i], kLeastInertia);
  const double minor = r[0][0] * r[1][1] - r[0][1] * r[0][1];
  const double determinant = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[1][2]) -
                             r[0][1] * (r[0][1] * r[2][2] - r[1][2] * r[0][2]) +
                             r[0][2] * (r[0][1] * r[1][2] - r[1][1] * r[0][2]);
  if (minor <= 0 || determinant <= 0) {
    warnings.push_back(
        "link `" + name +
        "`: the products of inertia are larger than the moments allow; they are ignored");
    r[0][1] = r[0][2] = r[1][2] = 0;
  }
  return number(r[0][0]) + " " + number(r[1][1]) + " " + number(r[2][2]) + " " + number(r[0][1]) +
         " " + number(r[0][2]) + " " + number(r[1][2]);
}

bool is_finite_range(const JointAxis& axis) {
  return std::isfinite(axis.lower) || std::isfinite(axis.upper);
}

/// Writes the bodies of one model.
class ModelWriter {
 public:
  ModelWriter(const Model& model, ShapeWriter& shapes, Mjcf& mjcf, std::string& bodies,
              std::string& constraints)
      : model_(model), shapes_(shapes), mjcf_(mjcf), bodies_(bodies), constraints_(constraints) {
    for (const Link& link : model.links) links_.emplace(link.name, &link);
    for (const Joint& joint : model.joints) {
      if (model.is_static) continue;
      if (links_.count(joint.child) == 0) continue;
      if (!parent_joints_.emplace(joint.child, &joint).second) {
        warn("joint `" + joint.name + "` is skipped: link `" + joint.child +
             "` has a parent already, and loops are not simulated");
        continue;
      }
      if (joint.parent != "world") children_[joint.parent].push_back(&joint);
    }
  }

  void write() {
    for (const Link& link : model_.links) {
      const auto joint = parent_joints_.find(link.name);
      if (joint == parent_joints_.end() || joint->second->parent == "world")
        write_tree(link, joint == parent_joints_.end() ? nullptr : joint->second);
    }
    for (const Link& link : model_.links)
      if (written_.count(link.name) == 0)
        warn("link `" + link.name + "` is skipped: its joints form a circle");
    write_exclusions();
    write_mimics();
  }

 private:
  /// A branch that is open: what is below it is written before it ends.
  struct Open {
    const Link* link;
    std::size_t next = 0;
  };

  /// Not by recursion: chains of links may be long.
  void write_tree(const Link& root, const Joint* joint) {
    mjcf_.names.roots[model_.name].push_back(static_cast<int>(mjcf_.names.link_names.size()));
    begin_body(root, joint, model_.pose * root.pose, !model_.is_static && joint == nullptr);
    std::vector<Open> open{{&root}};
    while (!open.empty()) {
      Open& top = open.back();
      const auto below = children_.find(top.link->name);
      if (below == children_.end() || top.next == below->second.size()) {
        bodies_ += "</body>\n";
        open.pop_back();
        continue;
      }
      const Joint* child_joint = below->second[top.next++];
      const Link* child = links_.at(child_joint->child);
      if (written_.count(child->name) != 0) continue;
      begin_body(*child, child_joint, inverse(top.link->pose) * child->pose, false);
      open.push_back({child});
    }
  }

  void begin_body(const Link& link, const Joint* joint, const Pose& pose, bool is_free) {
    const int body = static_cast<int>(mjcf_.names.link_names.size());
    written_.insert(link.name);
    numbers_.push_back(body);
    mjcf_.names.links[{model_.name, link.name}] = body;
    mjcf_.names.link_names.emplace_back(model_.name, link.name);
    if (!link.gravity) mjcf_.names.weightless.push_back(body);
    bodies_ += "<body name=\"b" + std::to_string(body) + "\"" + placed(pose) + ">\n";
    if (is_free) bodies_ += "<freejoint name=\"f" + std::to_string(body) + "\"/>\n";
    if (joint != nullptr) write_joint(*joint);
    const Vector3& centre = link.inertial.pose.position;
    bodies_ += "<inertial pos=\"" + text(centre) + "\" mass=\"" +
               number(std::max(link.inertial.mass, kLeastMass)) + "\" fullinertia=\"" +
               inertia(link.inertial, link.name, mjcf_.warnings) + "\"/>\n";
    // Links of a static model in a model that is not hang on the world by fixed joints.
    const bool is_held =
        joint != nullptr && joint->type == JointType::kFixed && joint->parent == "world";
    const bool moves = is_free || (joint != nullptr && !is_held);
    bodies_ += shapes_.shapes_of(link, {joint, moves, pose}, mjcf_);
  }

  void write_joint(const Joint& joint) {
    const int index = static_cast<int>(mjcf_.names.joints.size());
    switch (joint.type) {
      case JointType::kFixed:
        return;
      case JointType::kBall:
        bodies_ += "<joint name=\"j" + std::to_string(index) + "\" type=\"ball\" pos=\"" +
                   text(joint.pose.position) + "\" armature=\"" + number(kArmature) + "\"/>\n";
        mjcf_.names.joints[{model_.name, joint.name}] = index;
        return;
      case JointType::kRevolute:
        write_axis(joint, 0, "hinge", index);
        return;
      case JointType::kPrismatic:
        write_axis(joint, 0, "slide", index);
        return;
      case JointType::kUniversal:
      case JointType::kRevolute2:
        write_axis(joint, 0, "hinge", index);
        write_axis(joint, 1, "hinge", index);
        return;
      case JointType::kScrew:
        write_axis(joint, 0, "hinge", index);
        warn("joint `" + joint.name + "` turns only: the advance of screws is not simulated");
        return;
    }
  }

  void write_axis(const Joint& joint, std::size_t which, const char* type, int index) {
    if (which >= joint.axes.size()) return;
    const JointAxis& axis = joint.axes[which];
    const std::string name = "j" + std::to_string(index) + (which == 0 ? "" : "_2");
    bodies_ += "<joint name=\"" + name + "\" type=\"" + type + "\" pos=\"" +
               text(joint.pose.position) + "\" axis=\"" +
               text(rotate(joint.pose.orientation, axis.xyz)) + "\" armature=\"" +
               number(kArmature) + "\"";
    if (is_finite_range(axis) && axis.lower <= axis.upper) {
      constexpr double kFar = 1e5;
      double lower = std::max(axis.lower, -kFar), upper = std::min(axis.upper, kFar);
      if (lower == upper) upper = lower + 1e-6;
      bodies_ += " limited=\"true\" range=\"" + number(lower) + " " + number(upper) + "\"";
    }
    if (axis.damping > 0) bodies_ += " damping=\"" + number(axis.damping) + "\"";
    if (axis.friction > 0) bodies_ += " frictionloss=\"" + number(axis.friction) + "\"";
    if (axis.spring_stiffness > 0)
      bodies_ += " stiffness=\"" + number(axis.spring_stiffness) + "\" springref=\"" +
                 number(axis.spring_reference) + "\"";
    bodies_ += "/>\n";
    if (which == 0) mjcf_.names.joints[{model_.name, joint.name}] = index;
  }

  /// Links of one model do not meet, unless it asks for that.
  void write_exclusions() {
    if (model_.self_collide) return;
    for (std::size_t a = 0; a < numbers_.size(); ++a)
      for (std::size_t b = a + 1; b < numbers_.size(); ++b)
        if (shapes_.collides(numbers_[a]) && shapes_.collides(numbers_[b]))
          constraints_ += "<exclude body1=\"b" + std::to_string(numbers_[a]) + "\" body2=\"b" +
                          std::to_string(numbers_[b]) + "\"/>\n";
  }

  void write_mimics() {
    for (const Joint& joint : model_.joints) {
      if (joint.axes.empty() || !joint.axes[0].mimic) continue;
      const Mimic& mimic = *joint.axes[0].mimic;
      const auto follower = mjcf_.names.joints.find({model_.name, joint.name});
      const auto leader = mjcf_.names.joints.find({model_.name, mimic.joint});
      if (follower == mjcf_.names.joints.end()) continue;
      if (leader == mjcf_.names.joints.end()) {
        warn("joint `" + joint.name + "` mimics `" + mimic.joint + "`, which does not exist");
        continue;
      }
      equalities_ += "<joint joint1=\"j" + std::to_string(follower->second) + "\" joint2=\"j" +
                     std::to_string(leader->second) + "\" polycoef=\"" +
                     number(mimic.offset - mimic.multiplier * mimic.reference) + " " +
                     number(mimic.multiplier) + " 0 0 0\" solref=\".004 1\"/>\n";
    }
  }

  void warn(std::string text) {
    mjcf_.warnings.push_back("model `" + model_.name + "`: " + std::move(text));
  }

  const Model& model_;
  ShapeWriter& shapes_;
  Mjcf& mjcf_;
  std::string& bodies_;
  std::string& constraints_;
  std::unordered_map<std::string, const Link*> links_;
  std::unordered_map<std::string, const Joint*> parent_joints_;
  std::unordered_map<std::string, std::vector<const Joint*>> children_;
  std::set<std::string> written_;
  std::vector<int> numbers_;

 public:
  std::string equalities_;
};

}  // namespace

void check_size(const World& world) {
  constexpr std::size_t kMostLinks = 5000, kMostMoving = 2000;
  std::size_t links = 0, moving = 0;
  for (const Model& model : world.models) {
    links += model.links.size();
    moving += model.is_static ? 0 : model.links.size();
  }
  if (links > kMostLinks)
    throw PhysicsError("the world has " + std::to_string(links) + " links; at most " +
                       std::to_string(kMostLinks) + " are simulated");
  if (moving > kMostMoving)
    throw PhysicsError("the world has " + std::to_string(moving) + " links that move; at most " +
                       std::to_string(kMostMoving) + " are simulated");
}

Mjcf write_mjcf(const World& world, const MeshReader& meshes, const MjcfLimits& limits) {
  Mjcf mjcf;
  ShapeWriter shapes(world, meshes);
  std::string bodies, exclusions, equalities;
  for (const Model& model : world.models) {
    ModelWriter writer(model, shapes, mjcf, bodies, exclusions);
    writer.write();
    equalities += writer.equalities_;
  }
  if (!mjcf.names.link_names.empty())
    for (int i = 0; i < kSpareWelds; ++i) equalities += "<weld body1=\"b0\" active=\"false\"/>\n";
  const double step = world.physics.max_step_size;
  // Limits and motors answer within two steps, which is as quick as the engine can be. Contacts
  // keep its time constant, as stacks of boxes shake with a shorter one, but give way less. A mesh
  // touches at several points (multiccd), so that it stands still.
  const std::string solref = number(2 * step) + " 1";
  mjcf.xml =
      "<mujoco>\n<compiler angle=\"radian\" inertiafromgeom=\"false\" balanceinertia=\"true\"/>\n"
      "<option timestep=\"" +
      number(step) + "\" gravity=\"" + text(world.gravity) +
      "\" cone=\"elliptic\" integrator=\"Euler\" jacobian=\"auto\"><flag "
      "multiccd=\"enable\"/></option>\n"
      "<size nconmax=\"" +
      std::to_string(limits.contacts) + "\" njmax=\"" + std::to_string(4 * limits.contacts) +
      "\" nstack=\"" + std::to_string(limits.stack) +
      "\"/>\n<default><geom condim=\"3\" solref=\".02 1\" solimp=\".99 .999 .001\"/><joint "
      "solreflimit=\"" +
      solref + "\" solreffriction=\"" + solref +
      "\" solimpfriction=\".999 .9999 .001\"/></default>\n"
      "<asset>\n" +
      shapes.assets() + "</asset>\n<worldbody>\n" + bodies + "</worldbody>\n<contact>\n" +
      exclusions + "</contact>\n<equality>\n" + equalities + "</equality>\n</mujoco>\n";
  return mjcf;
}

}  // namespace ros2wasm_sim
