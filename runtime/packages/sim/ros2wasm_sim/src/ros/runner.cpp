// See runner.hpp.
#include "ros/runner.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "checks/real_time.hpp"
#include "ros/resources.hpp"
#include "sdf/read_sdf.hpp"

namespace ros2wasm_sim {
namespace {

using std::chrono_literals::operator""ms;

/// A step that takes longer than it advances must not keep the node from its services.
constexpr std::chrono::milliseconds kLongestTick{50};
/// The most that is made up after a delay, in nanoseconds: more would only make the delay longer.
constexpr std::int64_t kMostOwed = 100'000'000;

void report(const rclcpp::Logger& logger, const std::vector<Note>& notes, std::string& error) {
  for (const Note& note : notes) {
    std::string place = note.file;
    if (note.line > 0) place += ":" + std::to_string(note.line) + ":" + std::to_string(note.column);
    const std::string text = place.empty() ? note.text : place + ": " + note.text;
    if (note.severity == Severity::kError) {
      if (error.empty()) error = text;
      RCLCPP_ERROR(logger, "%s", text.c_str());
    } else {
      RCLCPP_WARN(logger, "%s", text.c_str());
    }
  }
}

}  // namespace

Runner::Runner(rclcpp::Node::SharedPtr node, Simulation& simulation,
               std::function<void()> after_step)
    : node_(std::move(node)),
      simulation_(simulation),
      after_step_(std::move(after_step)),
      last_(clock_.now()) {
  hashes_ = node_->create_publisher<std_msgs::msg::UInt64>("/_gz/state_hash", rclcpp::QoS(1));
  timer_ = node_->create_wall_timer(4ms, [this] { tick(); });
}

void Runner::pause(bool paused) {
  paused_ = paused;
  owed_ns_ = 0;
  real_time_.restart();
  last_ = clock_.now();
}

void Runner::step(std::uint64_t count, std::function<bool(const Progress&)> report) {
  asked_.push_back({.progress = {.made = 0, .left = count}, .report = std::move(report)});
}

void Runner::drop_steps() {
  const std::deque<Asked> dropped = std::exchange(asked_, {});
  for (const Asked& one : dropped) {
    Progress progress = one.progress;
    progress.failed = true;
    if (one.report) one.report(progress);
  }
}

void Runner::tick() {
  const rclcpp::Time now = clock_.now();
  run_asked(now + rclcpp::Duration(kLongestTick));
  run(now);
  if (on_tick_) on_tick_();
}

void Runner::run_asked(const rclcpp::Time& end) {
  while (!asked_.empty()) {
    Asked& asked = asked_.front();
    Progress& progress = asked.progress;
    while (progress.left > 0 && !progress.failed && clock_.now() < end) {
      progress.failed = !step_once();
      if (progress.failed) break;
      ++progress.made;
      --progress.left;
    }
    const bool goes_on = !asked.report || asked.report(progress);
    if (goes_on && progress.left > 0 && !progress.failed) return;
    asked_.pop_front();
  }
}

void Runner::run(const rclcpp::Time& now) {
  const double factor = simulation_.world().physics.real_time_factor;
  const std::int64_t passed = (now - last_).nanoseconds();
  last_ = now;
  if (paused_) return;
  owed_ns_ +=
      factor > 0 ? static_cast<std::int64_t>(static_cast<double>(passed) * factor) : kMostOwed;
  owed_ns_ = std::min(owed_ns_, std::max(kMostOwed, simulation_.step_ns()));
  const rclcpp::Time end = now + rclcpp::Duration(kLongestTick);
  const std::int64_t before = simulation_.time_ns();
  while (owed_ns_ >= simulation_.step_ns() && !paused_ && clock_.now() < end) {
    owed_ns_ -= simulation_.step_ns();
    step_once();
  }
  const bool is_at_its_end = most_steps_ > 0 && steps_ >= most_steps_;
  if (is_at_its_end) return;
  if (const auto slow = real_time_.add(passed, simulation_.time_ns() - before, factor))
    RCLCPP_WARN(node_->get_logger(),
                "the simulation is slower than time: its real-time factor was %.2f for 5 s. What "
                "takes time here: %s. A <max_step_size> of 0.002 halves the cost of the physics, "
                "and sensors may need a lower <update_rate>",
                *slow, costs_of(simulation_.world()).c_str());
}

bool Runner::step_once() {
  if (most_steps_ > 0 && steps_ >= most_steps_) return false;
  if (before_step_) before_step_();
  try {
    simulation_.step();
  } catch (const PhysicsError& error) {
    RCLCPP_ERROR(node_->get_logger(), "%s", error.what());
    simulation_.reset_poses();
    pause(true);
    return false;
  }
  ++steps_;
  after_step_();
  const std::int64_t second = simulation_.time_ns() / 1'000'000'000;
  if (second == hashed_s_) return true;
  hashed_s_ = second;
  std_msgs::msg::UInt64 hash;
  hash.data = simulation_.physics().state_hash();
  hashes_->publish(hash);
  return true;
}

void report_warnings(const rclcpp::Logger& logger, Physics& physics) {
  for (const std::string& warning : physics.take_warnings())
    RCLCPP_WARN(logger, "%s", warning.c_str());
}

std::optional<World> load_world(const rclcpp::Logger& logger, const std::string& name) {
  std::vector<std::string> searched;
  const auto path = find_world(name, searched);
  const auto text = path ? site_resources().read(*path) : std::nullopt;
  if (!text) {
    RCLCPP_ERROR(logger, "the world [%s] is not found (searched: %s)", name.c_str(),
                 listed(searched).c_str());
    return std::nullopt;
  }
  return load_world_text(logger, *text, *path);
}

std::optional<World> load_world_text(const rclcpp::Logger& logger, const std::string& text,
                                     const std::string& file) {
  Reading<World> reading = read_world(text, file, site_resources());
  std::string error;
  report(logger, reading.notes, error);
  return std::move(reading.value);
}

std::optional<Model> load_model(const rclcpp::Logger& logger, const std::string& text,
                                const std::string& file, std::string& error) {
  Reading<Model> reading = read_model(text, file, site_resources());
  report(logger, reading.notes, error);
  if (!reading.value && error.empty()) error = "the text does not describe a model";
  return std::move(reading.value);
}

}  // namespace ros2wasm_sim
