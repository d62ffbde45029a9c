// See elements.hpp.
#include "elements.hpp"

#include <cmath>
#include <memory>

namespace urdf {
namespace {

double number(const std::string& text, const std::string& what) {
  try {
    return strToDouble(text.c_str());
  } catch (const std::runtime_error&) {
    throw ParseError(what + " value (" + text + ") is not a valid float");
  }
}
double number_of(const XmlElement& element, const std::string& key, const std::string& what) {
  return number(required(element, key, what), what + " " + key);
}
double number_or(const XmlElement& element, const std::string& key, double alternative,
                 const std::string& what) {
  const std::string* text = element.attribute(key);
  return text == nullptr ? alternative : number(*text, what + " " + key);
}

Pose pose_of(const XmlDocument& xml, const XmlElement& parent) {
  Pose pose;
  if (const XmlElement* origin = xml.child(parent, "origin")) {
    if (const std::string* xyz = origin->attribute("xyz")) {
      pose.position.init(*xyz);
    }
    if (const std::string* rpy = origin->attribute("rpy")) {
      pose.rotation.init(*rpy);
    }
  }
  return pose;
}

InertialSharedPtr inertial_of(const XmlDocument& xml, const XmlElement& element) {
  auto inertial = std::make_shared<Inertial>();
  inertial->origin = pose_of(xml, element);
  const XmlElement* mass = xml.child(element, "mass");
  const XmlElement* inertia = xml.child(element, "inertia");
  if (mass == nullptr || inertia == nullptr) {
    throw ParseError(std::string("Inertial element must have a ") +
                     (mass == nullptr ? "mass" : "inertia") + " element");
  }
  inertial->mass = number_of(*mass, "value", "Inertial: mass");
  const std::string what = "Inertial: inertia";
  inertial->ixx = number_of(*inertia, "ixx", what);
  inertial->ixy = number_of(*inertia, "ixy", what);
  inertial->ixz = number_of(*inertia, "ixz", what);
  inertial->iyy = number_of(*inertia, "iyy", what);
  inertial->iyz = number_of(*inertia, "iyz", what);
  inertial->izz = number_of(*inertia, "izz", what);
  return inertial;
}

GeometrySharedPtr geometry_of(const XmlDocument& xml, const XmlElement& parent) {
  const XmlElement* geometry = xml.child(parent, "geometry");
  if (geometry == nullptr || geometry->children.empty()) {
    throw ParseError("Geometry tag contains no child element.");
  }
  const XmlElement& shape = *xml.children(*geometry).front();
  if (shape.name == "sphere") {
    auto sphere = std::make_shared<Sphere>();
    sphere->radius = number_of(shape, "radius", "Sphere shape");
    return sphere;
  }
  if (shape.name == "box") {
    auto box = std::make_shared<Box>();
    box->dim.init(required(shape, "size", "Box shape"));
    return box;
  }
  if (shape.name == "cylinder") {
    auto cylinder = std::make_shared<Cylinder>();
    cylinder->radius = number_of(shape, "radius", "Cylinder shape");
    cylinder->length = number_of(shape, "length", "Cylinder shape");
    return cylinder;
  }
  if (shape.name == "mesh") {
    auto mesh = std::make_shared<Mesh>();
    mesh->filename = required(shape, "filename", "Mesh");
    if (const std::string* scale = shape.attribute("scale")) {
      mesh->scale.init(*scale);
    }
    return mesh;
  }
  throw ParseError("Unknown geometry type '" + shape.name + "'");
}

template <typename T>
std::shared_ptr<T> shape_of(const XmlDocument& xml, const XmlElement& element) {
  auto result = std::make_shared<T>();
  result->origin = pose_of(xml, element);
  result->geometry = geometry_of(xml, element);
  if (const std::string* name = element.attribute("name")) {
    result->name = *name;
  }
  return result;
}

JointLimitsSharedPtr limits_of(const XmlElement& element) {
  auto limits = std::make_shared<JointLimits>();
  limits->lower = number_or(element, "lower", 0, "joint limit");
  limits->upper = number_or(element, "upper", 0, "joint limit");
  limits->effort = number_of(element, "effort", "joint limit");
  limits->velocity = number_of(element, "velocity", "joint limit");
  return limits;
}

JointSafetySharedPtr safety_of(const XmlElement& element) {
  auto safety = std::make_shared<JointSafety>();
  const std::string what = "safety_controller";
  safety->soft_lower_limit = number_or(element, "soft_lower_limit", 0, what);
  safety->soft_upper_limit = number_or(element, "soft_upper_limit", 0, what);
  safety->k_position = number_or(element, "k_position", 0, what);
  safety->k_velocity = number_of(element, "k_velocity", what);
  return safety;
}

JointCalibrationSharedPtr calibration_of(const XmlElement& element) {
  auto calibration = std::make_shared<JointCalibration>();
  const std::string what = "calibration";
  if (element.attribute("rising") != nullptr) {
    calibration->rising = std::make_shared<double>(number_of(element, "rising", what));
  }
  if (element.attribute("falling") != nullptr) {
    calibration->falling = std::make_shared<double>(number_of(element, "falling", what));
  }
  return calibration;
}

JointMimicSharedPtr mimic_of(const XmlElement& element) {
  auto mimic = std::make_shared<JointMimic>();
  mimic->joint_name = required(element, "joint", "joint mimic");
  mimic->multiplier = number_or(element, "multiplier", 1, "joint mimic");
  mimic->offset = number_or(element, "offset", 0, "joint mimic");
  return mimic;
}

JointDynamicsSharedPtr dynamics_of(const XmlElement& element) {
  if (element.attribute("damping") == nullptr && element.attribute("friction") == nullptr) {
    throw ParseError("joint dynamics element specified with no damping and no friction");
  }
  auto dynamics = std::make_shared<JointDynamics>();
  dynamics->damping = number_or(element, "damping", 0, "joint dynamics");
  dynamics->friction = number_or(element, "friction", 0, "joint dynamics");
  return dynamics;
}

void set_type(Joint& joint, const XmlElement& element) {
  static const std::pair<const char*, decltype(Joint::type)> kTypes[] = {
      {"planar", Joint::PLANAR},       {"floating", Joint::FLOATING},
      {"revolute", Joint::REVOLUTE},   {"continuous", Joint::CONTINUOUS},
      {"prismatic", Joint::PRISMATIC}, {"fixed", Joint::FIXED},
  };
  const std::string* type = element.attribute("type");
  if (type == nullptr) {
    throw ParseError("joint " + joint.name + " has no type, check to see if it's a reference.");
  }
  for (const auto& [name, value] : kTypes) {
    if (*type == name) {
      joint.type = value;
      return;
    }
  }
  throw ParseError("Joint " + joint.name + " has no known type " + *type);
}

}  // namespace

const std::string& required(const XmlElement& element, const std::string& key,
                            const std::string& what) {
  const std::string* value = element.attribute(key);
  if (value == nullptr) {
    throw ParseError(what + " has no " + key + " attribute");
  }
  return *value;
}

MaterialSharedPtr material_of(const XmlDocument& xml, const XmlElement& element, bool may_be_name) {
  auto material = std::make_shared<Material>();
  material->name = required(element, "name", "Material");
  const XmlElement* texture = xml.child(element, "texture");
  const std::string* filename = texture == nullptr ? nullptr : texture->attribute("filename");
  if (filename != nullptr) {
    material->texture_filename = *filename;
  }
  const XmlElement* color = xml.child(element, "color");
  const std::string* rgba = color == nullptr ? nullptr : color->attribute("rgba");
  if (rgba != nullptr && !material->color.init(*rgba)) {
    throw ParseError("Material " + material->name + " has malformed color rgba values");
  }
  if (rgba == nullptr && filename == nullptr) {
    if (!may_be_name) {
      throw ParseError("Material " + material->name + " has neither a color nor a texture");
    }
    return nullptr;
  }
  return material;
}

LinkSharedPtr link_of(const XmlDocument& xml, const XmlElement& element) {
  auto link = std::make_shared<Link>();
  link->name = required(element, "name", "Link");
  if (const XmlElement* inertial = xml.child(element, "inertial")) {
    link->inertial = inertial_of(xml, *inertial);
  }
  for (const XmlElement* one : xml.children(element, "visual")) {
    auto visual = shape_of<Visual>(xml, *one);
    if (const XmlElement* material = xml.child(*one, "material")) {
      visual->material_name = required(*material, "name", "Visual material");
      visual->material = material_of(xml, *material, true);
    }
    link->visual_array.push_back(visual);
  }
  for (const XmlElement* one : xml.children(element, "collision")) {
    link->collision_array.push_back(shape_of<Collision>(xml, *one));
  }
  if (!link->visual_array.empty()) {
    link->visual = link->visual_array.front();
  }
  if (!link->collision_array.empty()) {
    link->collision = link->collision_array.front();
  }
  return link;
}

JointSharedPtr joint_of(const XmlDocument& xml, const XmlElement& element) {
  auto joint = std::make_shared<Joint>();
  joint->name = required(element, "name", "Joint");
  joint->parent_to_joint_origin_transform = pose_of(xml, element);
  for (const auto& [tag, into] : {std::make_pair("parent", &joint->parent_link_name),
                                  std::make_pair("child", &joint->child_link_name)}) {
    const XmlElement* link = xml.child(element, tag);
    const std::string* name = link == nullptr ? nullptr : link->attribute("link");
    if (name != nullptr) {
      *into = *name;
    }
  }
  set_type(*joint, element);
  if (joint->type != Joint::FLOATING && joint->type != Joint::FIXED) {
    const XmlElement* axis = xml.child(element, "axis");
    joint->axis = Vector3(1, 0, 0);
    if (axis != nullptr && axis->attribute("xyz") != nullptr) {
      joint->axis.init(*axis->attribute("xyz"));
    }
  }
  if (const XmlElement* limit = xml.child(element, "limit")) {
    joint->limits = limits_of(*limit);
  } else if (joint->type == Joint::REVOLUTE || joint->type == Joint::PRISMATIC) {
    throw ParseError("Joint " + joint->name + " is of type " +
                     (joint->type == Joint::REVOLUTE ? "REVOLUTE" : "PRISMATIC") +
                     " but it does not specify limits");
  }
  if (const XmlElement* safety = xml.child(element, "safety_controller")) {
    joint->safety = safety_of(*safety);
  }
  if (const XmlElement* calibration = xml.child(element, "calibration")) {
    joint->calibration = calibration_of(*calibration);
  }
  if (const XmlElement* mimic = xml.child(element, "mimic")) {
    joint->mimic = mimic_of(*mimic);
  }
  if (const XmlElement* dynamics = xml.child(element, "dynamics")) {
    joint->dynamics = dynamics_of(*dynamics);
  }
  return joint;
}

}  // namespace urdf
