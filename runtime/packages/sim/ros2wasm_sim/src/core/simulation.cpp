// See simulation.hpp.
#include "core/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ros2wasm_sim {

Simulation::Simulation(World world, std::unique_ptr<Physics> physics, SystemMaker& maker)
    : world_(std::move(world)), physics_(std::move(physics)), maker_(maker) {
  physics_->set_world(world_);
  step_ns_ = std::llround(world_.physics.max_step_size * 1e9);
  for (auto& system : maker_.systems_of(world_, *this)) systems_.push_back({{}, std::move(system)});
  for (const Model& model : world_.models)
    for (auto& system : maker_.systems_of(model, *this))
      systems_.push_back({model.name, std::move(system)});
}

const Model* Simulation::model(const std::string& name) const {
  const auto found = std::find_if(world_.models.begin(), world_.models.end(),
                                  [&](const Model& one) { return one.name == name; });
  return found == world_.models.end() ? nullptr : &*found;
}

void Simulation::step() {
  Now now{time_ns(), world_.physics.max_step_size};
  for (const Owned& one : systems_) one.system->before_step(now);
  physics_->step();
  ++steps_;
  now.time_ns = time_ns();
  for (const Owned& one : systems_) one.system->after_step(now);
}

void Simulation::add(Model model) {
  world_.models.push_back(std::move(model));
  try {
    physics_->set_world(world_);
  } catch (const PhysicsError&) {
    world_.models.pop_back();
    throw;
  }
  ++revision_;
  const Model& added = world_.models.back();
  for (auto& system : maker_.systems_of(added, *this))
    systems_.push_back({added.name, std::move(system)});
}

bool Simulation::remove(const std::string& name) {
  const auto found = std::find_if(world_.models.begin(), world_.models.end(),
                                  [&](const Model& one) { return one.name == name; });
  if (found == world_.models.end()) return false;
  systems_.erase(std::remove_if(systems_.begin(), systems_.end(),
                                [&](const Owned& one) { return one.model == name; }),
                 systems_.end());
  world_.models.erase(found);
  ++revision_;
  physics_->set_world(world_);
  return true;
}

void Simulation::change(const std::string& name, const std::function<void(Model& model)>& change) {
  for (Model& model : world_.models) {
    if (model.name != name) continue;
    const Model before = model;
    change(model);
    try {
      physics_->set_world(world_);
    } catch (const PhysicsError&) {
      model = before;
      throw;
    }
  }
}

bool Simulation::set_light_color(const std::string& name, const Color& diffuse) {
  for (Light& light : world_.lights)
    if (light.name == name) {
      light.diffuse = diffuse;
      return true;
    }
  return false;
}

void Simulation::reset_time() {
  steps_ = 0;
  start_ns_ = 0;
  for (const Owned& one : systems_) one.system->on_reset();
}

void Simulation::reset_poses() {
  physics_->reset();
  for (const Owned& one : systems_) one.system->on_reset();
}

Pose Simulation::model_pose(const Model& model) {
  const std::string& canonical =
      model.canonical_link.empty() ? model.links.front().name : model.canonical_link;
  const auto link = std::find_if(model.links.begin(), model.links.end(),
                                 [&](const Link& one) { return one.name == canonical; });
  const Pose offset = link == model.links.end() ? Pose{} : link->pose;
  return physics_->pose(physics_->link(model.name, canonical)) * inverse(offset);
}

}  // namespace ros2wasm_sim
