// A gamepad's messages through teleop_twist_joy, twist_mux and twist_unstamper, a plain multiplexer with a stamper, and numbers
// through each tool of topic_tools; started by upstream's launch files and by nodes of a launch file, headless.

// Compatibility, works: twist_mux (priorities, timeouts, locks, diagnostics, `use_stamped`, twist_marker, twist_mux_launch.py), twist_stamper
// and twist_unstamper, teleop_twist_joy with teleop-launch.py and the parameters of its gamepads

// Compatibility, works: topic_tools: relay, throttle (messages and bytes), drop, delay, mux and demux with their services, as programs
// and components, for messages of any type

// Compatibility, differs: joystick_relay.py of twist_mux, relay_field and transform of topic_tools -> are not there; a demux that selects
// `__none` stops, upstream's goes on to its last output

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const launchFile = `
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare


def include(package, file, **arguments):
    path = PathJoinSubstitution([FindPackageShare(package), 'launch', file])
    return IncludeLaunchDescription(PythonLaunchDescriptionSource(path), launch_arguments=arguments.items())


def tool(executable, *arguments, **others):
    return Node(package='topic_tools', executable=executable, arguments=list(arguments), **others)


def generate_launch_description():
    plain = {'use_stamped': False, 'topics.only.topic': 'plain_vel', 'topics.only.timeout': 0.0, 'topics.only.priority': 1}
    composed = ComposableNode(package='topic_tools', plugin='topic_tools::RelayNode', name='composed_relay',
                              parameters=[{'input_topic': 'numbers', 'output_topic': 'composed'}])
    return LaunchDescription([
        ComposableNodeContainer(name='container', namespace='', package='rclcpp_components', executable='component_container',
                                composable_node_descriptions=[composed]),
        include('twist_mux', 'twist_mux_launch.py'),
        include('teleop_twist_joy', 'teleop-launch.py', joy_vel='joy_vel', publish_stamped_twist='true'),
        Node(package='twist_stamper', executable='twist_unstamper',
             remappings=[('cmd_vel_in', 'twist_mux/cmd_vel'), ('cmd_vel_out', 'driven')]),
        Node(package='twist_mux', executable='twist_mux', name='plain_mux', parameters=[plain], remappings=[('cmd_vel_out', 'plain_out')]),
        Node(package='twist_stamper', executable='twist_stamper', parameters=[{'frame_id': 'base_link'}],
             remappings=[('cmd_vel_in', 'plain_out'), ('cmd_vel_out', 'stamped_out')]),
        tool('relay', 'numbers'),
        tool('relay', name='lazy_relay', parameters=[{'input_topic': 'numbers', 'output_topic': 'lazily', 'lazy': True}]),
        tool('drop', 'numbers', '1', '3'),
        tool('throttle', 'messages', 'numbers', '5.0'),
        tool('throttle', 'bytes', 'numbers', '20', '60.0', 'first_bytes', name='byte_throttle'),
        tool('delay', 'numbers', '0.3'),
        tool('mux', 'chosen', 'numbers', 'others'),
        tool('demux', 'numbers', 'left', 'right'),
        Node(package='pad', executable='driver', output='screen'),
    ])
`;

const head = `
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

inline std::shared_ptr<rclcpp::Node> node;

inline bool spin_until(const std::function<bool()>& is_done, std::chrono::nanoseconds most = 30s) {
  const auto end = node->now() + rclcpp::Duration(most);
  while (!is_done() && node->now() < end) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(2ms);
  }
  return is_done();
}

template <typename... T>
void say(const char* format, T... values) { RCLCPP_INFO(node->get_logger(), format, values...); }
`;

const numbers = `
#include "std_msgs/msg/int32.hpp"
#include "topic_tools_interfaces/srv/demux_select.hpp"
#include "topic_tools_interfaces/srv/mux_add.hpp"
#include "topic_tools_interfaces/srv/mux_delete.hpp"
#include "topic_tools_interfaces/srv/mux_list.hpp"
#include "topic_tools_interfaces/srv/mux_select.hpp"

using std_msgs::msg::Int32;
namespace srv = topic_tools_interfaces::srv;

struct Heard {
  std::vector<int> values;
  std::vector<double> times;
  rclcpp::Subscription<Int32>::SharedPtr subscription;
};
std::map<std::string, Heard> heard;

void hear(const std::string& topic) {
  heard[topic].subscription = node->create_subscription<Int32>(topic, 100, [topic](const Int32& message) {
    heard[topic].values.push_back(message.data);
    heard[topic].times.push_back(node->now().seconds());
  });
}

std::string text_of(const std::string& topic) {
  std::string result;
  for (const int value : heard[topic].values) result += " " + std::to_string(value);
  return result;
}

void send(const rclcpp::Publisher<Int32>::SharedPtr& publisher, int value) {
  Int32 message;
  message.data = value;
  publisher->publish(message);
}

template <typename ServiceT>
typename ServiceT::Response call(const std::string& name, typename ServiceT::Request request = typename ServiceT::Request()) {
  const auto client = node->create_client<ServiceT>(name);
  client->wait_for_service();
  auto future = client->async_send_request(std::make_shared<typename ServiceT::Request>(request));
  rclcpp::spin_until_future_complete(node, future);
  return *future.get();
}

template <typename ServiceT>
typename ServiceT::Response call_for(const std::string& name, const std::string& topic) {
  typename ServiceT::Request request;
  request.topic = topic;
  return call<ServiceT>(name, request);
}

void flows(const rclcpp::Publisher<Int32>::SharedPtr& numbers) {
  constexpr int kCount = 50;
  std::vector<double> sent{0};
  const double start = node->now().seconds();
  spin_until([&] {
    const int next = static_cast<int>(sent.size());
    if (next <= kCount && node->now().seconds() - start >= 0.02 * next) {
      sent.push_back(node->now().seconds());
      send(numbers, next);
    }
    return heard["numbers_delay"].values.size() == kCount && heard["numbers_relay"].values.size() == kCount;
  });
  for (const char* topic : {"numbers_relay", "composed", "numbers_drop", "first_bytes", "chosen", "left", "right", "lazily"}) {
    say("%s:%s", topic, text_of(topic).c_str());
  }
  double least_delay = 100;
  for (size_t i = 0; i < heard["numbers_delay"].values.size(); ++i) {
    least_delay = std::min(least_delay, heard["numbers_delay"].times[i] - sent[heard["numbers_delay"].values[i]]);
  }
  say("numbers_delay:%s", text_of("numbers_delay").c_str());
  say("least delay %.3f", least_delay);
  const auto& slow = heard["numbers_throttle"].values;
  const double seconds = slow.empty() ? 0 : sent[slow.back()] - sent[slow.front()];
  say("throttled %d in %.3f", static_cast<int>(slow.size()), seconds);
}

void choices(const rclcpp::Publisher<Int32>::SharedPtr& numbers, const rclcpp::Publisher<Int32>::SharedPtr& others) {
  for (auto& [topic, one] : heard) one.values.clear();
  say("mux lists %s", [] { std::string all; for (const auto& one : call<srv::MuxList>("mux/list").topics) all += one + " "; return all; }().c_str());
  const auto selected = call_for<srv::MuxSelect>("mux/select", "others");
  say("select others: %d before %s", selected.success, selected.prev_topic.c_str());
  say("select unknown: %d", call_for<srv::MuxSelect>("mux/select", "unknown").success);
  say("delete selected: %d", call_for<srv::MuxDelete>("mux/delete", "/others").success);
  say("add third: %d, again: %d", call_for<srv::MuxAdd>("mux/add", "third").success, call_for<srv::MuxAdd>("mux/add", "third").success);
  say("delete numbers: %d", call_for<srv::MuxDelete>("mux/delete", "numbers").success);
  const auto demuxed = call_for<srv::DemuxSelect>("demux/select", "right");
  say("select right: %d before %s", demuxed.success, demuxed.prev_topic.c_str());
  spin_until([&] { return others->get_subscription_count() == 1 && node->count_publishers("right") == 1 && node->count_publishers("left") == 0; });
  send(numbers, 101);
  send(others, 201);
  spin_until([] { return !heard["right"].values.empty() && !heard["chosen"].values.empty(); });
  say("then chosen:%s left:%s right:%s", text_of("chosen").c_str(), text_of("left").c_str(), text_of("right").c_str());
  call_for<srv::MuxSelect>("mux/select", "__none");
  call_for<srv::DemuxSelect>("demux/select", "__none");
  spin_until([&] { return others->get_subscription_count() == 0 && node->count_publishers("right") == 0; });
  heard["numbers_relay"].values.clear();
  send(others, 202);
  send(numbers, 102);
  spin_until([] { return !heard["numbers_relay"].values.empty(); });
  say("at last chosen:%s right:%s", text_of("chosen").c_str(), text_of("right").c_str());
}

void play_numbers() {
  const auto numbers = node->create_publisher<Int32>("numbers", 100);
  const auto others = node->create_publisher<Int32>("others", 100);
  for (const char* topic : {"numbers_relay", "composed", "numbers_drop", "numbers_throttle", "first_bytes", "numbers_delay", "chosen", "left", "right"}) hear(topic);
  spin_until([&] {
    bool is_ready = true;
    for (const char* topic : {"numbers_relay", "composed", "numbers_drop", "numbers_throttle", "first_bytes", "numbers_delay", "chosen", "left", "lazily"}) {
      is_ready = is_ready && node->count_publishers(topic) == 1;
    }
    return is_ready && numbers->get_subscription_count() == 8;
  });
  say("subscriptions without one of lazily: %d", static_cast<int>(numbers->get_subscription_count()));
  hear("lazily");
  spin_until([&] { return numbers->get_subscription_count() == 9; });
  say("subscriptions with one of lazily: %d", static_cast<int>(numbers->get_subscription_count()));
  flows(numbers);
  choices(numbers, others);
}
`;

const driver = `
#include "driver.hpp"
#include "numbers.hpp"

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "sensor_msgs/msg/joy.hpp"
#include "std_msgs/msg/bool.hpp"
#include "visualization_msgs/msg/marker.hpp"

using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;

constexpr size_t kEnable = 8;
constexpr size_t kTurbo = 10;
std::vector<Twist> driven;
std::string frame;
rclcpp::Publisher<sensor_msgs::msg::Joy>::SharedPtr joy;
rclcpp::Publisher<TwistStamped>::SharedPtr navigation;

/// Presses a button, or none, with the stick half to the left and at its front end.
void press(size_t button) {
  sensor_msgs::msg::Joy message;
  message.axes = {0.5, 1.0, 0.0, 0.0, 0.0, 0.0};
  message.buttons.resize(12);
  if (button < 12) message.buttons[button] = 1;
  joy->publish(message);
}

void navigate(double speed) {
  TwistStamped message;
  message.header.frame_id = "map";
  message.twist.linear.x = speed;
  navigation->publish(message);
}

void say_next(const char* what) {
  spin_until([] { return !driven.empty(); });
  for (const Twist& twist : driven) say("%s drives %.2f %.2f", what, twist.linear.x, twist.angular.z);
  driven.clear();
}

/// Lets messages through that should not come.
void wait(std::chrono::nanoseconds time) { spin_until([] { return false; }, time); }

void play_pad() {
  navigate(0.1);
  say_next("navigation");
  press(kEnable);
  say_next("pad");
  navigate(0.2);
  press(kTurbo);
  say_next("turbo");
  press(99);
  say_next("released");
  press(99);
  navigate(0.3);
  wait(600ms);
  navigate(0.4);
  say_next("after the timeout navigation");
  rclcpp::SyncParametersClient parameters(node, "teleop_twist_joy_node");
  const auto results = parameters.set_parameters({rclcpp::Parameter("scale_linear.x", 2.0)});
  say("set: %d", results.at(0).successful);
  press(kEnable);
  say_next("changed pad");
}

void play_lock() {
  const auto pause = node->create_publisher<std_msgs::msg::Bool>("pause_navigation", 10);
  std::string lock;
  const auto diagnostics = node->create_subscription<diagnostic_msgs::msg::DiagnosticArray>(
      "/diagnostics", 10, [&](const diagnostic_msgs::msg::DiagnosticArray& message) {
        for (const auto& status : message.status) {
          if (status.name != "twist_mux: Twist mux status") continue;
          for (const auto& one : status.values) {
            if (one.key == "lock locks.pause") lock = one.value;
          }
        }
      });
  spin_until([&] { return pause->get_subscription_count() == 1; });
  std_msgs::msg::Bool message;
  message.data = true;
  pause->publish(message);
  spin_until([&] { return lock.rfind(" locked", 0) == 0; });
  say("lock:%s", lock.c_str());
  wait(600ms);
  navigate(0.5);
  wait(200ms);
  press(kEnable);
  say_next("locked");
}

void play_plain() {
  const auto plain = node->create_publisher<Twist>("plain_vel", 10);
  TwistStamped stamped;
  const auto subscription = node->create_subscription<TwistStamped>("stamped_out", 10, [&](const TwistStamped& message) { stamped = message; });
  spin_until([&] { return plain->get_subscription_count() == 1 && subscription->get_publisher_count() == 1 && node->count_subscribers("plain_out") == 1; });
  Twist twist;
  twist.linear.x = 0.25;
  plain->publish(twist);
  spin_until([&] { return !stamped.header.frame_id.empty(); });
  const double age = (node->now() - rclcpp::Time(stamped.header.stamp)).seconds();
  say("stamped %s %.2f is new: %d", stamped.header.frame_id.c_str(), stamped.twist.linear.x, age >= 0 && age < 5);
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  joy = node->create_publisher<sensor_msgs::msg::Joy>("joy", 10);
  navigation = node->create_publisher<TwistStamped>("nav_vel", 10);
  const auto output = node->create_subscription<Twist>("driven", 10, [](const Twist& message) { driven.push_back(message); });
  visualization_msgs::msg::Marker marker;
  const auto markers = node->create_subscription<visualization_msgs::msg::Marker>("marker", 10, [&](const visualization_msgs::msg::Marker& message) { marker = message; });
  spin_until([&] {
    return joy->get_subscription_count() == 1 && navigation->get_subscription_count() == 1 && output->get_publisher_count() == 1 &&
           markers->get_publisher_count() == 1 && node->count_publishers("joy_vel") == 1 && node->count_subscribers("twist_mux/cmd_vel") == 2;
  });
  play_pad();
  play_lock();
  spin_until([&] { return !marker.points.empty() && marker.points[1].x == 2.0; });
  say("marker in %s to %.2f %.2f", marker.header.frame_id.c_str(), marker.points.at(1).x, marker.points.at(1).y);
  play_plain();
  play_numbers();
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

const DEPENDS = ['rclcpp', 'diagnostic_msgs', 'geometry_msgs', 'sensor_msgs', 'std_msgs', 'topic_tools_interfaces', 'visualization_msgs'];
let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('pad', { driver }, {
    depends: [...DEPENDS, 'rclcpp_components', 'teleop_twist_joy', 'topic_tools', 'twist_mux', 'twist_stamper'],
    cmake: `${DEPENDS.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(driver ${DEPENDS.join(' ')})
install(DIRECTORY launch DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/pad/src/driver.hpp', head);
  workspace.write('src/pad/src/numbers.hpp', numbers);
  workspace.write('src/pad/launch/pad.launch.py', launchFile);
  workspace.write('workspace.yaml', 'schema: 1\nname: pad\npackages: [src/*]\nlaunch: src/pad/launch/pad.launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.doesNotMatch(packed.stderr, /R2W0415/);
});
after(() => workspace.close());

/** The lines that the driver logs. */
function said(output: string): string[] {
  return output.split('\n').flatMap((line) => /\[driver\]: (.*)$/.exec(line)?.[1] ?? []);
}

const range = (from: number, to: number): number[] => Array.from({ length: to - from + 1 }, (_, i) => from + i);
const list = (topic: string, values: readonly number[]): string => `${topic}:${values.map((one) => ` ${String(one)}`).join('')}`;

for (const link of played('port', 'shared')) {
  test(`${link}: velocities and numbers go through the tools`, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '120s', '--until', 'driver is over']);
    const output = run.stdout;
    assert.equal(run.code, 0, output + run.stderr);
    const lines = said(output);

    assert.match(output, /\[twist_mux\]: Topic handler 'topics\.joystick' subscribed to topic 'joy_vel': timeout = 0\.500000s , priority = 100\./);
    assert.match(output, /\[joy_node\]: No gamepad yet\. .*a headless run has none\./);
    assert.match(output, /\[TeleopTwistJoy\]: Turbo for angular axis yaw is scale 1\.000000\./);
    assert.deepEqual(lines.filter((line) => line.includes('drives')), [
      'navigation drives 0.10 0.00',
      'pad drives 0.70 0.20', // ps3: 0.7 m/s, 0.4 rad/s
      'turbo drives 1.50 0.50', // and not 0.2 of the navigation; turbo has 1.5 m/s, and 1 rad/s as nothing else says
      'released drives 0.00 0.00',
      'after the timeout navigation drives 0.40 0.00',
      'changed pad drives 2.00 0.20',
      'locked drives 2.00 0.20', // the lock has the priority of the pad, the navigation less
    ]);
    for (
      const line of [
        'set: 1',
        'lock: locked (listening to pause_navigation @ 0.000000s with priority #100)',
        'marker in base_link to 2.00 0.20',
        'stamped base_link 0.25 is new: 1',
        'subscriptions without one of lazily: 8',
        'subscriptions with one of lazily: 9',
        list('numbers_relay', range(1, 50)),
        list('lazily', range(1, 50)),
        list('composed', range(1, 50)),
        list('numbers_drop', range(1, 50).filter((one) => one % 3 !== 1)),
        list('first_bytes', [1, 2, 3]), // 8 bytes each: 0, 8 and 16 are fewer than 20
        list('numbers_delay', range(1, 50)),
        list('chosen', range(1, 50)),
        list('left', range(1, 50)),
        'right:',
        'mux lists numbers others ',
        'select others: 1 before numbers',
        'select unknown: 0',
        'delete selected: 0',
        'add third: 1, again: 0',
        'delete numbers: 1',
        'select right: 1 before left',
        'then chosen: 201 left: right: 101',
        'at last chosen: 201 right: 101',
      ]
    ) assert.ok(lines.includes(line), `the driver does not say: ${line}\n${output}`);
    assert.match(output, /\[mux\]: tried to delete currently selected topic \/others from mux/);
    const delay = Number(/least delay ([\d.]+)/.exec(output)?.[1]);
    assert.ok(delay >= 0.3, `a message was delayed by ${String(delay)} s`);
    const [, count, seconds] = /throttled (\d+) in ([\d.]+)/.exec(output) ?? [];
    assert.ok(Number(count) >= 3 && Number(count) <= 6, `${String(count)} messages in a second at 5 Hz`);
    // On a busy machine one comes late, and the next seems early.
    const gap = Number(seconds) / (Number(count) - 1);
    assert.ok(gap >= 0.15, `messages ${String(gap)} s apart at 5 Hz`);
  });
}
