// Controllers, and what loops that must not wait read and publish by.

// Compatibility, works: realtime_tools (`RealtimeBuffer`, `RealtimePublisher`,
// `RealtimeThreadSafeBox`, `RealtimeBox`, `RealtimeServerGoalHandle`); control_toolbox (`Pid` with
// its anti-windup strategies, `RateLimiter`)

// Compatibility, works: pal_statistics in C++: registries by key or topic, REGISTER_ENTITY and
// REGISTER_VARIABLE, registrations that end with their owner, `/full`, `/names` and `/values`,
// publishing at once or by a thread

// Compatibility, differs: `realtime_tools::RealtimePublisher` -> publishes in the thread that asks,
// at once, as that does not wait here; the filters, `PidROS` and the rest of control_toolbox, and
// clocks and threads of realtime_tools, are missing

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "checks.hpp"
#include "control_toolbox/pid.hpp"
#include "pal_statistics/pal_statistics_macros.hpp"
#include "realtime_tools/realtime_box.h"
#include "realtime_tools/realtime_buffer.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "sensor_msgs/msg/joint_state.hpp"

namespace {

using control_toolbox::AntiWindupStrategy;
using control_toolbox::Pid;

bool near(double a, double b) {
  return std::abs(a - b) < 1e-12;
}

AntiWindupStrategy strategy(const std::string& name) {
  AntiWindupStrategy result;
  result.set_type(name);
  result.i_max = 100;
  result.i_min = -100;
  return result;
}

void check_pid(Checks& checks) {
  Pid pid(2, 0.5, 0.1, 10, -10);
  CHECK(near(pid.compute_command(1.0, 0.1), 2 + 0.05 + 1));
  CHECK(near(pid.compute_command(1.0, 0.0), 3.05));  // no time, no change
  CHECK(near(pid.compute_command(0.5, rclcpp::Duration::from_seconds(0.1)), 1 + 0.075 - 0.5));
  CHECK(near(pid.compute_command(0.5, 2.0, std::chrono::nanoseconds(100000000)), 1 + 0.1 + 0.2));
  CHECK_THROWS(std::invalid_argument, (void)pid.compute_command(1.0, -0.1));
  CHECK(std::isnan(pid.compute_command(std::numeric_limits<double>::infinity(), 0.1)));
  double p = 0, i = 0, d = 0;
  pid.get_current_pid_errors(p, i, d);
  CHECK(p == 0.5 && near(i, 0.1) && d == 2);
  pid.reset();
  CHECK(pid.get_current_cmd() == 0 && near(pid.compute_command(1.0, 0.0, 0.1), 2.05));
  CHECK_THROWS(std::invalid_argument, Pid(1, 1, 1, -1, 1));

  // What is added up is limited in the output, and itself when that is asked for.
  Pid loose(0, 1, 0, 1, -1);
  Pid tight(0, 1, 0, 1, -1, true);
  for (Pid* one : {&loose, &tight}) {
    for (int n = 0; n < 30; ++n) (void)one->compute_command(1.0, 0.1);
    CHECK(near(one->get_current_cmd(), 1));
  }
  CHECK(near(tight.compute_command(-1.0, 0.1), 0.9));

  // A motor at its limit for a second, and what is left of that when the error turns.
  double after[3] = {};
  int n = 0;
  for (const char* name : {"none", "conditional_integration", "back_calculation"}) {
    Pid limited(1, 2, 0, 1.5, -1.5, strategy(name));
    for (int step = 0; step < 10; ++step) CHECK(limited.compute_command(2.0, 0.1) <= 1.5);
    after[n++] = limited.compute_command(-0.5, 0.1);
  }
  CHECK(near(after[0], 1.5) && near(after[1], -0.5) && after[2] > after[1] && after[2] < 1);
  CHECK_THROWS(std::invalid_argument, strategy("magic"));
  CHECK(!pid.set_gains(1, 1, 1, -1, 1, strategy("none")) && pid.get_gains().p_gain_ == 2);
  CHECK_THROWS(std::runtime_error,
               (void)Pid(1, 0, 0, 1, -1, AntiWindupStrategy()).compute_command(1.0, 0.1));
}

void check_values(Checks& checks) {
  realtime_tools::RealtimeBuffer<int> buffer(1);
  CHECK(*buffer.readFromRT() == 1);
  buffer.writeFromNonRT(2);
  CHECK(*buffer.readFromNonRT() == 2 && *buffer.readFromRT() == 2);
  realtime_tools::RealtimeBuffer<std::shared_ptr<std::string>> commands;
  CHECK(*commands.readFromRT() == nullptr);
  commands.writeFromNonRT(std::make_shared<std::string>("go"));
  const auto copy = commands;
  CHECK(**copy.readFromNonRT() == "go" && **commands.readFromRT() == "go");
  commands.reset();
  CHECK(*commands.readFromRT() == nullptr);

  realtime_tools::RealtimeBox<double> box(0.5);
  box.set(1.5);
  CHECK(box.get() == 1.5 && box.try_set(2.5) && box.try_get() == 2.5);
  box.set([](double& value) { value *= 2; });
  double seen = 0;
  CHECK(box.tryGet([&](const double& value) { seen = value; }) && seen == 5);
}

void check_publisher(Checks& checks) {
  const auto node = rclcpp::Node::make_shared("control");
  using sensor_msgs::msg::JointState;
  std::string heard;
  const auto subscription = node->create_subscription<JointState>(
      "joints", 10, [&](const JointState& state) { heard += state.name.at(0); });
  realtime_tools::RealtimePublisher<JointState> publisher(
      node->create_publisher<JointState>("joints", 10));
  if (publisher.trylock()) {
    publisher.msg_.name = {"a"};
    publisher.unlockAndPublish();
  }
  JointState state;
  state.name = {"b"};
  CHECK(publisher.try_publish(state) && publisher.can_publish());
  while (heard.size() < 2) rclcpp::spin_some(node);
  CHECK(heard == "ab");
}

void check_statistics(Checks& checks) {
  using pal_statistics_msgs::msg::StatisticsNames;
  using pal_statistics_msgs::msg::StatisticsValues;
  const auto node = std::make_shared<rclcpp::Node>("introspected");
  StatisticsNames names;
  StatisticsValues values;
  const auto of_names = node->create_subscription<StatisticsNames>(
      "~/loads/names", 1, [&](const StatisticsNames& heard) { names = heard; });
  const auto of_values = node->create_subscription<StatisticsValues>(
      "~/loads/values", 1, [&](const StatisticsValues& heard) { values = heard; });
  const double share = 0.5;
  const int jobs = 3;
  {
    pal_statistics::RegistrationsRAII owned;
    REGISTER_ENTITY("loads", "share", &share, &owned);
    REGISTER_ENTITY("loads", "jobs", &jobs, &owned, false);
    INITIALIZE_REGISTRY(node, "~/loads", "loads");
    const auto message = pal_statistics::getRegistry("loads")->createMsg();
    CHECK(message.statistics.size() == 1 && message.statistics[0].value == 0.5);
    CHECK(owned.enableAll() && !owned.disable("heat"));
    PUBLISH_STATISTICS("loads");
    while (names.names.size() < 2 || values.values.size() < 2) rclcpp::spin_some(node);
    CHECK(names.names[1] == "jobs" && values.values[1] == 3);
    CHECK(names.names_version == 1 && values.names_version == 1);
  }
  CHECK(pal_statistics::getRegistry("loads")->createMsg().statistics.empty());
  CLEAR_ALL_REGISTRIES();
}

}  // namespace

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  Checks checks("control");
  check_pid(checks);
  check_values(checks);
  check_publisher(checks);
  check_statistics(checks);
  return checks.finish();
}
