// See read_urdf.hpp.
#include "sdf/read_urdf.hpp"

#include <unordered_set>
#include <utility>

#include "sdf/sdf_joint.hpp"
#include "sdf/sdf_link.hpp"
#include "sdf/urdf_contacts.hpp"
#include "sdf/urdf_gazebo_tags.hpp"
#include "sdf/urdf_lumping.hpp"

namespace ros2wasm_sim {
namespace {

/// Why a link has no mass, and what is lost with it.
void report_massless(Context& context, const UrdfRobot& robot, const LumpedLink& link,
                     std::size_t below) {
  const std::string& name = link.value.name;
  const UrdfLink& from = robot.links[link.link];
  std::string text = "urdf2sdf: link[" + name + "] has " +
                     (link.has_inertial ? "a mass value of less than or equal to zero. "
                                        : "no <inertial> block defined. ");
  if (from.joint != kNone) {
    text += "urdf2sdf: parent joint[" + robot.joints[from.joint].name + "] ignored. ";
  }
  if (below != 0) {
    text += "urdf2sdf: [" + std::to_string(below) + "] child joints ignored. ";
  }
  text += "urdf2sdf: link[" + name +
          "] is not modeled in sdf. All links below it vanish too. Give "
          "it an <inertial> with a mass, or connect it with a fixed joint to a link that has one.";
  if (!link.value.sensors.empty()) {
    text += " Its sensors vanish as well.";
  }
  context.warning(from.where, text);
}

std::optional<Joint> joint_of(Context& context, const UrdfJoint& from, const Link& parent,
                              const Link& child_link) {
  Joint joint;
  joint.name = from.name;
  joint.parent = parent.name;
  joint.child = child_link.name;
  joint.sensors = from.sensors;
  if (from.type == "floating" || from.type == "planar") {
    context.warning(from.where, "the " + from.type + " joint `" + from.name +
                                    "` is not part of the simulation: its child `" +
                                    child_link.name + "` moves freely");
    return std::nullopt;
  }
  if (from.type == "fixed" && (from.is_preserved || !from.is_locked_axis)) {
    joint.type = JointType::kFixed;
    return joint;
  }
  joint.type = from.type == "prismatic" ? JointType::kPrismatic : JointType::kRevolute;
  JointAxis axis = from.axis;
  if (from.type == "fixed") {
    axis.xyz = {0, 0, 1};
    axis.lower = axis.upper = 0;
  }
  joint.axes.push_back(axis);
  return joint;
}

class RobotConverter {
 public:
  RobotConverter(Context& context, const Node& node, UrdfRobot robot)
      : context_(context), node_(node), robot_(std::move(robot)) {}

  Model convert();

 private:
  void keep_links();
  void keep_joint(const LumpedLink& link);
  void keep_frames();
  void check_joints();
  Scope scope() const;

  Context& context_;
  Node node_;
  UrdfRobot robot_;
  Lumped lumped_;
  std::vector<bool> is_kept_;  ///< of each lumped link
  Model model_;
};

void RobotConverter::keep_joint(const LumpedLink& link) {
  const std::size_t index = robot_.links[link.link].joint;
  if (index == kNone) {
    return;
  }
  const UrdfJoint& from = robot_.joints[index];
  const LumpedLink& parent = lumped_.links[lumped_.owners[from.parent]];
  if (auto joint = joint_of(context_, from, parent.value, link.value)) {
    model_.joints.push_back(std::move(*joint));
  }
}

void RobotConverter::keep_links() {
  std::vector<std::size_t> below(lumped_.links.size(), 0);
  for (const LumpedLink& link : lumped_.links) {
    const std::size_t joint = robot_.links[link.link].joint;
    if (joint != kNone) {
      ++below[lumped_.owners[robot_.joints[joint].parent]];
    }
  }
  is_kept_.assign(lumped_.links.size(), false);
  for (std::size_t i = 0; i < lumped_.links.size(); ++i) {
    LumpedLink& link = lumped_.links[i];
    const UrdfLink& from = robot_.links[link.link];
    if (link.value.name == "world") {
      is_kept_[i] = true;
      if (!link.value.collisions.empty() || !link.value.visuals.empty()) {
        context_.warning(from.where,
                         "the link `world` is the world itself, so its shapes are "
                         "skipped");
      }
      continue;
    }
    const bool has_parent = from.joint != kNone;
    if (has_parent && !is_kept_[lumped_.owners[robot_.joints[from.joint].parent]]) {
      continue;  // It vanishes with its parent.
    }
    if (!link.has_inertial || link.value.inertial.mass <= 0) {
      report_massless(context_, robot_, link, below[i]);
      continue;
    }
    is_kept_[i] = true;
    check_inertial(context_, from.where, link.value.name, link.value.inertial);
    for (Sensor& sensor : link.value.sensors) {
      rename_contacts(context_, lumped_.renamed, sensor);
    }
    keep_joint(link);
    model_.links.push_back(link.value);
  }
}

/// Frames of what was lumped, and warnings about sensors that went with their joints.
void RobotConverter::keep_frames() {
  for (const Frame& frame : lumped_.frames) {
    const auto link = robot_.link_index.find(frame.link);
    if (link != robot_.link_index.end() && is_kept_[lumped_.owners[link->second]] &&
        frame.link != "world") {
      model_.frames.push_back(frame);
    }
  }
  for (const UrdfJoint& joint : robot_.joints) {
    if (is_lumped(robot_, joint) && !joint.sensors.empty()) {
      context_.warning(joint.where,
                       "the sensor `" + joint.sensors.front().name +
                           "` is skipped, since its fixed joint `" + joint.name +
                           "` is lumped: add <gazebo reference=\"" + joint.name +
                           "\"><preserveFixedJoint>true</preserveFixedJoint></gazebo>");
    }
  }
}

/// The links and frames of the model, for joints in <gazebo> elements.
Scope RobotConverter::scope() const {
  Scope scope("__model__");
  const Resources nothing;
  Context quiet(nothing);
  for (const Link& link : model_.links) {
    Scope::Entry entry;
    entry.name = link.name;
    entry.kind = Scope::Kind::kLink;
    entry.pose.pose = link.pose;
    scope.add(quiet, std::move(entry));
  }
  for (const Frame& frame : model_.frames) {
    Scope::Entry entry;
    entry.name = frame.name;
    entry.pose.pose = frame.pose;
    entry.attached_to = frame.link;
    scope.add(quiet, std::move(entry));
  }
  for (const Node& tag : children(node_, "gazebo")) {
    for (const Node& joint : children(tag, "joint")) {
      Scope::Entry entry;
      entry.name = attribute(joint, "name");
      entry.kind = Scope::Kind::kJoint;
      entry.where = joint;
      entry.pose = raw_pose(quiet, joint);
      entry.attached_to = text_of(joint, "child");
      scope.add(quiet, std::move(entry));
    }
  }
  scope.resolve(quiet, model_.canonical_link);
  return scope;
}

/// Mimics of joints that do not exist count for nothing, as in Gazebo Classic.
void RobotConverter::check_joints() {
  std::unordered_set<std::string> known;
  for (const Joint& joint : model_.joints) {
    known.insert(joint.name);
  }
  for (Joint& joint : model_.joints) {
    for (JointAxis& axis : joint.axes) {
      if (!axis.mimic || (known.count(axis.mimic->joint) != 0 && axis.mimic->joint != joint.name)) {
        continue;
      }
      const auto names = [this] {
        std::vector<std::string> result;
        for (const Joint& one : model_.joints) {
          result.push_back(one.name);
        }
        return result;
      };
      context_.warning(robot_.joints[robot_.joint_index.at(joint.name)].where,
                       "the joint `" + joint.name + "` mimics the joint `" + axis.mimic->joint +
                           "`, which does not exist or is itself, so it moves freely" +
                           context_.hint(axis.mimic->joint, names));
      axis.mimic.reset();
    }
  }
}

Model RobotConverter::convert() {
  apply_references(context_, node_, robot_);
  lumped_ = lump_fixed_joints(robot_);
  model_.name = robot_.name;
  model_.pose = robot_.pose;
  keep_links();
  keep_frames();
  check_joints();
  if (model_.links.empty()) {
    context_.error(node_, "the robot `" + robot_.name +
                              "` has no link with a mass. A model must "
                              "have at least one link.");
    return std::move(model_);
  }
  model_.canonical_link = model_.links.front().name;
  apply_model_tags(context_, node_, scope(), model_);
  return std::move(model_);
}

}  // namespace

Reading<Model> read_urdf(const std::shared_ptr<const ros2wasm_xml::XmlDocument>& document,
                         const std::string& file, const Resources& resources) {
  Context context(resources);
  const Source* source = context.add(document, file, folder_of(file));
  const Node node{source, &document->root()};
  Reading<Model> result;
  if (node.element->name != "robot") {
    context.error(node, "the text is not a URDF: its first element is <" + node.element->name +
                            "> instead of <robot>");
  } else if (auto robot = read_robot(context, node)) {
    result.value = RobotConverter(context, node, std::move(*robot)).convert();
  }
  if (context.has_error()) {
    result.value.reset();
  }
  result.notes = context.take_notes();
  return result;
}

}  // namespace ros2wasm_sim
