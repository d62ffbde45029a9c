// libgazebo_ros_properties.so, of a world: what models, joints, links and lights are made of.
#include <gazebo_msgs/srv/get_joint_properties.hpp>
#include <gazebo_msgs/srv/get_light_properties.hpp>
#include <gazebo_msgs/srv/get_link_properties.hpp>
#include <gazebo_msgs/srv/get_model_properties.hpp>
#include <gazebo_msgs/srv/set_joint_properties.hpp>
#include <gazebo_msgs/srv/set_light_properties.hpp>
#include <gazebo_msgs/srv/set_link_properties.hpp>

#include <algorithm>

#include "plugins/messages.hpp"
#include "plugins/plugin.hpp"
#include "ros/classic_entities.hpp"

namespace ros2wasm_sim {
namespace {

using namespace gazebo_msgs::srv;

std::uint8_t joint_type(const Joint& joint) {
  using Type = GetJointProperties::Response;
  switch (joint.type) {
    case JointType::kFixed:
      return Type::FIXED;
    case JointType::kRevolute:
      return std::isinf(joint.axes.front().lower) ? Type::CONTINUOUS : Type::REVOLUTE;
    case JointType::kPrismatic:
      return Type::PRISMATIC;
    case JointType::kBall:
      return Type::BALL;
    case JointType::kUniversal:
    case JointType::kRevolute2:
    case JointType::kScrew:
      return Type::UNIVERSAL;
  }
  return Type::UNIVERSAL;
}

class ClassicProperties final : public System {
 public:
  explicit ClassicProperties(const PluginContext& context)
      : simulation_(context.simulation), node_(context.host, context.plugin) {
    offer<GetModelProperties>("get_model_properties");
    offer<GetJointProperties>("get_joint_properties");
    offer<GetLinkProperties>("get_link_properties");
    offer<GetLightProperties>("get_light_properties");
    offer<SetJointProperties>("set_joint_properties");
    offer<SetLinkProperties>("set_link_properties");
    offer<SetLightProperties>("set_light_properties");
  }

 private:
  template <typename Service>
  void offer(const char* name) {
    services_.push_back(node_->create_service<Service>(
        name, [this](const typename Service::Request::SharedPtr& request,
                     const typename Service::Response::SharedPtr& response) {
          response->status_message = answer(*request, *response);
          response->success = response->status_message.empty();
          if (response->success) response->status_message = "got properties";
        }));
  }

  // Each answer is the reason of a failure, or empty.

  std::string answer(const GetModelProperties::Request& request,
                     GetModelProperties::Response& response) {
    const Model* model = simulation_.model(request.model_name);
    if (model == nullptr)
      return "GetModelProperties: model [" + request.model_name + "] does not exist";
    response.canonical_body_name = canonical_link(*model);
    response.is_static = model->is_static;
    for (const Link& link : model->links) {
      response.body_names.push_back(link.name);
      for (const Collision& shape : link.collisions) response.geom_names.push_back(shape.name);
    }
    for (const Joint& joint : model->joints) response.joint_names.push_back(joint.name);
    return {};
  }

  std::string answer(const GetJointProperties::Request& request,
                     GetJointProperties::Response& response) {
    const auto [model, joint] = find_joint(request.joint_name);
    if (joint == nullptr) return "GetJointProperties: joint [" + request.joint_name + "] not found";
    const JointHandle handle = simulation_.physics().joint(*model, joint->name);
    response.type = joint_type(*joint);
    for (const JointAxis& axis : joint->axes) response.damping.push_back(axis.damping);
    response.position.push_back(simulation_.physics().position(handle));
    response.rate.push_back(simulation_.physics().velocity(handle));
    return {};
  }

  std::string answer(const GetLinkProperties::Request& request,
                     GetLinkProperties::Response& response) {
    const Link* link = find_link(request.link_name);
    if (link == nullptr) return "GetLinkProperties: link [" + request.link_name + "] not found";
    response.com = pose_message(link->inertial.pose);
    response.gravity_mode = link->gravity;
    response.mass = link->inertial.mass;
    response.ixx = link->inertial.ixx;
    response.ixy = link->inertial.ixy;
    response.ixz = link->inertial.ixz;
    response.iyy = link->inertial.iyy;
    response.iyz = link->inertial.iyz;
    response.izz = link->inertial.izz;
    return {};
  }

  std::string answer(const GetLightProperties::Request& request,
                     GetLightProperties::Response& response) {
    for (const Light& light : simulation_.world().lights) {
      if (light.name != request.light_name) continue;
      response.diffuse.r = static_cast<float>(light.diffuse.r);
      response.diffuse.g = static_cast<float>(light.diffuse.g);
      response.diffuse.b = static_cast<float>(light.diffuse.b);
      response.diffuse.a = static_cast<float>(light.diffuse.a);
      response.attenuation_constant = 1;  // lights do not fade here
      return {};
    }
    return "Requested light " + request.light_name + " not found!";
  }

  std::string answer(const SetJointProperties::Request& request, SetJointProperties::Response&) {
    const auto& wanted = request.ode_joint_config;
    const auto [model, joint] = find_joint(request.joint_name);
    if (joint == nullptr) return "SetJointProperties: joint [" + request.joint_name + "] not found";
    const std::string name = joint->name;
    return change(*model, [&](Model& changed) {
      for (Joint& one : changed.joints) {
        if (one.name != name) continue;
        for (std::size_t i = 0; i < one.axes.size(); ++i) {
          JointAxis& axis = one.axes[i];
          if (i < wanted.damping.size()) axis.damping = wanted.damping[i];
          if (i < wanted.lo_stop.size()) axis.lower = wanted.lo_stop[i];
          if (i < wanted.hi_stop.size()) axis.upper = wanted.hi_stop[i];
          if (i < wanted.fmax.size()) axis.effort = wanted.fmax[i];
          if (i < wanted.vel.size()) axis.velocity = wanted.vel[i];
        }
      }
    });
  }

  std::string answer(const SetLinkProperties::Request& request, SetLinkProperties::Response&) {
    const Link* link = find_link(request.link_name);
    if (link == nullptr) return "SetLinkProperties: link [" + request.link_name + "] not found";
    if (!(request.mass > 0)) return "SetLinkProperties: the mass must be positive";
    const std::string name = link->name;
    return change(request.link_name.substr(0, request.link_name.find("::")), [&](Model& changed) {
      for (Link& one : changed.links) {
        if (one.name != name) continue;
        one.gravity = request.gravity_mode;
        one.inertial = {request.mass, pose_of(request.com), request.ixx, request.iyy,
                        request.izz,  request.ixy,          request.ixz, request.iyz};
      }
    });
  }

  std::string answer(const SetLightProperties::Request& request, SetLightProperties::Response&) {
    const Color color{request.diffuse.r, request.diffuse.g, request.diffuse.b, request.diffuse.a};
    return simulation_.set_light_color(request.light_name, color)
               ? std::string()
               : "Requested light " + request.light_name + " not found!";
  }

  template <typename Change>
  std::string change(const std::string& model, const Change& change) {
    try {
      simulation_.change(model, change);
      return {};
    } catch (const PhysicsError& error) {
      return error.what();
    }
  }

  /// Searches all models, as upstream does; a name may be `model::joint`.
  std::pair<const std::string*, const Joint*> find_joint(const std::string& name) const {
    for (const Model& model : simulation_.world().models)
      for (const Joint& joint : model.joints)
        if (joint.name == name || model.name + "::" + joint.name == name)
          return {&model.name, &joint};
    return {nullptr, nullptr};
  }

  const Link* find_link(const std::string& name) const {
    const std::size_t colons = name.find("::");
    if (colons == std::string::npos) return nullptr;
    const Model* model = simulation_.model(name.substr(0, colons));
    if (model == nullptr) return nullptr;
    for (const Link& link : model->links)
      if (link.name == name.substr(colons + 2)) return &link;
    return nullptr;
  }

  Simulation& simulation_;
  PluginNode node_;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
};

}  // namespace

std::unique_ptr<System> make_classic_properties(const PluginContext& context) {
  return std::make_unique<ClassicProperties>(context);
}

}  // namespace ros2wasm_sim
