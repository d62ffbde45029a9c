// The services and the action of simulation_interfaces, which are the same for simulators of any
// make, in the namespace of the node.
#pragma once

#include <rclcpp_action/rclcpp_action.hpp>
#include <simulation_interfaces/action/simulate_steps.hpp>
#include <simulation_interfaces/msg/entity_filters.hpp>
#include <simulation_interfaces/msg/entity_state.hpp>
#include <simulation_interfaces/msg/result.hpp>
#include <simulation_interfaces/msg/spawn_result.hpp>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "ros/host.hpp"
#include "ros/runner.hpp"

namespace ros2wasm_sim {

class SimulationServices {
 public:
  SimulationServices(Host& host, Simulation& simulation, Runner& runner);

 private:
  using Result = simulation_interfaces::msg::Result;
  using SimulateSteps = simulation_interfaces::action::SimulateSteps;
  using StepsHandle = rclcpp_action::ServerGoalHandle<SimulateSteps>;

  template <typename Service, typename Answer>
  void offer(const std::string& name, Answer answer);
  void offer_entities();
  void offer_states();
  void offer_spawning();
  void offer_time();
  void offer_steps();

  /// The names of models that pass, in the order of the world.
  Result select(const simulation_interfaces::msg::EntityFilters& filters,
                std::vector<std::string>& names) const;
  simulation_interfaces::msg::EntityState state_of(const Model& model);
  Result set_state(const std::string& entity, const simulation_interfaces::msg::EntityState& state,
                   bool sets_pose, bool sets_twist);
  template <typename Request>  // SpawnEntity as a message, and as the request of the service
  simulation_interfaces::msg::SpawnResult spawn_one(const Request& request);
  Result reset(std::uint8_t scope);
  std::uint8_t simulation_state();
  Result set_simulation_state(std::uint8_t state);
  void simulate(const std::shared_ptr<StepsHandle>& goal);

  Host& host_;
  Simulation& simulation_;
  Runner& runner_;
  bool stopped_ = false;            ///< it was stopped, and has not played since
  std::set<std::string> original_;  ///< models that the world had when it was loaded
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
  rclcpp_action::Server<SimulateSteps>::SharedPtr steps_;
};

}  // namespace ros2wasm_sim
