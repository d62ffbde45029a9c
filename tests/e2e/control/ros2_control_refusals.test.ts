// A refused request leaves nothing behind: a description whose hardware cannot be loaded, a switch that the hardware declines.
// The hardware is the workspace's own, a node in Python asks; headless.

// Compatibility, works: ros2_control: a second description after one that failed, `enforce_command_limits`, hardware that declines
// `prepare_command_mode_switch`

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const hardware = `
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hardware_interface/system_interface.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace wary {
using hardware_interface::return_type;

// Declines the first switch that starts the wheel; its states are its commands.
class WarySystem : public hardware_interface::SystemInterface {
 public:
  return_type prepare_command_mode_switch(const std::vector<std::string> & start, const std::vector<std::string> &) override {
    if (declined_ || std::find(start.begin(), start.end(), "wheel/velocity") == start.end()) {
      return return_type::OK;
    }
    declined_ = true;
    return return_type::ERROR;
  }
  return_type read(const rclcpp::Time &, const rclcpp::Duration &) override { return return_type::OK; }
  return_type write(const rclcpp::Time &, const rclcpp::Duration &) override {
    for (const auto & [name, description] : joint_command_interfaces_) {
      const double command = get_command(name);
      if (std::isfinite(command)) set_state(name, command);
    }
    return return_type::OK;
  }

 private:
  bool declined_ = false;
};
}  // namespace wary

PLUGINLIB_EXPORT_CLASS(wary::WarySystem, hardware_interface::SystemInterface)
`;

const controllers = `controller_manager:
  ros__parameters:
    enforce_command_limits: true
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
    speed: {type: pid_controller/PidController}
    driver: {type: forward_command_controller/ForwardCommandController}
    arms: {type: position_controllers/JointGroupPositionController}
speed:
  ros__parameters:
    dof_names: [wheel]
    command_interface: velocity
    reference_and_state_interfaces: [velocity]
    enable_feedforward: true
    gains: {wheel: {p: 0.0, feedforward_gain: 1.0}}
driver:
  ros__parameters: {joints: [speed/wheel], interface_name: velocity}
arms:
  ros__parameters: {joints: [short, long]}
`;

const checker = `#!/usr/bin/env python3
import time

import rclpy
from controller_manager_msgs.srv import ConfigureController, ListHardwareInterfaces, LoadController, SwitchController
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, String

JOINT = '''<link name="{0}_link"/><joint name="{0}" type="{1}">
<parent link="base"/><child link="{0}_link"/><axis xyz="0 0 1"/>{2}</joint>'''
LIMIT = '<limit lower="-{0}" upper="{0}" velocity="100" effort="100"/>'
PART = '<joint name="{0}">{2}<command_interface name="{1}"/><state_interface name="{1}"><param name="initial_value">0.0</param></state_interface></joint>'


def description(plugin, limit, switched=''):
    return ('<robot name="wary"><link name="base"/>' + JOINT.format('wheel', 'continuous', '')
            + JOINT.format('short', 'revolute', LIMIT.format(limit)) + JOINT.format('long', 'revolute', LIMIT.format(limit))
            + f'<ros2_control name="wary" type="system"><hardware><plugin>{plugin}</plugin></hardware>' + PART.format('wheel', 'velocity', '')
            + PART.format('short', 'position', '') + PART.format('long', 'position', switched) + '</ros2_control></robot>')


class Checker(Node):
    def __init__(self):
        super().__init__('checker')
        self.positions = {}
        self.create_subscription(JointState, '/joint_states', lambda one: self.positions.update(zip(one.name, one.position)), 10)
        self.describe = self.create_publisher(String, '/robot_description', QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        self.arms = self.create_publisher(Float64MultiArray, '/arms/commands', 10)

    def ask(self, kind, service, **fields):
        client = self.create_client(kind, '/controller_manager/' + service)
        client.wait_for_service()
        done = client.call_async(kind.Request(**fields))
        rclpy.spin_until_future_complete(self, done)
        return done.result()

    def switch(self, on=(), off=()):
        done = self.ask(SwitchController, 'switch_controller', activate_controllers=list(on), deactivate_controllers=list(off), strictness=2)
        listed = self.ask(ListHardwareInterfaces, 'list_hardware_interfaces').command_interfaces
        print('switched', done.ok, *[f'{one.name} {one.is_available} {one.is_claimed}' for one in listed if 'wheel' in one.name], flush=True)


rclpy.init()
node = Checker()
while node.describe.get_subscription_count() == 0:
    time.sleep(0.05)
node.describe.publish(String(data=description('nowhere/System', 0.2)))
time.sleep(1.0)
node.describe.publish(String(data=description('wary::WarySystem', 1.0, '<limits enable="false"/>')))
for name in ['states', 'speed', 'driver', 'arms']:
    assert node.ask(LoadController, 'load_controller', name=name).ok
    assert node.ask(ConfigureController, 'configure_controller', name=name).ok
node.switch(on=['driver', 'speed'])
node.switch(on=['driver', 'speed'])
node.switch(off=['driver', 'speed'])
node.switch(on=['states', 'arms'])
end = time.monotonic() + 20.0
while time.monotonic() < end and not (node.positions.get('long') == 2.5 and node.positions['short'] >= 1.0):
    node.arms.publish(Float64MultiArray(data=[2.5, 2.5]))
    rclpy.spin_once(node, timeout_sec=0.05)
print(f'arms {node.positions["short"]:.2f} {node.positions["long"]:.2f}', flush=True)
print('all is checked', flush=True)
`;

let workspace: PackWorkspace;

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('wary', {}, {
    cmake: `find_package(hardware_interface REQUIRED)
find_package(pluginlib REQUIRED)
add_library(wary SHARED src/wary.cpp)
ament_target_dependencies(wary hardware_interface pluginlib)
pluginlib_export_plugin_description_file(hardware_interface wary.xml)
install(TARGETS wary LIBRARY DESTINATION lib ARCHIVE DESTINATION lib)
install(FILES controllers.yaml wary.launch.xml DESTINATION share/\${PROJECT_NAME})
install(PROGRAMS checker DESTINATION lib/\${PROJECT_NAME})\n`,
    depends: ['rclpy', 'controller_manager', 'controller_manager_msgs', 'hardware_interface', 'pluginlib', 'ros2_controllers', 'sensor_msgs', 'std_msgs'],
  });
  workspace.write('src/wary/src/wary.cpp', hardware);
  workspace.write('src/wary/wary.xml',
    '<library path="wary"><class type="wary::WarySystem" base_class_type="hardware_interface::SystemInterface"/></library>\n');
  workspace.write('src/wary/controllers.yaml', controllers);
  workspace.write('src/wary/checker', checker);
  workspace.write('src/wary/wary.launch.xml', `<launch>
  <node pkg="controller_manager" exec="ros2_control_node"><param from="$(find-pkg-share wary)/controllers.yaml"/></node>
  <node pkg="wary" exec="checker"/>
</launch>\n`);
  workspace.write('workspace.yaml', 'schema: 1\nname: wary\npackages: [src/*]\nlaunch: src/wary/wary.launch.xml\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stdout + packed.stderr);
}, watchdog);
after(() => workspace.close());

test('a failed description and a declined switch leave nothing behind', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--for', '60s', '--until', 'all is checked']);
  const said = run.stdout.split('\n').filter((line) => line.startsWith('[checker')).map((line) => line.replace(/^.*?\] /, ''));
  assert.match(run.stdout, /Could not load and initialize hardware\. [^]*Resource Manager has been successfully initialized\./, run.stdout + run.stderr);
  assert.match(run.stdout, /Could not switch controllers since prepare command mode switch was rejected\./);
  assert.deepEqual(said.filter((line) => /^(?:switched|arms|all)/.test(line)), [
    'switched False speed/wheel/velocity False False wheel/velocity True False',
    'switched True speed/wheel/velocity True True wheel/velocity True True',
    'switched True speed/wheel/velocity False False wheel/velocity True False',
    'switched True speed/wheel/velocity False False wheel/velocity True False',
    'arms 1.00 2.50',
    'all is checked',
  ], run.stdout + run.stderr);
});
