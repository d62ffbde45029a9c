// See simulation_services.hpp.
#include "ros/simulation_services.hpp"

#include <regex.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <simulation_interfaces/srv/delete_entity.hpp>
#include <simulation_interfaces/srv/get_entities.hpp>
#include <simulation_interfaces/srv/get_entities_states.hpp>
#include <simulation_interfaces/srv/get_entity_info.hpp>
#include <simulation_interfaces/srv/get_entity_state.hpp>
#include <simulation_interfaces/srv/get_simulation_state.hpp>
#include <simulation_interfaces/srv/get_simulator_features.hpp>
#include <simulation_interfaces/srv/reset_simulation.hpp>
#include <simulation_interfaces/srv/set_entity_state.hpp>
#include <simulation_interfaces/srv/set_simulation_state.hpp>
#include <simulation_interfaces/srv/spawn_entities.hpp>
#include <simulation_interfaces/srv/spawn_entity.hpp>
#include <simulation_interfaces/srv/step_simulation.hpp>

#include "plugins/messages.hpp"
#include "ros/spawn.hpp"

namespace ros2wasm_sim {
namespace {

using simulation_interfaces::msg::EntityCategory;
using simulation_interfaces::msg::EntityFilters;
using simulation_interfaces::msg::EntityState;
using simulation_interfaces::msg::Result;
using simulation_interfaces::msg::SimulationState;
using simulation_interfaces::msg::SimulatorFeatures;
using simulation_interfaces::msg::SpawnResult;

constexpr const char* kWorldFrame = "world";

Result result(std::uint8_t code, std::string message = {}) {
  Result made;
  made.result = code;
  made.error_message = std::move(message);
  return made;
}

Result ok() {
  return result(Result::RESULT_OK);
}

Result not_found(const std::string& entity) {
  return result(Result::RESULT_NOT_FOUND, "Entity [" + entity + "] not found");
}

/// A POSIX extended regular expression.
class NamePattern {
 public:
  explicit NamePattern(const std::string& text)
      : is_valid_(regcomp(&compiled_, text.c_str(), REG_EXTENDED | REG_NOSUB) == 0) {}
  ~NamePattern() {
    if (is_valid_) regfree(&compiled_);
  }
  NamePattern(const NamePattern&) = delete;
  NamePattern& operator=(const NamePattern&) = delete;

  bool is_valid() const { return is_valid_; }
  bool matches(const std::string& name) const {
    return regexec(&compiled_, name.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_ = {};
  bool is_valid_;
};

std::uint8_t category_of(const Model& model) {
  return model.is_static ? EntityCategory::CATEGORY_STATIC_OBJECT : EntityCategory::CATEGORY_OBJECT;
}

bool has_category(const Model& model, const std::vector<EntityCategory>& wanted) {
  return wanted.empty() || std::any_of(wanted.begin(), wanted.end(), [&](const auto& one) {
           return one.category == category_of(model);
         });
}

bool is_world(const std::string& frame) {
  return frame.empty() || frame == kWorldFrame;
}

bool is_finite(const geometry_msgs::msg::Pose& pose) {
  const auto& p = pose.position;
  const auto& q = pose.orientation;
  for (const double value : {p.x, p.y, p.z, q.x, q.y, q.z, q.w})
    if (!std::isfinite(value)) return false;
  return true;
}

Vector3 vector_of(const geometry_msgs::msg::Vector3& v) {
  return {v.x, v.y, v.z};
}

std::uint8_t code_of(SpawnProblem problem) {
  switch (problem) {
    case SpawnProblem::kNotFound:
      return SpawnResult::NO_RESOURCE;
    case SpawnProblem::kUnreadable:
      return SpawnResult::RESOURCE_PARSE_ERROR;
    case SpawnProblem::kNameTaken:
      return SpawnResult::NAME_NOT_UNIQUE;
    case SpawnProblem::kNotSimulated:
      return Result::RESULT_OPERATION_FAILED;
    case SpawnProblem::kNone:
      break;
  }
  return Result::RESULT_OK;
}

}  // namespace

SimulationServices::SimulationServices(Host& host, Simulation& simulation, Runner& runner)
    : host_(host), simulation_(simulation), runner_(runner) {
  for (const Model& model : simulation_.world().models) original_.insert(model.name);
  offer_entities();
  offer_states();
  offer_spawning();
  offer_time();
  offer_steps();
}

template <typename Service, typename Answer>
void SimulationServices::offer(const std::string& name, Answer answer) {
  services_.push_back(host_.node()->create_service<Service>(
      name, [answer](const typename Service::Request::SharedPtr& request,
                     const typename Service::Response::SharedPtr& response) {
        answer(*request, *response);
      }));
}

Result SimulationServices::select(const EntityFilters& filters,
                                  std::vector<std::string>& names) const {
  if (!filters.tags.tags.empty())
    return result(Result::RESULT_FEATURE_UNSUPPORTED, "entities have no tags here");
  if (filters.bounds.type != simulation_interfaces::msg::Bounds::TYPE_EMPTY)
    return result(Result::RESULT_FEATURE_UNSUPPORTED, "entities are not filtered by bounds here");
  const NamePattern pattern(filters.filter);
  if (!pattern.is_valid())
    return result(Result::RESULT_OPERATION_FAILED,
                  "[" + filters.filter + "] is not a POSIX extended regular expression");
  for (const Model& model : simulation_.world().models)
    if (has_category(model, filters.categories) &&
        (filters.filter.empty() || pattern.matches(model.name)))
      names.push_back(model.name);
  return ok();
}

void SimulationServices::offer_entities() {
  using namespace simulation_interfaces::srv;
  offer<GetSimulatorFeatures>("get_simulator_features", [](const auto&, auto& response) {
    using F = SimulatorFeatures;
    response.features.features = {
        F::SPAWNING,
        F::DELETING,
        F::ENTITY_CATEGORIES,
        F::SPAWNING_RESOURCE_STRING,
        F::ENTITY_STATE_GETTING,
        F::ENTITY_STATE_SETTING,
        F::ENTITY_INFO_GETTING,
        F::SIMULATION_RESET,
        F::SIMULATION_RESET_TIME,
        F::SIMULATION_RESET_STATE,
        F::SIMULATION_RESET_SPAWNED,
        F::SIMULATION_STATE_GETTING,
        F::SIMULATION_STATE_SETTING,
        F::SIMULATION_STATE_PAUSE,
        F::STEP_SIMULATION_SINGLE,
        F::STEP_SIMULATION_MULTIPLE,
        F::STEP_SIMULATION_ACTION,
        F::SPAWNING_ENTITIES,
    };
    response.features.spawn_formats = {"sdf", "urdf"};
  });
  offer<GetEntities>("get_entities", [this](const auto& request, auto& response) {
    response.result = select(request.filters, response.entities);
  });
  offer<GetEntityInfo>("get_entity_info", [this](const auto& request, auto& response) {
    const Model* model = simulation_.model(request.entity);
    response.result = model == nullptr ? not_found(request.entity) : ok();
    if (model != nullptr) response.info.category.category = category_of(*model);
  });
}

EntityState SimulationServices::state_of(const Model& model) {
  EntityState state;
  state.header.frame_id = kWorldFrame;
  state.header.stamp = stamp_of(simulation_.time_ns());
  state.pose = pose_message(simulation_.model_pose(model));
  if (model.links.empty()) return state;
  Physics& physics = simulation_.physics();
  const Motion motion = physics.velocity(physics.link(model.name, model.links.front().name));
  state.twist.linear = vector_message(motion.linear);
  state.twist.angular = vector_message(motion.angular);
  return state;
}

Result SimulationServices::set_state(const std::string& entity, const EntityState& state,
                                     bool sets_pose, bool sets_twist) {
  using Response = simulation_interfaces::srv::SetEntityState::Response;
  const Model* model = simulation_.model(entity);
  if (model == nullptr) return not_found(entity);
  if (!is_world(state.header.frame_id))
    return result(Response::INVALID_POSE,
                  "the frame [" + state.header.frame_id + "] is not the world");
  if (sets_pose && !is_finite(state.pose))
    return result(Response::INVALID_POSE, "the pose is not finite");
  const Motion motion{vector_of(state.twist.linear), vector_of(state.twist.angular)};
  const double size = length(motion.linear) + length(motion.angular);
  if (sets_twist && !std::isfinite(size))
    return result(Result::RESULT_OPERATION_FAILED, "the twist is not finite");
  if (sets_twist && model->is_static && size > 0)
    return result(Result::RESULT_OPERATION_FAILED, "Entity [" + entity + "] is static");
  if (sets_pose) simulation_.physics().set_model_pose(entity, pose_of(state.pose), !sets_twist);
  if (sets_twist && !model->is_static) simulation_.physics().set_model_velocity(entity, motion);
  return ok();
}

void SimulationServices::offer_states() {
  using namespace simulation_interfaces::srv;
  offer<GetEntityState>("get_entity_state", [this](const auto& request, auto& response) {
    const Model* model = simulation_.model(request.entity);
    response.result = model == nullptr ? not_found(request.entity) : ok();
    if (model != nullptr) response.state = state_of(*model);
  });
  offer<GetEntitiesStates>("get_entities_states", [this](const auto& request, auto& response) {
    response.result = select(request.filters, response.entities);
    for (const std::string& name : response.entities)
      response.states.push_back(state_of(*simulation_.model(name)));
  });
  offer<SetEntityState>("set_entity_state", [this](const auto& request, auto& response) {
    response.result =
        request.set_acceleration
            ? result(Result::RESULT_FEATURE_UNSUPPORTED, "accelerations are not set here")
            : set_state(request.entity, request.state, request.set_pose, request.set_twist);
  });
}

template <typename Request>
SpawnResult SimulationServices::spawn_one(const Request& request) {
  SpawnResult made;
  const auto& stamped = request.initial_pose;
  if (!is_world(stamped.header.frame_id) || !is_finite(stamped.pose)) {
    made.result = result(SpawnResult::INVALID_POSE,
                         "the initial pose is not a finite one in the frame [world]");
    return made;
  }
  Spawned spawned = spawn(host_, simulation_,
                          {.name = request.name,
                           .allow_renaming = request.allow_renaming,
                           .text = request.entity_resource.resource_string,
                           .uri = request.entity_resource.uri,
                           .name_space = request.entity_namespace,
                           .pose = pose_of(stamped.pose)});
  made.result = result(code_of(spawned.problem), std::move(spawned.error));
  made.entity_name = std::move(spawned.name);
  return made;
}

void SimulationServices::offer_spawning() {
  using namespace simulation_interfaces::srv;
  offer<SpawnEntity>("spawn_entity", [this](const auto& request, auto& response) {
    SpawnResult made = spawn_one(request);
    response.result = std::move(made.result);
    response.entity_name = std::move(made.entity_name);
  });
  offer<SpawnEntities>("spawn_entities", [this](const auto& request, auto& response) {
    response.result = ok();
    for (const auto& one : request.spawn_requests) {
      response.results.push_back(spawn_one(one));
      if (response.results.back().result.result != Result::RESULT_OK)
        response.result = result(SpawnEntities::Response::ENTITIES_SPAWN_FAILED,
                                 "not all entities were spawned: the results say why");
    }
  });
  offer<DeleteEntity>("delete_entity", [this](const auto& request, auto& response) {
    response.result = simulation_.remove(request.entity) ? ok() : not_found(request.entity);
  });
}

Result SimulationServices::reset(std::uint8_t scope) {
  using Request = simulation_interfaces::srv::ResetSimulation::Request;
  if (scope == Request::SCOPE_DEFAULT) scope = Request::SCOPE_ALL;
  if ((scope & Request::SCOPE_SPAWNED) != 0) {
    std::vector<std::string> spawned;
    for (const Model& model : simulation_.world().models)
      if (original_.count(model.name) == 0) spawned.push_back(model.name);
    for (const std::string& name : spawned) simulation_.remove(name);
  }
  if ((scope & Request::SCOPE_STATE) != 0) simulation_.reset_poses();
  if ((scope & Request::SCOPE_TIME) != 0) simulation_.reset_time();
  return ok();
}

std::uint8_t SimulationServices::simulation_state() {
  if (!runner_.paused()) {
    stopped_ = false;  // somebody else has let it run
    return SimulationState::STATE_PLAYING;
  }
  return stopped_ ? SimulationState::STATE_STOPPED : SimulationState::STATE_PAUSED;
}

Result SimulationServices::set_simulation_state(std::uint8_t state) {
  using Response = simulation_interfaces::srv::SetSimulationState::Response;
  if (state == simulation_state())
    return result(Response::ALREADY_IN_TARGET_STATE, "the simulation is in that state");
  switch (state) {
    case SimulationState::STATE_PLAYING:
      stopped_ = false;
      runner_.drop_steps();
      runner_.pause(false);
      return ok();
    case SimulationState::STATE_PAUSED:
      if (stopped_)
        return result(Response::INCORRECT_TRANSITION, "a stopped simulation cannot be paused");
      runner_.pause(true);
      return ok();
    case SimulationState::STATE_STOPPED:
      runner_.drop_steps();
      runner_.pause(true);
      stopped_ = true;
      return reset(simulation_interfaces::srv::ResetSimulation::Request::SCOPE_ALL);
    case SimulationState::STATE_QUITTING:
      runner_.drop_steps();
      // The answer goes out before the node ends.
      runner_.step(0, [](const Runner::Progress&) {
        rclcpp::shutdown();
        return false;
      });
      return ok();
    default:
      return result(Response::INCORRECT_TRANSITION, "the simulation cannot be set to that state");
  }
}

void SimulationServices::offer_time() {
  using namespace simulation_interfaces::srv;
  offer<GetSimulationState>("get_simulation_state", [this](const auto&, auto& response) {
    response.state.state = simulation_state();
    response.result = ok();
  });
  offer<SetSimulationState>("set_simulation_state", [this](const auto& request, auto& response) {
    response.result = set_simulation_state(request.state.state);
  });
  offer<ResetSimulation>("reset_simulation", [this](const auto& request, auto& response) {
    response.result = reset(request.scope);
  });
}

void SimulationServices::offer_steps() {
  using simulation_interfaces::srv::StepSimulation;
  const auto not_paused = [] {
    return result(Result::RESULT_OPERATION_FAILED,
                  "the simulation is not paused: steps are made of a paused one");
  };
  services_.push_back(host_.node()->create_service<StepSimulation>(
      "step_simulation",
      [this, not_paused](const std::shared_ptr<rclcpp::Service<StepSimulation>>& service,
                         const std::shared_ptr<rmw_request_id_t>& header,
                         const StepSimulation::Request::SharedPtr& request) {
        const auto answer = [service, header](Result made) {
          StepSimulation::Response response;
          response.result = std::move(made);
          service->send_response(*header, response);
        };
        if (!runner_.paused()) return answer(not_paused());
        runner_.step(request->steps, [answer](const Runner::Progress& progress) {
          if (progress.failed)
            answer(result(Result::RESULT_OPERATION_FAILED, "the simulation makes no more steps"));
          else if (progress.left == 0)
            answer(ok());
          return true;
        });
      }));
  steps_ = rclcpp_action::create_server<SimulateSteps>(
      host_.node(), "simulate_steps",
      [](const rclcpp_action::GoalUUID&, const std::shared_ptr<const SimulateSteps::Goal>&) {
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [](const std::shared_ptr<StepsHandle>&) { return rclcpp_action::CancelResponse::ACCEPT; },
      [this, not_paused](const std::shared_ptr<StepsHandle>& goal) {
        if (runner_.paused()) return simulate(goal);
        const auto done = std::make_shared<SimulateSteps::Result>();
        done->result = not_paused();
        goal->abort(done);
      });
}

void SimulationServices::simulate(const std::shared_ptr<StepsHandle>& goal) {
  runner_.step(goal->get_goal()->steps, [goal](const Runner::Progress& progress) {
    const auto feedback = std::make_shared<SimulateSteps::Feedback>();
    feedback->completed_steps = progress.made;
    feedback->remaining_steps = progress.left;
    goal->publish_feedback(feedback);
    const auto done = std::make_shared<SimulateSteps::Result>();
    if (progress.failed) {
      done->result = result(Result::RESULT_OPERATION_FAILED, "the simulation makes no more steps");
      goal->abort(done);
    } else if (progress.left == 0) {
      done->result = ok();
      goal->succeed(done);
    } else if (goal->is_canceling()) {
      done->result = result(Result::RESULT_OPERATION_FAILED, "canceled");
      goal->canceled(done);
      return false;
    }
    return true;
  });
}

}  // namespace ros2wasm_sim
