// ros2_control on mock hardware, as bringup packages start it: robot_state_publisher, ros2_control_node and spawners in a launch
// file, one after the other; then switches by `ros2 control`. And a node of the workspace's own that is linked with the library
// of the manager, with hardware and controllers of the workspace. Headless on both links.

// Compatibility, works: ros2_control: `ros2_control_node` with mock hardware, `spawner`, `unspawner`, `hardware_spawner`, switches
// with strictness, `ros2 control`; hardware and controllers of the workspace in a node of its own that links the library
// controller_manager

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { bagFiles, textOfFile } from '../../../runtime/site/ros2cli/shell_files.ts';
import { runCommand } from '../../../runtime/site/ros2cli/run.ts';
import type { Session } from '../../../runtime/site/contract/session.ts';
import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import { played } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 400_000 };
const entry = new URL('../../../runtime/site/session/headless.ts', import.meta.url);

const joint = (name: string, start: string): string => `
    <joint name="${name}">
      <command_interface name="position"/>
      <state_interface name="position">${start}</state_interface>
    </joint>`;
const description = (plugin: string): string =>
  `<?xml version="1.0"?>
<robot name="lift">
  <link name="base"/><link name="cabin"/><link name="door"/>
  <joint name="mast" type="prismatic">
    <parent link="base"/><child link="cabin"/><axis xyz="0 0 1"/><limit lower="0" upper="3" velocity="0.5" effort="100"/>
  </joint>
  <joint name="hinge" type="revolute">
    <parent link="cabin"/><child link="door"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="2" effort="5"/>
  </joint>
  <ros2_control name="Lift" type="system">
    <hardware><plugin>${plugin}</plugin><param name="floor">0.4</param></hardware>
    ${joint('mast', '<param name="initial_value">0.4</param>')}${joint('hinge', '')}
  </ros2_control>
</robot>
`;

const controllers = `
controller_manager:
  ros__parameters:
    update_rate: 50
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    a: {type: position_controllers/JointGroupPositionController}
    b: {type: position_controllers/JointGroupPositionController}
    c: {type: position_controllers/JointGroupPositionController}
a:
  ros__parameters: {joints: [mast]}
b:
  ros__parameters: {joints: [mast]}
c:
  ros__parameters: {joints: [hinge]}
`;

const bringup = `
import os
import signal
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import EmitEvent, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit
from launch.events import matches_action
from launch.events.process import SignalProcess
from launch_ros.actions import Node


def program(name, *arguments):
    return Node(package='controller_manager', executable=name,
                arguments=[*arguments, '--controller-manager', '/controller_manager'])


def spawner(*arguments):
    return program('spawner', *arguments)


def after(first, *then):
    return RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[*then]))


def generate_launch_description():
    share = get_package_share_directory('lift_bringup')
    with open(os.path.join(share, 'lift.urdf')) as file:
        description = file.read()
    first, again = spawner('joint_state_broadcaster'), spawner('joint_state_broadcaster')
    unknown, a, b, c = spawner('x'), spawner('a'), spawner('b', '--inactive'), spawner('c', '--inactive')
    leaving, killed = program('unspawner', 'c'), spawner('c', '--unload-on-kill')
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': description}]),
        Node(package='controller_manager', executable='ros2_control_node',
             parameters=[os.path.join(share, 'controllers.yaml')], output='screen'),
        TimerAction(period=0.5, actions=[first]),
        after(first, again),
        after(again, unknown),
        after(unknown, a),
        after(a, b, program('hardware_spawner', 'Lift', 'Crane', '--activate')),
        after(b, c),
        after(c, leaving),
        after(leaving, killed, TimerAction(period=1.0, actions=[EmitEvent(event=SignalProcess(
            signal_number=signal.SIGINT, process_matcher=matches_action(killed)))])),
    ])
`;

let workspace: PackWorkspace;
let site: string;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('lift_bringup', {}, {
    cmake: 'install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\ninstall(FILES lift.urdf controllers.yaml DESTINATION share/${PROJECT_NAME})',
    depends: ['controller_manager', 'robot_state_publisher'],
  });
  workspace.write('src/lift_bringup/lift.urdf', description('mock_components/GenericSystem'));
  workspace.write('src/lift_bringup/controllers.yaml', controllers);
  workspace.write('src/lift_bringup/launch/lift.launch.py', bringup);
  workspace.write('workspace.yaml', 'schema: 1\nname: lift\npackages: [src/*]\nlaunch: src/lift_bringup/launch/lift.launch.py\n');
  site = await workspace.packed();
}, watchdog);
after(() => workspace.close());

interface Ran {
  readonly code: number;
  readonly out: string;
}

async function ran(session: Session, words: readonly string[]): Promise<Ran> {
  let out = '';
  const code = await runCommand(session, ['control', ...words], {
    signal: AbortSignal.timeout(60_000),
    bags: bagFiles,
    readText: textOfFile,
    takeInput: () => undefined,
    print: (text) => {
      out += `${text}\n`;
    },
    warn: (text) => {
      out += `${text}\n`;
    },
  });
  return { code, out };
}

/** The states of the controllers once `done` says so. */
async function states(session: Session, done: (listed: string) => boolean): Promise<string> {
  for (;;) {
    const { code, out } = await ran(session, ['list_controllers']);
    if (code === 0 && done(out)) return out;
    await new Promise((next) => {
      setTimeout(next, 100);
    });
  }
}

for (const link of played('port', 'shared')) {
  test(`${link}: spawners print and end as in ROS 2`, watchdog, async () => {
    const { code, stdout, stderr } = await workspace.run(['run', 'site', '--link', link, '--until', 'Successfully unloaded controllers', '--for', '120s']);
    assert.equal(code, 0, stdout + stderr);
    const spawned = stdout.split('\n').filter((line) => /spawner/.test(line)).join('\n');
    assert.match(spawned, /INFO\][^\n]*: Loaded joint_state_broadcaster\n[^]*INFO\][^\n]*: Configured and activated joint_state_broadcaster\n/);
    assert.match(spawned, /WARN\][^\n]*: Controller already loaded, skipping load_controller\n[^]*ERROR\][^\n]*: Failed to configure controller\n/);
    assert.match(spawned, /FATAL\][^\n]*: Failed loading controller x\n/);
    assert.deepEqual((stdout + stderr).match(/^\[spawner-\d\] process has died \[exit code 1\]/gm), ['[spawner-4] process has died [exit code 1]',
      '[spawner-5] process has died [exit code 1]']);
    assert.match(stdout, /ERROR\] [^\n]*\[controller_manager\]: Controller 'joint_state_broadcaster' can not be configured from 'active' state\./);
    assert.match(spawned,
      /INFO\][^\n]*: activated component 'Lift'\. Hardware now in state: lifecycle_msgs\.msg\.State\(id=3, label='active'\)\.\n[^]*WARN\][^\n]*: Hardware Component is not loaded - state can not be changed\./);
    assert.match(spawned, /: Configured and activated a\n[^]*: Loaded b\n[^]*: Loaded c\n[^]*: Deactivated controller\n[^]*: Unloaded controller/);
    assert.match(spawned,
      /: Waiting until interrupt to unload controllers\n[^]*: Deactivating and unloading controllers\.\.\.\n[^]*: Successfully deactivated controllers : \['c'\]\n[^]*: Successfully unloaded controllers : \['c'\]/);
    assert.match(stdout, /\[controller_manager\]: The 'type' param was not defined for 'x'\./);
  });

  test(`${link}: switches by strictness, and what ros2 control lists`, watchdog, async () => {
    const { session, close } = await openHeadless(site, link, entry);
    try {
      session.startAll();
      await session.settled;
      const listed = await states(session, (text) => /^b .*inactive$/m.test(text) && !/^c /m.test(text) && /^a .* active *$/m.test(text));
      assert.match(listed, /^joint_state_broadcaster joint_state_broadcaster\/JointStateBroadcaster {6}active {2}$/m);
      assert.equal((await ran(session, ['list_hardware_interfaces'])).out,
        'command interfaces\n\thinge/position [available] [unclaimed]\n\tmast/position [available] [claimed]\nstate interfaces\n\thinge/position\n\tmast/position\n');
      assert.equal((await ran(session, ['list_hardware_components'])).out, `Hardware Component 1
\tname: Lift
\ttype: system
\tplugin name: mock_components/GenericSystem
\tstate: id=3 label=active
\tread/write rate: 50 Hz
\tis_async: False
\tcommand interfaces
\t\thinge/position [available] [unclaimed]
\t\tmast/position [available] [claimed]
`);

      const refused = await ran(session, ['switch_controllers', '--activate', 'b', '--strict']);
      assert.deepEqual(refused, {
        code: 1,
        out: "Unable to activate controller 'b' since the command interface 'mast/position' is currently claimed by another controller.\n",
      });
      const unchanged = await ran(session, ['switch_controllers', '--activate', 'b', 'nonsense', '--deactivate', 'a', '--strict']);
      assert.equal(unchanged.code, 1);
      assert.match(await states(session, () => true), /^a .* active *$/m);

      const swapped = await ran(session, ['switch_controllers', '--activate', 'b', '--deactivate', 'a', '--strict']);
      assert.deepEqual(swapped, { code: 0, out: 'Successfully switched controllers!\n' });
      const after = await states(session, () => true);
      assert.match(after, /^a .*inactive *$/m);
      assert.match(after, /^b .* active *$/m);

      const back = await ran(session, ['switch_controllers', '--activate', 'a', 'nonsense', '--deactivate', 'b', '--best-effort']);
      assert.deepEqual(back, { code: 0, out: 'Successfully switched controllers!\n Deactivated controllers: [ b ]\n Activated controllers: [ a ]\n' });

      assert.deepEqual(await ran(session, ['set_controller_state', 'a', 'inactive']), { code: 0, out: 'Successfully deactivated a\n' });
      assert.deepEqual(await ran(session, ['unload_controller', 'a']), { code: 0, out: 'Successfully unloaded controller a\n' });
      assert.deepEqual(await ran(session, ['load_controller', 'a', '--set-state', 'active']), {
        code: 0,
        out: 'Successfully loaded controller a\nSuccessfully loaded controller a into state active\n',
      });
    } finally {
      await close();
    }
  });
}

test('a node of the workspace has hardware and controllers of the workspace', watchdog, async () => {
  const own = new PackWorkspace('shared');
  try {
    cpSync(resolve(import.meta.dirname, '../../packages/lift_control'), join(own.root, 'src/lift_control'), { recursive: true });
    own.write('src/lift_control/lift.urdf', description('lift_control/LiftSystem'));
    own.write('workspace.yaml', 'schema: 1\nname: lift\npackages: [src/*]\nlaunch: src/lift_control/launch/lift.launch.yaml\n');
    await own.packed();
    const { code, stdout, stderr } = await own.run(['run', 'site', '--until', 'the mast is at 1\\.5', '--for', '120s']);
    assert.equal(code, 0, stdout + stderr);
    assert.match(stdout, /Loaded hardware 'Lift' from plugin 'lift_control\/LiftSystem'/);
    assert.match(stdout, /the mast starts at 0\.4/);
  } finally {
    own.close();
  }
});

const quitter = `
#include "controller_interface/controller_interface.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/rclcpp.hpp"

namespace quitter {
class Quitter : public controller_interface::ControllerInterface {
 public:
  controller_interface::CallbackReturn on_init() override { return controller_interface::CallbackReturn::SUCCESS; }
  controller_interface::InterfaceConfiguration command_interface_configuration() const override {
    return {controller_interface::interface_configuration_type::NONE, {}};
  }
  controller_interface::InterfaceConfiguration state_interface_configuration() const override {
    return {controller_interface::interface_configuration_type::NONE, {}};
  }
  controller_interface::return_type update(const rclcpp::Time &, const rclcpp::Duration &) override {
    if (++updates_ == 20) rclcpp::shutdown();
    return controller_interface::return_type::OK;
  }

 private:
  int updates_ = 0;
};
}  // namespace quitter

PLUGINLIB_EXPORT_CLASS(quitter::Quitter, controller_interface::ControllerInterface)
`;

test('a controller of the workspace may end ros2_control_node in an update', watchdog, async () => {
  const own = new PackWorkspace('shared');
  try {
    own.addPackage('quitter', {}, {
      cmake: `find_package(controller_interface REQUIRED)
find_package(pluginlib REQUIRED)
add_library(quitter SHARED src/quitter.cpp)
ament_target_dependencies(quitter controller_interface pluginlib)
pluginlib_export_plugin_description_file(controller_interface quitter.xml)
install(TARGETS quitter LIBRARY DESTINATION lib ARCHIVE DESTINATION lib)
install(FILES quitter.yaml lift.urdf quitter.launch.xml DESTINATION share/\${PROJECT_NAME})\n`,
      depends: ['controller_interface', 'controller_manager', 'pluginlib', 'robot_state_publisher'],
    });
    own.write('src/quitter/src/quitter.cpp', quitter);
    own.write('src/quitter/quitter.xml',
      '<library path="quitter"><class type="quitter::Quitter" base_class_type="controller_interface::ControllerInterface"/></library>\n');
    own.write('src/quitter/lift.urdf', description('mock_components/GenericSystem'));
    own.write('src/quitter/quitter.yaml', `controller_manager:
  ros__parameters:
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    quitter: {type: quitter::Quitter}
`);
    own.write('src/quitter/quitter.launch.xml', `<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher"><param name="robot_description" value="$(command 'cat $(find-pkg-share quitter)/lift.urdf')"/></node>
  <node pkg="controller_manager" exec="ros2_control_node"><param from="$(find-pkg-share quitter)/quitter.yaml"/></node>
  <node pkg="controller_manager" exec="spawner" args="joint_state_broadcaster quitter"/>
</launch>\n`);
    own.write('workspace.yaml', 'schema: 1\nname: quitter\npackages: [src/*]\nlaunch: src/quitter/quitter.launch.xml\n');
    await own.packed();
    const { stdout, stderr } = await own.run(['run', 'site', '--until', 'Shutting down the controller manager', '--for', '60s']);
    assert.match(stdout, /Configured and activated quitter/, stdout + stderr);
    assert.match(stdout, /Shutting down the controller manager\./, stdout + stderr);
    assert.doesNotMatch(stdout + stderr, /error\[R2W07/);
  } finally {
    own.close();
  }
});
