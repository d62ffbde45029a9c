// See sdf_model.hpp.
#include "sdf_model.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "elements.hpp"

namespace urdf {
namespace {

std::string text_of(const XmlElement* element) {
  if (element == nullptr) {
    return {};
  }
  const std::size_t first = element->text.find_first_not_of(" \t\r\n");
  const std::size_t last = element->text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? std::string() : element->text.substr(first, last + 1 - first);
}

/// The numbers of a text; ParseError, naming `what`, when there are not as many.
std::vector<double> numbers(const std::string& text, std::size_t count, const std::string& what) {
  std::vector<double> result;
  for (std::size_t at = text.find_first_not_of(" \t\r\n"); at != std::string::npos;) {
    const std::size_t end = text.find_first_of(" \t\r\n", at);
    const std::string word = text.substr(at, end - at);
    try {
      result.push_back(strToDouble(word.c_str()));
    } catch (const std::runtime_error&) {
      throw ParseError(what + " value (" + word + ") is not a valid float");
    }
    at = text.find_first_not_of(" \t\r\n", end);
  }
  if (result.size() != count) {
    throw ParseError(what + " needs " + std::to_string(count) + " numbers, not " +
                     std::to_string(result.size()));
  }
  return result;
}

double number_of(const XmlElement* element, double alternative, const std::string& what) {
  const std::string text = text_of(element);
  return text.empty() ? alternative : numbers(text, 1, what).front();
}

Pose operator*(const Pose& a, const Pose& b) {
  Pose result;
  const Vector3 offset = a.rotation * b.position;
  result.position =
      Vector3(a.position.x + offset.x, a.position.y + offset.y, a.position.z + offset.z);
  result.rotation = a.rotation * b.rotation;
  return result;
}

Pose inverse(const Pose& pose) {
  Pose result;
  result.rotation = pose.rotation.GetInverse();
  const Vector3 back = result.rotation * pose.position;
  result.position = Vector3(-back.x, -back.y, -back.z);
  return result;
}

Pose pose_of(const XmlElement* element) {
  Pose pose;
  const std::string text = text_of(element);
  if (text.empty()) {
    return pose;
  }
  auto values = numbers(text, 6, "pose");
  const std::string* degrees = element->attribute("degrees");
  if (degrees != nullptr && (*degrees == "true" || *degrees == "1")) {
    for (std::size_t i = 3; i < 6; ++i) {
      values[i] *= std::acos(-1.0) / 180;
    }
  }
  pose.position = Vector3(values[0], values[1], values[2]);
  pose.rotation.setFromRPY(values[3], values[4], values[5]);
  return pose;
}

/// Poses of a model are relative to these: its links, joints and frames by name.
class Frames {
 public:
  Frames(const XmlDocument& xml, const XmlElement& model) : xml_(xml) {
    for (const XmlElement* one : xml.children(model, "link")) {
      add(*one, "__model__");
    }
    for (const XmlElement* one : xml.children(model, "joint")) {
      add(*one, text_of(xml.child(*one, "child")));
    }
    for (const XmlElement* one : xml.children(model, "frame")) {
      const std::string* attached = one->attribute("attached_to");
      add(*one, attached == nullptr || attached->empty() ? "__model__" : *attached);
    }
  }

  /// Where it is in the model.
  Pose of(const std::string& name) const {
    Pose result;
    std::set<std::string> seen;
    for (std::string next = name; next != "__model__";) {
      const auto found = frames_.find(next);
      if (found == frames_.end()) {
        throw ParseError("the frame '" + next + "' does not exist in the model");
      }
      if (!seen.insert(next).second) {
        throw ParseError("the pose of '" + name + "' is relative to itself");
      }
      result = found->second.pose * result;
      next = found->second.relative_to;
    }
    return result;
  }

  /// Where a part of the frame `owner` is in the model, such as a visual of a link.
  Pose of_part(const XmlElement& part, const std::string& owner) const {
    const XmlElement* pose = xml_.child(part, "pose");
    const std::string* relative = pose == nullptr ? nullptr : pose->attribute("relative_to");
    return of(relative == nullptr || relative->empty() ? owner : *relative) * pose_of(pose);
  }

 private:
  struct Frame {
    Pose pose;
    std::string relative_to;
  };

  void add(const XmlElement& element, const std::string& usual) {
    const XmlElement* pose = xml_.child(element, "pose");
    const std::string* relative = pose == nullptr ? nullptr : pose->attribute("relative_to");
    const std::string& name = required(element, "name", element.name);
    const Frame frame{pose_of(pose), relative == nullptr || relative->empty() ? usual : *relative};
    if (!frames_.emplace(name, frame).second) {
      throw ParseError(element.name + " '" + name + "' is not unique.");
    }
  }

  const XmlDocument& xml_;
  std::map<std::string, Frame> frames_;
};

/// Null for shapes that URDF does not have.
GeometrySharedPtr geometry_of(const XmlDocument& xml, const XmlElement& part) {
  const XmlElement* geometry = xml.child(part, "geometry");
  if (geometry == nullptr) {
    return nullptr;
  }
  if (const XmlElement* shape = xml.child(*geometry, "box")) {
    auto box = std::make_shared<Box>();
    const auto size = numbers(text_of(xml.child(*shape, "size")), 3, "box size");
    box->dim = Vector3(size[0], size[1], size[2]);
    return box;
  }
  if (const XmlElement* shape = xml.child(*geometry, "sphere")) {
    auto sphere = std::make_shared<Sphere>();
    sphere->radius = number_of(xml.child(*shape, "radius"), 1, "sphere radius");
    return sphere;
  }
  if (const XmlElement* shape = xml.child(*geometry, "cylinder")) {
    auto cylinder = std::make_shared<Cylinder>();
    cylinder->radius = number_of(xml.child(*shape, "radius"), 1, "cylinder radius");
    cylinder->length = number_of(xml.child(*shape, "length"), 1, "cylinder length");
    return cylinder;
  }
  if (const XmlElement* shape = xml.child(*geometry, "mesh")) {
    auto mesh = std::make_shared<Mesh>();
    mesh->filename = text_of(xml.child(*shape, "uri"));
    const std::string scale = text_of(xml.child(*shape, "scale"));
    mesh->scale = Vector3(1, 1, 1);
    if (!scale.empty()) {
      const auto factors = numbers(scale, 3, "mesh scale");
      mesh->scale = Vector3(factors[0], factors[1], factors[2]);
    }
    return mesh;
  }
  return nullptr;
}

InertialSharedPtr inertial_of(const XmlDocument& xml, const XmlElement& element) {
  auto inertial = std::make_shared<Inertial>();
  inertial->mass = number_of(xml.child(element, "mass"), 1, "mass");
  const XmlElement* inertia = xml.child(element, "inertia");
  const auto moment = [&](const char* name, double alternative) {
    return inertia == nullptr ? alternative
                              : number_of(xml.child(*inertia, name), alternative, name);
  };
  inertial->ixx = moment("ixx", 1);
  inertial->ixy = moment("ixy", 0);
  inertial->ixz = moment("ixz", 0);
  inertial->iyy = moment("iyy", 1);
  inertial->iyz = moment("iyz", 0);
  inertial->izz = moment("izz", 1);
  return inertial;
}

/// A link whose own frame is `frame` of the model.
LinkSharedPtr link_of(const XmlDocument& xml, const Frames& frames, const XmlElement& element,
                      const Pose& frame) {
  auto link = std::make_shared<Link>();
  link->name = required(element, "name", "Link");
  const auto place = [&](const XmlElement& part) {
    return inverse(frame) * frames.of_part(part, link->name);
  };
  if (const XmlElement* one = xml.child(element, "inertial")) {
    link->inertial = inertial_of(xml, *one);
    link->inertial->origin = place(*one);
  }
  for (const XmlElement* one : xml.children(element, "visual")) {
    auto visual = std::make_shared<Visual>();
    visual->name = required(*one, "name", "visual");
    visual->origin = place(*one);
    visual->geometry = geometry_of(xml, *one);
    if (const XmlElement* material = xml.child(*one, "material")) {
      const std::string color = text_of(xml.child(*material, "diffuse"));
      visual->material = std::make_shared<Material>();
      visual->material->name = visual->material_name = link->name + "/" + visual->name;
      visual->material->color.init(color.empty() ? "1 1 1 1" : color);
    }
    if (visual->geometry != nullptr) {
      link->visual_array.push_back(visual);
    }
  }
  for (const XmlElement* one : xml.children(element, "collision")) {
    auto collision = std::make_shared<Collision>();
    collision->name = required(*one, "name", "collision");
    collision->origin = place(*one);
    collision->geometry = geometry_of(xml, *one);
    if (collision->geometry != nullptr) {
      link->collision_array.push_back(collision);
    }
  }
  if (!link->visual_array.empty()) {
    link->visual = link->visual_array.front();
  }
  if (!link->collision_array.empty()) {
    link->collision = link->collision_array.front();
  }
  return link;
}

/// Types that URDF does not have move freely, as sdformat_urdf has it.
void set_type(Joint& joint, const std::string& type) {
  joint.type = type == "revolute"     ? Joint::REVOLUTE
               : type == "continuous" ? Joint::CONTINUOUS
               : type == "prismatic"  ? Joint::PRISMATIC
               : type == "fixed"      ? Joint::FIXED
                                      : Joint::FLOATING;
}

void read_axis(const XmlDocument& xml, const Frames& frames, const XmlElement& axis, Joint& joint) {
  const std::string direction = text_of(xml.child(axis, "xyz"));
  const auto values = numbers(direction.empty() ? "0 0 1" : direction, 3, "axis");
  joint.axis = Vector3(values[0], values[1], values[2]);
  const XmlElement* xyz = xml.child(axis, "xyz");
  const std::string* seen_from = xyz == nullptr ? nullptr : xyz->attribute("expressed_in");
  if (seen_from != nullptr && !seen_from->empty()) {
    joint.axis =
        frames.of(joint.name).rotation.GetInverse() * (frames.of(*seen_from).rotation * joint.axis);
  }
  constexpr double kFar = 1e16;  // what SDF writes for "without end"
  auto limits = std::make_shared<JointLimits>();
  limits->lower = -kFar;
  limits->upper = kFar;
  if (const XmlElement* limit = xml.child(axis, "limit")) {
    limits->lower = number_of(xml.child(*limit, "lower"), -kFar, "lower limit");
    limits->upper = number_of(xml.child(*limit, "upper"), kFar, "upper limit");
    limits->effort = number_of(xml.child(*limit, "effort"), kFar, "effort limit");
    limits->velocity = number_of(xml.child(*limit, "velocity"), kFar, "velocity limit");
  }
  joint.limits = limits;
  if (joint.type == Joint::REVOLUTE && limits->lower <= -kFar && limits->upper >= kFar) {
    joint.type = Joint::CONTINUOUS;
  }
  if (const XmlElement* mimic = xml.child(axis, "mimic")) {
    joint.mimic = std::make_shared<JointMimic>();
    joint.mimic->joint_name = required(*mimic, "joint", "joint mimic");
    joint.mimic->multiplier = number_of(xml.child(*mimic, "multiplier"), 1, "mimic multiplier");
    joint.mimic->offset = number_of(xml.child(*mimic, "offset"), 0, "mimic offset");
  }
}

}  // namespace

void read_sdf(const XmlDocument& xml, ModelInterface& model) {
  const auto models = xml.children(xml.root(), "model");
  if (models.size() != 1) {
    throw ParseError("SDF needs one <model> for a robot, not " + std::to_string(models.size()));
  }
  const XmlElement& top = *models.front();
  model.name_ = required(top, "name", "Model");
  const Frames frames(xml, top);
  std::map<std::string, std::string> joints;  // by the link that hangs on them
  for (const XmlElement* one : xml.children(top, "joint")) {
    if (text_of(xml.child(*one, "parent")) == "world") {
      continue;  // the link stays a root
    }
    joints[text_of(xml.child(*one, "child"))] = required(*one, "name", "Joint");
  }
  const auto frame_of = [&](const std::string& link) {
    const auto joint = joints.find(link);
    return frames.of(joint == joints.end() ? link : joint->second);
  };
  for (const XmlElement* one : xml.children(top, "link")) {
    const std::string& name = required(*one, "name", "Link");
    model.links_.emplace(name, link_of(xml, frames, *one, frame_of(name)));
  }
  if (model.links_.empty()) {
    throw ParseError("No link elements found in sdf file");
  }
  for (const XmlElement* one : xml.children(top, "joint")) {
    auto joint = std::make_shared<Joint>();
    joint->name = required(*one, "name", "Joint");
    joint->parent_link_name = text_of(xml.child(*one, "parent"));
    joint->child_link_name = text_of(xml.child(*one, "child"));
    if (joint->parent_link_name == "world") {
      continue;
    }
    set_type(*joint, required(*one, "type", "Joint " + joint->name));
    joint->parent_to_joint_origin_transform =
        inverse(frame_of(joint->parent_link_name)) * frames.of(joint->name);
    const XmlElement* axis = xml.child(*one, "axis");
    if (axis != nullptr && joint->type != Joint::FIXED && joint->type != Joint::FLOATING) {
      read_axis(xml, frames, *axis, *joint);
    }
    model.joints_.emplace(joint->name, joint);
  }
}

}  // namespace urdf
