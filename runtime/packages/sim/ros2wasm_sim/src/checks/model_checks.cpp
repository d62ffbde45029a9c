// See model_checks.hpp.
#include "checks/model_checks.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "checks/shape_extent.hpp"
#include "sdf/nearest_name.hpp"

namespace ros2wasm_sim {
namespace {

constexpr double kWrongFactor = 1000, kWrongDefault = 100;
constexpr double kSunk = 0.02;  // metres
const std::array<Vector3, 3> kAxes{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};

/// The box around shapes.
struct Bounds {
  std::array<double, 3> low{kInfinity, kInfinity, kInfinity};
  std::array<double, 3> high{-kInfinity, -kInfinity, -kInfinity};

  /// False: the extent of the shape is not known.
  bool add(const Pose& pose, const Geometry& geometry) {
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const auto reach = extent(geometry, pose.orientation, kAxes[i]);
      if (!reach) return false;
      const double centre = dot(pose.position, kAxes[i]);
      low[i] = std::min(low[i], centre - *reach);
      high[i] = std::max(high[i], centre + *reach);
    }
    return true;
  }
};

template <typename Shapes>
std::optional<std::array<double, 3>> size_of(const Shapes& shapes) {
  Bounds bounds;
  for (const auto& shape : shapes)
    if (!bounds.add(shape.pose, shape.geometry)) return std::nullopt;
  if (shapes.empty()) return std::nullopt;
  return std::array<double, 3>{bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1],
                               bounds.high[2] - bounds.low[2]};
}

/// The largest moment of a solid box.
double box_moment(double mass, std::array<double, 3> size) {
  std::sort(size.begin(), size.end());
  return mass / 12 * (size[1] * size[1] + size[2] * size[2]);
}

bool is_fixed_to_world(const Model& model) {
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [](const Joint& joint) { return joint.parent == "world"; });
}

const Joint* joint_named(const Model& model, const std::string& name) {
  const auto found = std::find_if(model.joints.begin(), model.joints.end(),
                                  [&](const Joint& one) { return one.name == name; });
  return found == model.joints.end() ? nullptr : &*found;
}

/// In the model.
Vector3 centre_of(const Link& wheel) {
  return wheel.collisions.empty() ? wheel.pose.position
                                  : (wheel.pose * wheel.collisions.front().pose).position;
}

std::optional<double> radius_of(const Link& wheel) {
  if (wheel.collisions.empty()) return std::nullopt;
  const Geometry& shape = wheel.collisions.front().geometry;
  if (const auto* one = std::get_if<Cylinder>(&shape)) return one->radius;
  if (const auto* one = std::get_if<Sphere>(&shape)) return one->radius;
  return std::nullopt;
}

bool differ(double given, double measured) {
  return std::abs(given - measured) > 0.1 * measured;
}

/// The wheels of a pair, with the axes of their joints in the model.
struct Pair {
  const Link* left;
  const Link* right;
  Vector3 left_axis, right_axis;
};

std::optional<Pair> pair_of(const Model& model, const std::string& left, const std::string& right) {
  const Joint *l = joint_named(model, left), *r = joint_named(model, right);
  if (l == nullptr || r == nullptr || l->axes.empty() || r->axes.empty()) return std::nullopt;
  Pair pair{wheel_of(model, left), wheel_of(model, right), {}, {}};
  if (pair.left == nullptr || pair.right == nullptr) return std::nullopt;
  const auto axis = [](const Joint& joint, const Link& wheel) {
    return rotate(wheel.pose.orientation * joint.pose.orientation, joint.axes.front().xyz);
  };
  pair.left_axis = axis(*l, *pair.left);
  pair.right_axis = axis(*r, *pair.right);
  return pair;
}

/// Which way the robot goes when its wheels turn with positive velocities: axis x up.
std::string direction_remark(const Model& model, const DrivenWheels& wheels, const Pair& pair) {
  const Vector3 up{0, 0, 1}, forward = cross(pair.left_axis, up);
  const std::string robot = "the wheels of [" + model.name + "]: ";
  if (dot(pair.left_axis, pair.right_axis) < -0.7)
    return robot + "the axes of the joints [" + wheels.left.front() + "] and [" +
           wheels.right.front() +
           "] point in opposite directions, so the robot turns when it should drive: give both "
           "<axis> the same direction, to the left of the robot";
  const double left_of_right =
      dot(centre_of(*pair.left) - centre_of(*pair.right), cross(up, forward));
  if (left_of_right > -1e-3 || std::abs(forward.x) < 0.7) return "";
  if (forward.x < 0)
    return robot + "the axes of the joints [" + wheels.left.front() + "] and [" +
           wheels.right.front() +
           "] point to the right of the robot, so it drives backwards: turn both <axis> round";
  return robot + "the joint [" + wheels.left.front() + "] is on the right side and [" +
         wheels.right.front() +
         "] on the left one, so the robot turns the wrong way: exchange <left_joint> and "
         "<right_joint>";
}

void add_size_remarks(const Model& model, const DrivenWheels& wheels, const Pair& pair,
                      std::vector<std::string>& remarks) {
  const double apart =
      std::abs(dot(centre_of(*pair.left) - centre_of(*pair.right), pair.left_axis));
  // Robots that skid write a larger one on purpose.
  if (wheels.left.size() == 1 && apart > 1e-3 && differ(wheels.separation, apart))
    remarks.push_back("<wheel_separation> of [" + model.name + "] is " + shown(wheels.separation) +
                      " m, but its wheels are " + shown(apart) +
                      " m apart: turns and odometry are wrong by this factor");
  const auto radius = radius_of(*pair.left);
  if (!radius || !differ(wheels.radius, *radius)) return;
  const double times = wheels.writes_diameter ? 2 : 1;
  remarks.push_back((wheels.writes_diameter ? "<wheel_diameter> of [" : "<wheel_radius> of [") +
                    model.name + "] is " + shown(times * wheels.radius) +
                    " m, but the collision of its wheel has " + shown(times * *radius) +
                    " m: speed and odometry are wrong by this factor");
}

}  // namespace

std::string shown(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

std::optional<std::string> inertia_remark(const Model& model) {
  if (model.is_static || is_fixed_to_world(model)) return std::nullopt;
  double worst = 1;
  std::string remark;
  for (const Link& link : model.links) {
    const auto size = link.collisions.empty() ? size_of(link.visuals) : size_of(link.collisions);
    if (!size || link.kinematic) continue;
    const Inertial& given = link.inertial;
    const double expected = box_moment(given.mass, *size);
    const double most = std::max({given.ixx, given.iyy, given.izz});
    if (!(expected > 0) || !(most > 0)) continue;
    const bool is_default = given.ixx == 1 && given.iyy == 1 && given.izz == 1;
    const double factor = std::max(most / expected, expected / most);
    if (factor < (is_default ? kWrongDefault : kWrongFactor) || factor <= worst) continue;
    worst = factor;
    remark =
        "the link [" + link.name + "] of [" + model.name + "] has a moment of inertia of " +
        shown(most) + " kg m^2" + (is_default ? ", which is the default" : "") +
        ", but a body of " + shown(given.mass) + " kg and " + shown((*size)[0]) + " x " +
        shown((*size)[1]) + " x " + shown((*size)[2]) + " m has about " + shown(expected) +
        " kg m^2: the robot may be slow, tip or spin. A solid box has m/12 (y^2 + z^2) about x";
  }
  return remark.empty() ? std::nullopt : std::optional(remark);
}

std::optional<double> ground_height(const World& world) {
  std::optional<double> highest;
  for (const Model& model : world.models)
    for (const Link& link : model.links)
      for (const Collision& collision : link.collisions) {
        const auto* plane = std::get_if<Plane>(&collision.geometry);
        const Pose pose = model.pose * link.pose * collision.pose;
        if (plane == nullptr || rotate(pose.orientation, plane->normal).z < 0.999) continue;
        highest = std::max(highest.value_or(-kInfinity), pose.position.z);
      }
  return highest;
}

std::optional<std::string> height_remark(const Model& model, double ground) {
  const bool is_robot = !model.joints.empty() || !model.plugins.empty();
  if (model.is_static || is_fixed_to_world(model) || !is_robot) return std::nullopt;
  double lowest = kInfinity;
  std::string name;
  for (const Link& link : model.links)
    for (const Collision& collision : link.collisions) {
      const Pose pose = model.pose * link.pose * collision.pose;
      const auto reach = extent(collision.geometry, pose.orientation, {0, 0, -1});
      if (!reach || pose.position.z - *reach >= lowest) continue;
      lowest = pose.position.z - *reach;
      name = link.name;
    }
  if (!(lowest < ground - kSunk)) return std::nullopt;
  return "[" + model.name +
         "] begins inside of the ground, which pushes it out with a jump: its "
         "lowest collision, of the link [" +
         name + "], is " + shown(ground - lowest) +
         " m below it. Spawn it at z = " + shown(model.pose.position.z + ground - lowest) +
         " or higher";
}

std::string nearest_joint(const Model& model, const std::string& wrong) {
  std::vector<std::string> names;
  for (const Joint& joint : model.joints) names.push_back(joint.name);
  const std::string nearest = nearest_name(wrong, names);
  return nearest.empty() ? "" : "; the nearest joint is [" + nearest + "]";
}

const Link* wheel_of(const Model& model, const std::string& joint) {
  const Joint* const found = joint_named(model, joint);
  if (found == nullptr) return nullptr;
  const auto link = std::find_if(model.links.begin(), model.links.end(),
                                 [&](const Link& one) { return one.name == found->child; });
  return link == model.links.end() ? nullptr : &*link;
}

std::vector<std::string> wheel_remarks(const Model& model, const DrivenWheels& wheels) {
  std::vector<std::string> remarks;
  for (const auto* side : {&wheels.left, &wheels.right})
    for (const std::string& joint : *side) {
      const Link* const wheel = wheel_of(model, joint);
      // Another link may carry the shape of the wheel.
      const auto is_below = [&](const Joint& one) { return one.parent == wheel->name; };
      if (wheel == nullptr || !wheel->collisions.empty() ||
          std::any_of(model.joints.begin(), model.joints.end(), is_below))
        continue;
      remarks.push_back("the wheel [" + wheel->name + "] of [" + model.name +
                        "] has no <collision>, so it turns without touching the ground");
    }
  if (wheels.left.empty() || wheels.right.empty()) return remarks;
  const auto pair = pair_of(model, wheels.left.front(), wheels.right.front());
  if (!pair) return remarks;
  if (std::string remark = direction_remark(model, wheels, *pair); !remark.empty())
    remarks.push_back(std::move(remark));
  add_size_remarks(model, wheels, *pair, remarks);
  return remarks;
}

}  // namespace ros2wasm_sim
