// Keeps simulated time with the time of the site: the part that both servers share.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <std_msgs/msg/u_int64.hpp>

#include "checks/real_time.hpp"
#include "core/simulation.hpp"
#include "plugins/table.hpp"
#include "ros/host.hpp"

namespace ros2wasm_sim {

class Runner {
 public:
  /// `after_step` is called after each step.
  Runner(rclcpp::Node::SharedPtr node, Simulation& simulation, std::function<void()> after_step);

  /// Called some hundred times a second, also while the world is paused.
  void on_tick(std::function<void()> look) { on_tick_ = std::move(look); }
  void before_step(std::function<void()> act) { before_step_ = std::move(act); }

  bool paused() const { return paused_; }
  void pause(bool paused);
  struct Progress {
    std::uint64_t made = 0, left = 0;
    bool failed = false;  ///< no more are made
  };
  /// Steps that are made although the world is paused, in the ticks that follow: a great many must
  /// not keep the node from its services. `report` is called after those of a tick; false ends
  /// them.
  void step(std::uint64_t count, std::function<bool(const Progress&)> report = {});
  /// The steps that were asked for and are still to be made: they are reported as failed.
  void drop_steps();
  /// No steps after these. 0: no limit.
  void end_after(std::uint64_t steps) { most_steps_ = steps; }

 private:
  void tick();
  void run(const rclcpp::Time& now);
  void run_asked(const rclcpp::Time& end);
  /// False when the state is not finite or no steps are left.
  bool step_once();

  rclcpp::Node::SharedPtr node_;
  Simulation& simulation_;
  std::function<void()> after_step_, before_step_, on_tick_;
  bool paused_ = false;
  std::uint64_t most_steps_ = 0, steps_ = 0;
  struct Asked {
    Progress progress;
    std::function<bool(const Progress&)> report;
  };
  std::deque<Asked> asked_;
  std::int64_t owed_ns_ = 0;  ///< of simulated time, that is to be made up
  rclcpp::Clock clock_{RCL_STEADY_TIME};
  rclcpp::Time
      last_;  ///< when time was last looked at; it is read from `clock_`, so it comes after it
  RealTimeWatch real_time_;
  rclcpp::TimerBase::SharedPtr timer_;
  /// /_gz/state_hash, each second of simulation: a digest of all positions and velocities, so that
  /// the trace of a run has the state of the physics too.
  rclcpp::Publisher<std_msgs::msg::UInt64>::SharedPtr hashes_;
  std::int64_t hashed_s_ = -1;  ///< the second of the last one
};

/// Says what the physics leaves away.
void report_warnings(const rclcpp::Logger& logger, Physics& physics);

/// Reads a world and says what is wrong with it. Nothing when it cannot be used.
std::optional<World> load_world(const rclcpp::Logger& logger, const std::string& name);
std::optional<World> load_world_text(const rclcpp::Logger& logger, const std::string& text,
                                     const std::string& file);
/// Reads a model. An error text in place of a model.
std::optional<Model> load_model(const rclcpp::Logger& logger, const std::string& text,
                                const std::string& file, std::string& error);

}  // namespace ros2wasm_sim
