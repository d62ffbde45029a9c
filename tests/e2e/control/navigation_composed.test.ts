// map_server and lifecycle_manager as components, and a server of the workspace with an action, made of nav2_util. Headless, with
// threads.

// Compatibility, works: Nav2's map_server and lifecycle_manager as components, each in a container of its own package; the manager in
// a container needs a page with shared memory

// Compatibility, works: `nav2_util::SimpleActionServer`: goals, feedback, preemption, cancellation, an exception in the work

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare


def container(name, component):
    return ComposableNodeContainer(name=name, namespace='', package='rclcpp_components', executable='component_container_isolated',
                                   composable_node_descriptions=[component], output='screen')


def generate_launch_description():
    manager = {'use_sim_time': False, 'autostart': True, 'node_names': ['map_server', 'waiter']}
    return LaunchDescription([
        container('map_container', ComposableNode(
            package='nav2_map_server', plugin='nav2_map_server::MapServer', name='map_server',
            parameters=[{'yaml_filename': [FindPackageShare('waiting_room'), '/maps/room.yaml']}])),
        container('manager_container', ComposableNode(
            package='nav2_lifecycle_manager', plugin='nav2_lifecycle_manager::LifecycleManager',
            name='lifecycle_manager_localization', parameters=[manager])),
        Node(package='waiting_room', executable='waiter', output='screen'),
        Node(package='waiting_room', executable='visitor', output='screen'),
    ])
`;

const waiter = `
#include "nav2_msgs/action/wait.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/simple_action_server.hpp"

using Wait = nav2_msgs::action::Wait;
using nav2_util::CallbackReturn;

class Waiter : public nav2_util::LifecycleNode {
 public:
  Waiter() : LifecycleNode("waiter") {}

  CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    server_ = std::make_unique<nav2_util::SimpleActionServer<Wait>>(
        shared_from_this(), "wait", [this] { work(); }, [this] { RCLCPP_INFO(get_logger(), "an end without success"); });
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State&) override {
    server_->activate();
    createBond();
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State&) override {
    server_->deactivate();
    destroyBond();
    return CallbackReturn::SUCCESS;
  }

 private:
  /// 99 seconds stand for a failure.
  void work() {
    auto goal = server_->get_current_goal();
    auto feedback = std::make_shared<Wait::Feedback>();
    for (int left = goal->time.sec; left > 0; --left) {
      if (goal->time.sec == 99) throw std::runtime_error("too long");
      if (server_->is_cancel_requested()) {
        server_->terminate_all();
        return;
      }
      if (server_->is_preempt_requested()) {
        goal = server_->accept_pending_goal();
        left = goal->time.sec;
        RCLCPP_INFO(get_logger(), "now %d", left);
      }
      feedback->time_left.sec = left;
      server_->publish_feedback(feedback);
      rclcpp::sleep_for(std::chrono::milliseconds(100));
    }
    server_->succeeded_current();
  }

  std::unique_ptr<nav2_util::SimpleActionServer<Wait>> server_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Waiter>();
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::shutdown();
}
`;

const visitor = `
#include <functional>

#include "nav2_lifecycle_manager/lifecycle_manager_client.hpp"
#include "nav2_msgs/action/wait.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using namespace std::chrono_literals;
using Wait = nav2_msgs::action::Wait;
using Handle = rclcpp_action::ClientGoalHandle<Wait>;

${driverStart}

rclcpp_action::Client<Wait>::SharedPtr client;
int feedbacks = 0;

Handle::SharedPtr send(int seconds) {
  Wait::Goal goal;
  goal.time.sec = seconds;
  rclcpp_action::Client<Wait>::SendGoalOptions options;
  options.feedback_callback = [](Handle::SharedPtr, const std::shared_ptr<const Wait::Feedback>) { ++feedbacks; };
  return wait(client->async_send_goal(goal, options));
}

void say_end(const char* what, const Handle::SharedPtr& handle) {
  const auto code = wait(client->async_get_result(handle)).code;
  say("%s %s", what,
      code == rclcpp_action::ResultCode::SUCCEEDED ? "succeeded" : code == rclcpp_action::ResultCode::CANCELED ? "canceled" : "aborted");
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("visitor");
  client = rclcpp_action::create_client<Wait>(node, "wait");
  nav_msgs::msg::OccupancyGrid map;
  const auto maps = node->create_subscription<nav_msgs::msg::OccupancyGrid>(
      "map", rclcpp::QoS(1).transient_local(), [&](const nav_msgs::msg::OccupancyGrid& message) { map = message; });
  nav2_lifecycle_manager::LifecycleManagerClient manager("lifecycle_manager_localization", node);
  spin_until([&] { return manager.is_active() == nav2_lifecycle_manager::SystemStatus::ACTIVE && !map.data.empty(); });
  RCLCPP_INFO(node->get_logger(), "map of %d cells", static_cast<int>(map.data.size()));
  client->wait_for_action_server();
  say_end("a short goal", send(3));
  RCLCPP_INFO(node->get_logger(), "feedbacks %d", feedbacks);
  const auto older = send(50);
  feedbacks = 0;
  spin_until([] { return feedbacks > 1; });
  const auto newer = send(2);
  say_end("the older goal", older);
  say_end("the newer goal", newer);
  const auto left = send(50);
  feedbacks = 0;
  spin_until([] { return feedbacks > 1; });
  client->async_cancel_goal(left);
  say_end("the goal that was left", left);
  say_end("the failing goal", send(99));
  RCLCPP_INFO(node->get_logger(), "pause %d", manager.pause());
  RCLCPP_INFO(node->get_logger(), "paused: %s", send(1) == nullptr ? "refused" : "accepted");
  RCLCPP_INFO(node->get_logger(), "visitor is over");
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['nav2_util', 'nav2_lifecycle_manager', 'nav2_msgs', 'nav_msgs', 'rclcpp', 'rclcpp_action'];
  workspace.addPackage('waiting_room', { waiter, visitor }, {
    depends: [...libraries, 'nav2_map_server', 'rclcpp_components'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(waiter ${libraries.join(' ')})
ament_target_dependencies(visitor ${libraries.join(' ')})
install(DIRECTORY launch maps DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/waiting_room/launch/bringup_launch.py', launchFile);
  workspace.write('src/waiting_room/maps/room.pgm', 'P2 3 2 255\n0 254 254\n254 254 0\n');
  workspace.write('src/waiting_room/maps/room.yaml',
    'image: room.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n');
  workspace.write('workspace.yaml', 'schema: 1\nname: waiting\npackages: [src/*]\nlaunch: src/waiting_room/launch/bringup_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

test('a component leads a component and a server of the workspace, and an action server preempts', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--link', 'shared', '--for', '120s', '--until', 'visitor is over']);
  const output = run.stdout + run.stderr;
  assert.equal(run.code, 0, output);
  const lines = output.split('\n').flatMap((line) => /\[visitor\]: (.*)$/.exec(line)?.[1] ?? []);
  assert.deepEqual(lines, [
    'map of 6 cells',
    'a short goal succeeded',
    'feedbacks 3',
    'the older goal aborted',
    'the newer goal succeeded',
    'the goal that was left canceled',
    'the failing goal aborted',
    'pause 1',
    'paused: refused',
    'visitor is over',
  ], output);
  assert.match(output, /\[lifecycle_manager_localization\]: Server map_server connected with bond\./);
  assert.match(output, /\[waiter\]: now 2/);
  assert.match(output, /\[waiter\]: \[wait\] \[ActionServer\] Client requested to cancel the goal\. Cancelling\./);
  assert.match(output, /\[waiter\]: Action server failed while executing action callback: "too long"/);
  assert.match(output, /\[waiter\]: Action server is inactive\. Rejecting the goal\./);
});
