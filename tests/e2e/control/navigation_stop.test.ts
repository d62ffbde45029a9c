// A server of Nav2's kind is stopped while it works on a goal: it ends the goal and itself, and is not killed. Headless.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };
/** Which thread notices the stop first is chance. */
const RUNS = 6;

const server = `
#include <cstdio>

#include "nav2_msgs/action/wait.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/simple_action_server.hpp"
#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;
using Wait = nav2_msgs::action::Wait;

class Worker : public nav2_util::LifecycleNode {
 public:
  Worker() : LifecycleNode("worker") {}

 protected:
  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    server_ = std::make_unique<nav2_util::SimpleActionServer<Wait>>(shared_from_this(), "work", [this] { work(); });
    return nav2_util::CallbackReturn::SUCCESS;
  }
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State&) override {
    server_->activate();
    return nav2_util::CallbackReturn::SUCCESS;
  }
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State&) override {
    server_->deactivate();
    return nav2_util::CallbackReturn::SUCCESS;
  }
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State&) override {
    server_.reset();
    return nav2_util::CallbackReturn::SUCCESS;
  }

 private:
  void work() {
    while (rclcpp::ok() && server_->is_server_active()) {
      std::this_thread::sleep_for(5ms);
    }
    std::printf("the work is over\\n");
  }
  std::unique_ptr<nav2_util::SimpleActionServer<Wait>> server_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Worker>();
  node->configure();
  node->activate();
  rclcpp::spin(node->get_node_base_interface());
  std::printf("the server is over\\n");
  rclcpp::shutdown();
}
`;

/** When the client ends, all others are stopped. */
const launchFile = `
from launch import LaunchDescription
from launch.actions import Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='work', executable='server'),
        Node(package='work', executable='client', on_exit=Shutdown()),
    ])
`;

const client = `
#include "nav2_msgs/action/wait.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("client");
  auto client = rclcpp_action::create_client<nav2_msgs::action::Wait>(node, "work");
  client->wait_for_action_server();
  rclcpp::spin_until_future_complete(node, client->async_send_goal(nav2_msgs::action::Wait::Goal()));
  rclcpp::sleep_for(std::chrono::milliseconds(200));
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const depends = ['nav2_msgs', 'nav2_util', 'rclcpp', 'rclcpp_action'];
  workspace.addPackage('work', { server, client }, {
    depends,
    cmake: `${depends.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(server ${depends.join(' ')})
ament_target_dependencies(client nav2_msgs rclcpp rclcpp_action)
install(DIRECTORY launch DESTINATION share/\${PROJECT_NAME})`,
  });
  workspace.write('src/work/launch/work.launch.py', launchFile);
  workspace.write('workspace.yaml', `schema: 1
name: work
packages: [src/*]
launch: src/work/launch/work.launch.py
`);
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

test('a server that works on a goal ends by itself when it is stopped', watchdog, async () => {
  for (let i = 0; i < RUNS; ++i) {
    const run = await workspace.run(['run', 'site', '--for', '60s']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    assert.match(output, /the work is over/, `run ${String(i)}`);
    assert.match(output, /the server is over/, `run ${String(i)}`);
  }
});
