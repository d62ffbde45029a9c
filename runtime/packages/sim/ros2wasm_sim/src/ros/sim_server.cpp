// See sim_server.hpp.
#include "ros/sim_server.hpp"

#include <utility>

#include "plugins/gz_topics.hpp"
#include "plugins/messages.hpp"
#include "ros/resources.hpp"

namespace ros2wasm_sim {

SimServer::SimServer(Host& host, Simulation& simulation, const SimOptions& options)
    : host_(host),
      simulation_(simulation),
      runner_(host.node(), simulation, [this] { publish_clock(); }) {
  report_warnings(host_.node()->get_logger(), simulation_.physics());
  simulation_.begin_at(static_cast<std::int64_t>(options.initial_time * 1e9));
  runner_.pause(!options.runs);
  runner_.end_after(options.steps);
  const std::string world = "/world/" + simulation_.world().name;
  clock_ = publish_gz<rosgraph_msgs::msg::Clock>(host_, "/clock");
  world_clock_ = publish_gz<rosgraph_msgs::msg::Clock>(host_, world + "/clock");
  const auto offer = [&](const std::string& name, auto type, auto answer) {
    using Service = decltype(type);
    for (const char* ending : {"", "/blocking"})
      services_.push_back(host_.node()->create_service<Service>(
          hidden_name(world + name + ending),
          [answer](const typename Service::Request::SharedPtr& request,
                   const typename Service::Response::SharedPtr& response) {
            response->success = answer(*request);
          }));
  };
  offer("/create", ros_gz_interfaces::srv::SpawnEntity(),
        [this](const auto& request) { return create(request.entity_factory); });
  offer("/remove", ros_gz_interfaces::srv::DeleteEntity(),
        [this](const auto& request) { return remove(request.entity); });
  offer("/set_pose", ros_gz_interfaces::srv::SetEntityPose(), [this](const auto& request) {
    return simulation_.physics().set_model_pose(request.entity.name, pose_of(request.pose), true);
  });
  offer("/control", ros_gz_interfaces::srv::ControlWorld(), [this](const auto& request) {
    control(request.world_control);
    return true;
  });
  name_ = host_.node()->create_publisher<std_msgs::msg::String>(kWorldName,
                                                                rclcpp::QoS(1).transient_local());
  std_msgs::msg::String name;
  name.data = simulation_.world().name;
  name_->publish(name);
  if (!options.runs)
    RCLCPP_INFO(host_.node()->get_logger(),
                "the world [%s] is paused: `-r` in its arguments lets it run at once",
                simulation_.world().name.c_str());
}

void SimServer::publish_clock() {
  rosgraph_msgs::msg::Clock message;
  message.clock = stamp_of(simulation_.time_ns());
  for (const auto& publisher : {clock_, world_clock_})
    if (publisher->get_subscription_count() > 0) publisher->publish(message);
}

bool SimServer::create(const ros_gz_interfaces::msg::EntityFactory& factory) {
  const rclcpp::Logger logger = host_.node()->get_logger();
  std::string text = factory.sdf, file;
  if (text.empty() && !factory.sdf_filename.empty()) {
    std::vector<std::string> searched;
    const Resources resources = site_resources();
    const auto found = resources.find(factory.sdf_filename, searched);
    const auto read = found ? resources.read(*found) : std::nullopt;
    if (!read) {
      RCLCPP_ERROR(logger, "the model [%s] is not found (searched: %s)",
                   factory.sdf_filename.c_str(), listed(searched).c_str());
      return false;
    }
    text = *read;
    file = *found;
  }
  std::string error;
  auto model = load_model(logger, text, file, error);
  if (!model) return false;
  const std::string wanted = factory.name.empty() ? model->name : factory.name;
  std::string name = wanted;
  if (simulation_.model(name) != nullptr && !factory.allow_renaming) {
    RCLCPP_WARN(
        logger,
        "Entity named [%s] already exists and [allow_renaming] is false. Entity not spawned.",
        name.c_str());
    return false;
  }
  for (int i = 0; simulation_.model(name) != nullptr; ++i) name = wanted + "_" + std::to_string(i);
  model->name = name;
  model->pose = pose_of(factory.pose);  // in place of the model's own
  try {
    simulation_.add(std::move(*model));
  } catch (const PhysicsError& problem) {
    RCLCPP_ERROR(logger, "the model [%s] cannot be simulated: %s", name.c_str(), problem.what());
    return false;
  }
  report_warnings(logger, simulation_.physics());
  return true;
}

bool SimServer::remove(const ros_gz_interfaces::msg::Entity& entity) {
  if (simulation_.remove(entity.name)) return true;
  RCLCPP_ERROR(host_.node()->get_logger(),
               "Entity named [%s] of type [%d] not found, so not removed.", entity.name.c_str(),
               static_cast<int>(entity.type));
  return false;
}

void SimServer::control(const ros_gz_interfaces::msg::WorldControl& control) {
  if (control.reset.all || control.reset.model_only) simulation_.reset_poses();
  if (control.reset.all || control.reset.time_only) simulation_.reset_time();
  runner_.pause(control.pause);
  if (control.multi_step > 0)
    runner_.step(control.multi_step);
  else if (control.step)
    runner_.step(1);
}

}  // namespace ros2wasm_sim
