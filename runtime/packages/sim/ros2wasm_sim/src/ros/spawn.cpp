// See spawn.hpp.
#include "ros/spawn.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "ros/resources.hpp"
#include "ros/runner.hpp"

namespace ros2wasm_sim {

void set_namespace(Model& model, const std::string& name_space) {
  for (Plugin& plugin : model.plugins) plugin.robot_namespace = name_space;
  for (Link& link : model.links)
    for (Sensor& sensor : link.sensors)
      for (Plugin& plugin : sensor.plugins) plugin.robot_namespace = name_space;
}

Spawned spawn(Host& host, Simulation& simulation, const SpawnOrder& order) {
  const rclcpp::Logger logger = host.node()->get_logger();
  std::string text = order.text, file;
  if (text.empty()) {
    std::vector<std::string> searched;
    const Resources resources = site_resources();
    const auto found = resources.find(order.uri, searched);
    const auto read = found ? resources.read(*found) : std::nullopt;
    if (!read)
      return {.problem = SpawnProblem::kNotFound,
              .error = "the model [" + order.uri + "] is not found (searched: " + listed(searched) +
                       ")"};
    text = *read;
    file = *found;
  }
  std::string error;
  auto model = load_model(logger, text, file, error);
  if (!model) return {.problem = SpawnProblem::kUnreadable, .error = error};
  const std::string wanted = order.name.empty() ? model->name : order.name;
  std::string name = wanted;
  if (simulation.model(name) != nullptr && !order.allow_renaming)
    return {.problem = SpawnProblem::kNameTaken,
            .error = "Entity named [" + name +
                     "] already exists and [allow_renaming] is false. Entity not spawned."};
  for (int i = 0; simulation.model(name) != nullptr; ++i) name = wanted + "_" + std::to_string(i);
  model->name = name;
  model->pose = order.pose;
  if (!order.name_space.empty()) set_namespace(*model, order.name_space);
  try {
    simulation.add(std::move(*model));
  } catch (const PhysicsError& problem) {
    return {.problem = SpawnProblem::kNotSimulated,
            .error = "the model [" + name + "] cannot be simulated: " + problem.what()};
  }
  report_warnings(logger, simulation.physics());
  return {.name = name};
}

}  // namespace ros2wasm_sim
