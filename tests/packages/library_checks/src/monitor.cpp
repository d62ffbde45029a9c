// Diagnostics that a node reports, as another sees them; and constants that parts of an action
// share.

// Compatibility, works: diagnostic_updater: tasks, composites, frequencies and stamps of topics,
// the period as a parameter, summaries that merge; nav2_msgs and geographic_msgs; constants that
// several parts of an action have

#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <string>

#include "checks.hpp"
#include "diagnostic_updater/diagnostic_updater.hpp"
#include "diagnostic_updater/publisher.hpp"
#include "nav2_msgs/action/dock_robot.hpp"
#include "sensor_msgs/msg/temperature.hpp"

using diagnostic_msgs::msg::DiagnosticArray;
using diagnostic_msgs::msg::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;
using nav2_msgs::action::DockRobot;
using sensor_msgs::msg::Temperature;
using namespace std::chrono_literals;

static_assert(DockRobot::Result::NONE == 0 && DockRobot::Result::UNKNOWN == 999);
static_assert(DockRobot::Feedback::NONE == 0 && DockRobot::Feedback::RETRY == 5);

namespace {

class Motor {
 public:
  void report(DiagnosticStatusWrapper& stat) {
    stat.summaryf(stat.WARN, "%d degrees", 71);
    stat.add("running", true);
    stat.add("load", 0.5);
    stat.addf("phase", "%s%d", "p", 3);
  }
};

void check_merging(Checks& checks) {
  DiagnosticStatusWrapper stat;
  stat.summary(stat.OK, "fine");
  stat.mergeSummary(DiagnosticStatus::WARN, "warm");
  stat.mergeSummaryf(DiagnosticStatus::ERROR, "%s", "broken");
  stat.mergeSummary(DiagnosticStatus::OK, "fine again");
  CHECK(stat.level == DiagnosticStatus::ERROR && stat.message == "warm; broken");
  stat.clearSummary();
  CHECK(stat.level == DiagnosticStatus::OK && stat.message.empty());
}

std::string value_of(const DiagnosticStatus& status, const std::string& key) {
  for (const auto& one : status.values) {
    if (one.key == key) {
      return one.value;
    }
  }
  return "absent";
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("monitor");
  check_merging(checks);

  const auto node = std::make_shared<rclcpp::Node>("plant");
  std::map<std::string, DiagnosticStatus> first;
  std::map<std::string, DiagnosticStatus> last;
  const auto heard = node->create_subscription<DiagnosticArray>(
      "/diagnostics", 20, [&](const DiagnosticArray& array) {
        for (const auto& status : array.status) {
          if (status.name.rfind("plant: ", 0) == 0) {
            first.emplace(status.name, status);
            last[status.name] = status;
          }
        }
      });
  diagnostic_updater::Updater updater(node, 0.2);
  updater.setHardwareIDf("board-%02d", 7);
  CHECK(updater.getPeriod().seconds() == 0.2 &&
        node->get_parameter("diagnostic_updater.period").as_double() == 0.2);

  Motor motor;
  updater.add("motor", &motor, &Motor::report);
  diagnostic_updater::Heartbeat alive;
  diagnostic_updater::FunctionDiagnosticTask cool("cool", [](DiagnosticStatusWrapper& stat) {
    stat.summary(stat.OK, "cool");
    stat.add("fans", 2);
  });
  diagnostic_updater::CompositeDiagnosticTask both("both");
  both.addTask(&alive);
  both.addTask(&cool);
  updater.add(both);
  updater.add("silent", [](DiagnosticStatusWrapper&) {});
  updater.add("short", [](DiagnosticStatusWrapper&) {});
  CHECK(updater.removeByName("short") && !updater.removeByName("short"));

  double least = 0.1;
  double most = std::numeric_limits<double>::infinity();
  diagnostic_updater::DiagnosedPublisher<Temperature> out(
      node->create_publisher<Temperature>("plant/heat", 5), updater, {&least, &most}, {-1, 5});
  const auto timer = node->create_wall_timer(20ms, [&] {
    auto message = std::make_unique<Temperature>();
    message->header.stamp = node->now();
    out.publish(std::move(message));
  });
  const std::string topic = "plant: /plant/heat topic status";
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  const auto is_done = [&] {
    return last.count(topic) > 0 &&
           last[topic].message == "Desired frequency met; Timestamps are reasonable.";
  };
  while (rclcpp::ok() && !is_done()) {
    executor.spin_once(1s);
  }
  CHECK(last[topic].level == DiagnosticStatus::OK &&
        value_of(last[topic], "Zero seen diagnostic update count") == "0");
  const DiagnosticStatus& seen = last["plant: motor"];
  CHECK(seen.level == DiagnosticStatus::WARN && seen.message == "71 degrees" &&
        seen.hardware_id == "board-07");
  CHECK(value_of(seen, "running") == "True" && value_of(seen, "load") == "0.5" &&
        value_of(seen, "phase") == "p3");
  CHECK(last["plant: both"].message == "Alive; cool" &&
        value_of(last["plant: both"], "fans") == "2");
  CHECK(last["plant: silent"].level == DiagnosticStatus::ERROR &&
        last["plant: silent"].message == "No message was set");
  updater.broadcast(DiagnosticStatus::STALE, "going down");
  while (rclcpp::ok() && last["plant: motor"].level != DiagnosticStatus::STALE) {
    executor.spin_once(1s);
  }
  CHECK(last["plant: motor"].message == "going down");
  const DiagnosticStatus& start = first["plant: motor"];
  CHECK(start.level == DiagnosticStatus::OK && start.message == "Node starting up");
  return checks.finish();
}
