// See classic_server.hpp.
#include "ros/classic_server.hpp"

#include <algorithm>
#include <utility>

#include "plugins/messages.hpp"
#include "ros/classic_entities.hpp"
#include "ros/classic_forces.hpp"
#include "ros/spawn.hpp"

namespace ros2wasm_sim {
namespace {

using std_srvs::srv::Empty;

}  // namespace

ClassicServer::ClassicServer(Host& host, Simulation& simulation, const ClassicOptions& options)
    : host_(host),
      simulation_(simulation),
      runner_(host.node(), simulation, [this] { after_step(); }),
      world_services_(host, simulation, runner_, [this] { restart_clock(); }),
      scene_(host, simulation, runner_),
      last_site_time_(site_clock_.now()) {
  report_warnings(host_.node()->get_logger(), simulation_.physics());
  simulation_.begin_at(static_cast<std::int64_t>(options.initial_time * 1e9));
  runner_.pause(options.paused);
  if (options.init) offer_clock();
  if (options.factory) offer_factory();
  if (options.forces) simulation_.add(std::make_unique<ClassicForces>(*host_.node(), simulation_));
}

void ClassicServer::offer_clock() {
  rclcpp::Node& node = *host_.node();
  clock_rate_ = Rate(node.declare_parameter("publish_rate", 10.0));
  clock_ = node.create_publisher<rosgraph_msgs::msg::Clock>("/clock", rclcpp::ClockQoS());
  if (node.declare_parameter("enable_performance_metrics", true))
    metrics_ = node.create_publisher<gazebo_msgs::msg::PerformanceMetrics>("/performance_metrics",
                                                                           rclcpp::QoS(10));
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
    restart_clock();
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

void ClassicServer::after_step() {
  publish_clock();
  if (metrics_ != nullptr && metrics_rate_.due(simulation_.time_ns())) publish_metrics();
}

/// The rates of sensors are those that they are asked for, as they keep them in simulated time.
void ClassicServer::publish_metrics() {
  const rclcpp::Time now = site_clock_.now();
  const double passed = (now - last_site_time_).seconds();
  const double simulated = static_cast<double>(simulation_.time_ns() - last_metrics_ns_) * 1e-9;
  last_site_time_ = now;
  last_metrics_ns_ = simulation_.time_ns();
  if (metrics_->get_subscription_count() == 0) return;
  gazebo_msgs::msg::PerformanceMetrics message;
  message.header.stamp = stamp_of(simulation_.time_ns());
  message.real_time_factor = passed > 0 && simulated >= 0 ? simulated / passed : 0;
  for (const Model& model : simulation_.world().models)
    for (const Link& link : model.links)
      for (const Sensor& sensor : link.sensors) {
        gazebo_msgs::msg::SensorPerformanceMetric one;
        one.name =
            simulation_.world().name + "::" + model.name + "::" + link.name + "::" + sensor.name;
        one.sim_update_rate =
            sensor.update_rate > 0 ? sensor.update_rate : 1e9 / simulation_.step_ns();
        one.real_update_rate = one.sim_update_rate * message.real_time_factor;
        const bool is_camera =
            sensor.type.find("camera") != std::string::npos || sensor.type == "depth";
        one.fps = is_camera ? one.real_update_rate : -1;
        message.sensors.push_back(one);
      }
  metrics_->publish(message);
}

void ClassicServer::restart_clock() {
  clock_rate_.reset();
  metrics_rate_.reset();
  last_metrics_ns_ = 0;
  publish_clock();
}

void ClassicServer::publish_clock() {
  if (clock_ == nullptr || !clock_rate_.due(simulation_.time_ns())) return;
  rosgraph_msgs::msg::Clock message;
  message.clock = stamp_of(simulation_.time_ns());
  clock_->publish(message);
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
  Motion unused;
  if (!find_entity(simulation_, request.reference_frame, reference, unused))
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
  set_namespace(*model, request.robot_namespace);
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
