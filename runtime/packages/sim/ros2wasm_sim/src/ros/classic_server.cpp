// See classic_server.hpp.
#include "ros/classic_server.hpp"

#include <algorithm>
#include <utility>

#include "plugins/messages.hpp"

namespace ros2wasm_sim {
namespace {

using std_srvs::srv::Empty;

bool is_world(const std::string& frame) {
  return frame.empty() || frame == "world" || frame == "map" || frame == "/map";
}

}  // namespace

ClassicServer::ClassicServer(Host& host, Simulation& simulation, const ClassicOptions& options)
    : host_(host),
      simulation_(simulation),
      runner_(host.node(), simulation, [this] { publish_clock(); }) {
  report_warnings(host_.node()->get_logger(), simulation_.physics());
  simulation_.begin_at(static_cast<std::int64_t>(options.initial_time * 1e9));
  runner_.pause(options.paused);
  if (options.init) offer_clock();
  if (options.factory) offer_factory();
  if (options.state) offer_state();
}

void ClassicServer::offer_clock() {
  rclcpp::Node& node = *host_.node();
  clock_rate_ = Rate(node.declare_parameter("publish_rate", 10.0));
  clock_ = node.create_publisher<rosgraph_msgs::msg::Clock>("/clock", rclcpp::ClockQoS());
  const auto offer = [&](const char* name, auto action) {
    services_.push_back(node.create_service<Empty>(
        name, [action](const Empty::Request::SharedPtr&, const Empty::Response::SharedPtr&) {
          action();
        }));
  };
  offer("/pause_physics", [this] { runner_.pause(true); });
  offer("/unpause_physics", [this] { runner_.pause(false); });
  offer("/reset_world", [this] { simulation_.reset_poses(); });
  offer("/reset_simulation", [this] {
    simulation_.reset_poses();
    simulation_.reset_time();
    clock_rate_.reset();
    publish_clock();
  });
}

void ClassicServer::offer_factory() {
  rclcpp::Node& node = *host_.node();
  using gazebo_msgs::srv::DeleteEntity;
  using gazebo_msgs::srv::GetModelList;
  using gazebo_msgs::srv::SpawnEntity;
  services_.push_back(node.create_service<SpawnEntity>(
      "/spawn_entity",
      [this](const SpawnEntity::Request::SharedPtr& request,
             const SpawnEntity::Response::SharedPtr& response) { spawn(*request, *response); }));
  services_.push_back(node.create_service<DeleteEntity>(
      "/delete_entity", [this](const DeleteEntity::Request::SharedPtr& request,
                               const DeleteEntity::Response::SharedPtr& response) {
        response->success = simulation_.remove(request->name);
        response->status_message = response->success
                                       ? "Successfully deleted entity [" + request->name + "]"
                                       : "Entity [" + request->name + "] does not exist";
      }));
  services_.push_back(node.create_service<GetModelList>(
      "/get_model_list", [this](const GetModelList::Request::SharedPtr&,
                                const GetModelList::Response::SharedPtr& response) {
        response->header.stamp = stamp_of(simulation_.time_ns());
        for (const Model& model : simulation_.world().models)
          response->model_names.push_back(model.name);
        response->success = true;
      }));
}

void ClassicServer::offer_state() {
  rclcpp::Node& node = *host_.node();
  using gazebo_msgs::srv::GetEntityState;
  using gazebo_msgs::srv::SetEntityState;
  services_.push_back(node.create_service<GetEntityState>(
      "get_entity_state", [this](const GetEntityState::Request::SharedPtr& request,
                                 const GetEntityState::Response::SharedPtr& response) {
        Pose pose, reference;
        response->success =
            frame_pose(request->name, pose) && frame_pose(request->reference_frame, reference);
        if (!response->success) {
          RCLCPP_ERROR(host_.node()->get_logger(), "GetEntityState: entity [%s] does not exist",
                       request->name.c_str());
          return;
        }
        response->header.stamp = stamp_of(simulation_.time_ns());
        response->header.frame_id = request->reference_frame;
        response->state.name = request->name;
        response->state.pose = pose_message(inverse(reference) * pose);
      }));
  services_.push_back(node.create_service<SetEntityState>(
      "set_entity_state", [this](const SetEntityState::Request::SharedPtr& request,
                                 const SetEntityState::Response::SharedPtr& response) {
        Pose reference;
        const auto& state = request->state;
        response->success =
            frame_pose(state.reference_frame, reference) &&
            simulation_.physics().set_model_pose(state.name, reference * pose_of(state.pose), true);
        if (!response->success) {
          RCLCPP_ERROR(host_.node()->get_logger(), "SetEntityState: entity [%s] does not exist",
                       state.name.c_str());
          return;
        }
        const auto& linear = state.twist.linear;
        const auto& angular = state.twist.angular;
        simulation_.physics().set_model_velocity(
            state.name, {{linear.x, linear.y, linear.z}, {angular.x, angular.y, angular.z}});
      }));
}

void ClassicServer::publish_clock() {
  if (clock_ == nullptr || !clock_rate_.due(simulation_.time_ns())) return;
  rosgraph_msgs::msg::Clock message;
  message.clock = stamp_of(simulation_.time_ns());
  clock_->publish(message);
}

bool ClassicServer::frame_pose(const std::string& frame, Pose& pose) {
  if (is_world(frame)) return true;
  if (const Model* model = simulation_.model(frame)) {
    pose = simulation_.model_pose(*model);
    return true;
  }
  const std::size_t colons = frame.find("::");
  if (colons == std::string::npos) return false;
  const LinkHandle link =
      simulation_.physics().link(frame.substr(0, colons), frame.substr(colons + 2));
  pose = simulation_.physics().pose(link);
  return link.valid();
}

void ClassicServer::spawn(const gazebo_msgs::srv::SpawnEntity::Request& request,
                          gazebo_msgs::srv::SpawnEntity::Response& response) {
  const auto fail = [&](std::string text) {
    response.success = false;
    response.status_message = std::move(text);
  };
  std::string name = request.name;
  if (!name.empty() && simulation_.model(name) != nullptr)
    return fail("Entity [" + name + "] already exists.");
  Pose reference;
  if (!frame_pose(request.reference_frame, reference))
    return fail("Reference frame [" + request.reference_frame +
                "] not found, cannot spawn entity.");
  std::string error;
  auto model = load_model(host_.node()->get_logger(), request.xml, "", error);
  if (!model) return fail("Failed to parse XML string: " + error);
  if (name.empty()) {
    name = model->name;
    for (int i = 0; simulation_.model(name) != nullptr; ++i)
      name = model->name + "_" + std::to_string(i);
  }
  model->name = name;
  model->pose = reference * pose_of(request.initial_pose) * model->pose;
  for (Plugin& plugin : model->plugins) plugin.robot_namespace = request.robot_namespace;
  for (Link& link : model->links)
    for (Sensor& sensor : link.sensors)
      for (Plugin& plugin : sensor.plugins) plugin.robot_namespace = request.robot_namespace;
  try {
    simulation_.add(std::move(*model));
  } catch (const PhysicsError& problem) {
    return fail("Entity [" + name + "] cannot be simulated: " + problem.what());
  }
  report_warnings(host_.node()->get_logger(), simulation_.physics());
  response.success = true;
  response.status_message = "SpawnEntity: Successfully spawned entity [" + name + "]";
}

}  // namespace ros2wasm_sim
