// See classic_forces.hpp.
#include "ros/classic_forces.hpp"

#include <algorithm>

#include "ros/classic_entities.hpp"

namespace ros2wasm_sim {
namespace {

using gazebo_msgs::srv::ApplyJointEffort;
using gazebo_msgs::srv::ApplyLinkWrench;
using gazebo_msgs::srv::JointRequest;
using gazebo_msgs::srv::LinkRequest;

template <typename Force, typename IsGone>
std::size_t remove_forces(std::vector<Force>& forces, IsGone is_gone) {
  const auto end = std::remove_if(forces.begin(), forces.end(), is_gone);
  const auto count = static_cast<std::size_t>(forces.end() - end);
  forces.erase(end, forces.end());
  return count;
}

}  // namespace

ClassicForces::ClassicForces(rclcpp::Node& node, Simulation& simulation)
    : simulation_(simulation), logger_(node.get_logger()) {
  services_.push_back(node.create_service<ApplyLinkWrench>(
      "apply_link_wrench",
      [this](const ApplyLinkWrench::Request::SharedPtr& request,
             const ApplyLinkWrench::Response::SharedPtr& response) { push(*request, *response); }));
  services_.push_back(node.create_service<ApplyJointEffort>(
      "apply_joint_effort", [this](const ApplyJointEffort::Request::SharedPtr& request,
                                   const ApplyJointEffort::Response::SharedPtr& response) {
        drive(*request, *response);
      }));
  services_.push_back(node.create_service<LinkRequest>(
      "clear_link_wrenches", [this](const LinkRequest::Request::SharedPtr& request,
                                    const LinkRequest::Response::SharedPtr&) {
        if (remove_forces(links_, [&](const auto& one) { return one.name == request->link_name; }) >
            0)
          RCLCPP_INFO(logger_, "Deleted wrenches on [%s]", request->link_name.c_str());
        else
          RCLCPP_WARN(logger_, "No applied wrenches on [%s]", request->link_name.c_str());
      }));
  services_.push_back(node.create_service<JointRequest>(
      "clear_joint_efforts", [this](const JointRequest::Request::SharedPtr& request,
                                    const JointRequest::Response::SharedPtr&) {
        if (remove_forces(joints_,
                          [&](const auto& one) { return one.name == request->joint_name; }) > 0)
          RCLCPP_INFO(logger_, "Deleted efforts on [%s]", request->joint_name.c_str());
        else
          RCLCPP_WARN(logger_, "No applied efforts on [%s]", request->joint_name.c_str());
      }));
}

void ClassicForces::before_step(const Now& now) {
  Physics& physics = simulation_.physics();
  for (const LinkForce& one : links_)
    if (one.span.covers(now.time_ns))
      physics.add_wrench(one.link, one.force, one.torque, physics.centre_of_mass(one.link));
  for (const JointForce& one : joints_)
    if (one.span.covers(now.time_ns)) physics.add_effort(one.joint, one.effort);
  const auto is_over = [&](const auto& one) { return one.span.is_over(now.time_ns); };
  remove_forces(links_, is_over);
  remove_forces(joints_, is_over);
}

void ClassicForces::on_reset() {
  links_.clear();
  joints_.clear();
}

ClassicForces::Span ClassicForces::span_of(
    const builtin_interfaces::msg::Time& start,
    const builtin_interfaces::msg::Duration& duration) const {
  const std::int64_t wanted = start.sec * 1'000'000'000LL + start.nanosec;
  const std::int64_t length = duration.sec * 1'000'000'000LL + duration.nanosec;
  Span span;
  span.begin = std::max(wanted, simulation_.time_ns());
  span.end = span.begin + length;
  span.is_endless = length < 0;
  return span;
}

void ClassicForces::push(const ApplyLinkWrench::Request& request,
                         ApplyLinkWrench::Response& response) {
  const LinkHandle link = scoped_link(simulation_, request.link_name);
  if (!link.valid()) {
    response.status_message = "Link [" + request.link_name + "] does not exist";
    RCLCPP_ERROR(logger_, "ApplyLinkWrench: %s", response.status_message.c_str());
    return;
  }
  Pose frame;
  Motion unused;
  if (!find_entity(simulation_, request.reference_frame, frame, unused)) {
    response.status_message = "reference_frame [" + request.reference_frame +
                              "] not found, did you forget to scope the link by model name?";
    RCLCPP_ERROR(logger_, "ApplyLinkWrench: %s", response.status_message.c_str());
    return;
  }
  const auto& given = request.wrench;
  const Vector3 point{request.reference_point.x, request.reference_point.y,
                      request.reference_point.z};
  const Vector3 force = rotate(frame.orientation, {given.force.x, given.force.y, given.force.z});
  // The force itself acts at the centre of mass; its lever is the point in the frame, and where the
  // frame is from the link.
  Vector3 lever = rotate(frame.orientation, point);
  if (!is_world(request.reference_frame))
    lever = lever + frame.position - simulation_.physics().pose(link).position;
  const Vector3 torque =
      rotate(frame.orientation, {given.torque.x, given.torque.y, given.torque.z}) +
      cross(lever, force);
  links_.push_back(
      {request.link_name, link, force, torque, span_of(request.start_time, request.duration)});
  response.success = true;
}

void ClassicForces::drive(const ApplyJointEffort::Request& request,
                          ApplyJointEffort::Response& response) {
  const JointHandle joint = joint_named(request.joint_name);
  if (!joint.valid()) {
    response.status_message = "Joint [" + request.joint_name + "] not found";
    RCLCPP_ERROR(logger_, "ApplyJointEffort: %s", response.status_message.c_str());
    return;
  }
  joints_.push_back(
      {request.joint_name, joint, request.effort, span_of(request.start_time, request.duration)});
  response.success = true;
  response.status_message = "Effort on joint [" + request.joint_name + "] set";
}

JointHandle ClassicForces::joint_named(const std::string& name) {
  for (const Model& model : simulation_.world().models)
    for (const Joint& joint : model.joints)
      if (joint.name == name || model.name + "::" + joint.name == name)
        return simulation_.physics().joint(model.name, joint.name);
  return {};
}

}  // namespace ros2wasm_sim
