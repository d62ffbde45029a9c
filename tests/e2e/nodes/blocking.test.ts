// Code that blocks on a robot blocks here, and says so once: rates that nobody spins, calls that only the waiting executor
// could answer. The site's time is stepped, so that ten seconds of it take no real time.

// Compatibility, works: deadlocks of ROS 2: `Client.call` of rclpy in a callback of an executor of one thread or of the client's own
// callback group, a Rate that nobody spins, simulated time in a callback of a node of one thread; `spin_until_future_complete` of
// rclcpp in a callback throws. After 5 s the console says why a node waits

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const python = (body: string): string =>
  `import threading

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from std_srvs.srv import Trigger


def say(text):
    print(text, flush=True)


def main():
    rclpy.init()
${body.trimEnd().split('\n').map((line) => `    ${line}`).join('\n')}
`;

/** Asks a service of its own from a timer, which belongs to the group \`asking\`. */
const ask = (executor: string, group: string): string =>
  `node = rclpy.create_node('asker')
asking = MutuallyExclusiveCallbackGroup()
node.create_service(Trigger, '~/service', lambda _, answer: answer, callback_group=MutuallyExclusiveCallbackGroup())
client = node.create_client(Trigger, '~/service', callback_group=${group})
def ask():
    timer.cancel()
    say('call begins')
    client.call(Trigger.Request())
    say('call ends')
timer = node.create_timer(0.1, ask, callback_group=asking)
executor = ${executor}
executor.add_node(node)
executor.spin()
`;

const PROGRAMS = {
  stuck: python(`node = rclpy.create_node('stuck')
rate = node.create_rate(5)
say('before')
rate.sleep()
say('after')
`),
  in_timer: python(`node = rclpy.create_node('in_timer')
rate = node.create_rate(5)
def tick():
    say('tick begins')
    rate.sleep()
    say('tick ends')
node.create_timer(0.3, tick)
rclpy.spin(node)
`),
  threaded: python(`node = rclpy.create_node('threaded')
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
rate = node.create_rate(5)
for number in range(5):
    rate.sleep()
    say(f'turn {number}')
rclpy.shutdown()
`),
  single: python(ask('rclpy.executors.SingleThreadedExecutor()', 'MutuallyExclusiveCallbackGroup()')),
  own_group: python(ask('MultiThreadedExecutor(4)', 'asking')),
  other_group: python(ask('MultiThreadedExecutor(4)', 'MutuallyExclusiveCallbackGroup()')),
};

const CPP = `#include <chrono>
#include <memory>
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/trigger.hpp"
using std_srvs::srv::Trigger;
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("nested");
  auto service = node->create_service<Trigger>("~/service", [](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {});
  auto client = node->create_client<Trigger>("~/service");
  rclcpp::TimerBase::SharedPtr timer = node->create_wall_timer(std::chrono::milliseconds(100), [&] {
    timer->cancel();
    auto future = client->async_send_request(std::make_shared<Trigger::Request>());
    try {
      rclcpp::spin_until_future_complete(node, future);
    } catch (const std::runtime_error& error) {
      RCLCPP_INFO(node->get_logger(), "threw: %s", error.what());
    }
    const bool answered = future.wait_for(std::chrono::seconds(2)) == std::future_status::ready;
    RCLCPP_INFO(node->get_logger(), "answered: %d", answered);
  });
  rclcpp::spin(node);
}
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
  workspace.addPythonPackage('waits', PROGRAMS, ['rclpy', 'std_srvs']);
  workspace.addPackage('waits_cpp', { nested: CPP }, {
    depends: ['rclcpp', 'std_srvs'],
    cmake: `find_package(rclcpp REQUIRED)
find_package(std_srvs REQUIRED)
ament_target_dependencies(nested rclcpp std_srvs)`,
  });
  const nodes = Object.keys(PROGRAMS).map((name) => `  - {package: waits, executable: ${name}, name: ${name}}\n`).join('');
  workspace.write('workspace.yaml', `schema: 1\nname: waits\npackages: [src/*]\nlaunch:\n${nodes}  - {package: waits_cpp, executable: nested}\n`);
});
after(() => workspace.close());

test('deadlocks happen, and are explained once', { timeout: 500_000 }, async () => {
  await workspace.packed();
  const ran = await workspace.run(['run', 'site', '--stepped', '--seed', '1', '--for', '20s']);
  const said = `${ran.stdout}${ran.stderr}`;
  const of = (name: string): string[] => said.split('\n').filter((line) => line.startsWith(`[${name}-`)).map((line) => line.replace(/^\[[^\]]*\] /, ''));
  const help = (what: string): RegExp => new RegExp(`^\\[ros2wasm\\] ${what}: it may never go on, as in ROS 2\\. `);
  const one = (name: string, first: string, what: string): void => {
    const lines = of(name).filter((line) => !line.includes('[INFO]'));
    assert.equal(lines[0], first, said);
    assert.match(lines[1] ?? '', help(what), said);
    assert.equal(lines.filter((line) => line === first || help(what).test(line)).length, 2, said);
    assert.ok(!lines.some((line) => / ends|^after/.test(line)), said);
  };
  one('stuck', 'before', 'Rate.sleep waits for what only an executor takes, and nobody spins the node');
  one('in_timer', 'tick begins', 'Rate.sleep waits in a callback of the executor that must take what it waits for, and has one thread');
  one('single', 'call begins', 'Client.call waits in a callback of the executor that must take what it waits for, and has one thread');
  one('own_group', 'call begins', 'Client.call waits for what belongs to a callback group of which a callback runs');
  assert.deepEqual(of('other_group').filter((line) => line.startsWith('call')), ['call begins', 'call ends'], said);
  assert.deepEqual(of('threaded').filter((line) => line.startsWith('turn')), [0, 1, 2, 3, 4].map((number) => `turn ${number}`), said);
  const nested = of('nested').join('\n');
  assert.match(nested, /threw: Node '\/nested' has already been added to an executor\.\n[^]*answered: 0/);
});

test('a stop ends who waits for ever', { timeout: 500_000 }, async () => {
  for (const link of ['shared', 'port']) {
    const ran = await workspace.run(['run', 'site', '--link', link, '--until', 'tick begins', '--for', '60s']);
    assert.equal(ran.code, 0, `${ran.stdout}${ran.stderr}`);
  }
});
