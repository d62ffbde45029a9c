// A world that runs: physics, time, and the systems that plugins and sensors have put into it. It
// knows nothing of ROS.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "physics/physics.hpp"
#include "world/world.hpp"

namespace ros2wasm_sim {

struct Now {
  std::int64_t time_ns = 0;  ///< of the simulation
  double step = 0.001;       ///< seconds
};

/// A plugin or a sensor: something that acts in each step.
class System {
 public:
  virtual ~System() = default;
  /// Commands for the step that follows; `now` is the time at its start.
  virtual void before_step(const Now& now) { (void)now; }
  /// Measurements of the step that was made; `now` is the time at its end.
  virtual void after_step(const Now& now) { (void)now; }
  /// Time has gone back to 0, or all poses to their beginning.
  virtual void on_reset() {}
};

/// When something happens at a rate of simulated time. The first time is at once.
class Rate {
 public:
  /// 0: each step.
  explicit Rate(double hz) : period_ns_(hz > 0 ? static_cast<std::int64_t>(1e9 / hz + 0.5) : 0) {}

  bool due(std::int64_t time_ns) {
    if (time_ns < next_ns_) return false;
    // From when it was due, so that the mean rate is the one that was asked for.
    next_ns_ = next_ns_ + period_ns_ <= time_ns ? time_ns + period_ns_ : next_ns_ + period_ns_;
    return true;
  }
  void reset() { next_ns_ = 0; }

 private:
  std::int64_t period_ns_;
  std::int64_t next_ns_ = 0;
};

class Simulation;

/// Makes the systems of plugins and sensors. It reports itself what cannot be made.
class SystemMaker {
 public:
  virtual ~SystemMaker() = default;
  virtual std::vector<std::unique_ptr<System>> systems_of(const Model& model,
                                                          Simulation& simulation) = 0;
  virtual std::vector<std::unique_ptr<System>> systems_of(const World& world,
                                                          Simulation& simulation) = 0;
};

class Simulation {
 public:
  /// Throws PhysicsError.
  Simulation(World world, std::unique_ptr<Physics> physics, SystemMaker& maker);

  const World& world() const { return world_; }
  Physics& physics() { return *physics_; }
  const Model* model(const std::string& name) const;

  std::int64_t time_ns() const { return steps_ * step_ns_ + start_ns_; }
  std::int64_t step_ns() const { return step_ns_; }
  void begin_at(std::int64_t time_ns) { start_ns_ = time_ns; }

  /// Throws PhysicsError when the state is not finite any more; the world is as it began then.
  void step();

  /// It changes when a model comes or goes.
  std::uint64_t revision() const { return revision_; }
  /// Throws PhysicsError, and then nothing has changed.
  void add(Model model);
  bool remove(const std::string& model);

  /// Takes a system of the world, which acts after those that are there.
  void add(std::unique_ptr<System> system) { systems_.push_back({{}, std::move(system)}); }
  /// Gives a model other properties; its state goes on. Throws PhysicsError, and then nothing has
  /// changed.
  void change(const std::string& model, const std::function<void(Model& model)>& change);
  bool set_light_color(const std::string& light, const Color& diffuse);

  void reset_time();
  void reset_poses();

  /// Where a model is now.
  Pose model_pose(const Model& model);

 private:
  struct Owned {
    std::string model;  ///< empty: of the world
    std::unique_ptr<System> system;
  };

  World world_;
  std::unique_ptr<Physics> physics_;
  SystemMaker& maker_;
  std::vector<Owned> systems_;
  std::int64_t step_ns_;
  std::int64_t start_ns_ = 0;
  std::int64_t steps_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace ros2wasm_sim
