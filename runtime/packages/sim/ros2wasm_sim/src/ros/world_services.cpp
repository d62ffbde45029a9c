// See world_services.hpp.
#include "ros/world_services.hpp"

#include <utility>

#include "plugins/messages.hpp"
#include "ros/spawn.hpp"
#include "ros2wasm_sim/gz_names.hpp"

namespace ros2wasm_sim {

WorldServices::WorldServices(Host& host, Simulation& simulation, Runner& runner,
                             std::function<void()> after_reset)
    : host_(host), simulation_(simulation), runner_(runner), after_reset_(std::move(after_reset)) {
  offer<ros_gz_interfaces::srv::SpawnEntity>(
      "/create", [this](const auto& request) { return create(request.entity_factory); });
  offer<ros_gz_interfaces::srv::DeleteEntity>(
      "/remove", [this](const auto& request) { return remove(request.entity); });
  offer<ros_gz_interfaces::srv::SetEntityPose>("/set_pose", [this](const auto& request) {
    return simulation_.physics().set_model_pose(request.entity.name, pose_of(request.pose), true);
  });
  offer<ros_gz_interfaces::srv::ControlWorld>("/control", [this](const auto& request) {
    control(request.world_control);
    return true;
  });
}

template <typename Service, typename Answer>
void WorldServices::offer(const std::string& name, Answer answer) {
  for (const char* ending : {"", "/blocking"})
    services_.push_back(host_.node()->create_service<Service>(
        hidden_name("/world/" + simulation_.world().name + name + ending),
        [answer](const typename Service::Request::SharedPtr& request,
                 const typename Service::Response::SharedPtr& response) {
          response->success = answer(*request);
        }));
}

bool WorldServices::create(const ros_gz_interfaces::msg::EntityFactory& factory) {
  const Spawned spawned = spawn(host_, simulation_,
                                {.name = factory.name,
                                 .allow_renaming = factory.allow_renaming,
                                 .text = factory.sdf,
                                 .uri = factory.sdf_filename,
                                 .name_space = {},
                                 .pose = pose_of(factory.pose)});
  if (spawned.problem == SpawnProblem::kNone) return true;
  const rclcpp::Logger logger = host_.node()->get_logger();
  // Upstream warns only of a name that is taken.
  if (spawned.problem == SpawnProblem::kNameTaken)
    RCLCPP_WARN(logger, "%s", spawned.error.c_str());
  else if (spawned.problem != SpawnProblem::kUnreadable)  // what was read has been reported
    RCLCPP_ERROR(logger, "%s", spawned.error.c_str());
  return false;
}

bool WorldServices::remove(const ros_gz_interfaces::msg::Entity& entity) {
  if (simulation_.remove(entity.name)) return true;
  RCLCPP_ERROR(host_.node()->get_logger(),
               "Entity named [%s] of type [%d] not found, so not removed.", entity.name.c_str(),
               static_cast<int>(entity.type));
  return false;
}

void WorldServices::control(const ros_gz_interfaces::msg::WorldControl& control) {
  if (control.reset.all || control.reset.model_only) simulation_.reset_poses();
  if (control.reset.all || control.reset.time_only) {
    simulation_.reset_time();
    after_reset_();
  }
  runner_.pause(control.pause);
  if (control.multi_step > 0)
    runner_.step(control.multi_step);
  else if (control.step)
    runner_.step(1);
}

}  // namespace ros2wasm_sim
