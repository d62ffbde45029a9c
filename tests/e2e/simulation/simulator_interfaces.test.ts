// The services and the action of simulation_interfaces, by a node in Python that asks for all of them, in a world that
// ros_gz_sim's gz_server.launch.py starts.

// Compatibility, works: simulation_interfaces as GzServer offers it: entities, states, spawning, deleting, pause, stop, reset,
// steps by service and by action

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const part = `<link name="link"><inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>
  <collision name="c"><geometry><box><size>0.2 0.2 0.2</size></box></geometry></collision></link>`;
const world = `<sdf version="1.9"><world name="yard">
  <model name="floor"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry></collision></link></model>
  <model name="wall"><static>true</static><pose>3 0 0.1 0 0 0</pose>${part}</model>
  <model name="crate"><pose>1 0 0.1 0 0 0</pose>${part}</model>
</world></sdf>
`;
const ball = `<sdf version="1.9"><model name="ball">${part}</model></sdf>`;

const launch = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    server = os.path.join(get_package_share_directory('ros_gz_sim'), 'launch', 'gz_server.launch.py')
    world = os.path.join(get_package_share_directory('yard'), 'yard.sdf')
    return LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource(server), launch_arguments={'world_sdf_file': world}.items()),
        Node(package='yard', executable='inspector')])
`;

const inspector = `
import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from simulation_interfaces.action import SimulateSteps
from simulation_interfaces.msg import EntityCategory, Resource, SimulationState
from simulation_interfaces.srv import (DeleteEntity, GetEntities, GetEntitiesStates, GetEntityInfo, GetEntityState,
                                       GetSimulationState, GetSimulatorFeatures, ResetSimulation, SetEntityState,
                                       SetSimulationState, SpawnEntities, SpawnEntity, StepSimulation)
from simulation_interfaces.msg import SpawnEntity as Order

BALL = '''${ball}'''


class Inspector(Node):
    def __init__(self):
        super().__init__('inspector')
        self.links = {}

    def ask(self, kind, name, request=None):
        if name not in self.links:
            self.links[name] = self.create_client(kind, name)
            self.links[name].wait_for_service()
        future = self.links[name].call_async(request or kind.Request())
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def entities(self, pattern='', category=None):
        request = GetEntities.Request()
        request.filters.filter = pattern
        if category is not None:
            request.filters.categories.append(EntityCategory(category=category))
        answer = self.ask(GetEntities, 'get_entities', request)
        return answer.result.result, list(answer.entities)

    def state(self, name):
        return self.ask(GetEntityState, 'get_entity_state', GetEntityState.Request(entity=name))

    def set_state(self, name, **flags):
        request = SetEntityState.Request(entity=name, **flags)
        request.state.pose.position.x, request.state.pose.position.z = 5.0, 2.0
        request.state.twist.linear.y = 0.5
        return self.ask(SetEntityState, 'set_entity_state', request).result.result

    def turn(self, state):
        request = SetSimulationState.Request(state=SimulationState(state=state))
        return self.ask(SetSimulationState, 'set_simulation_state', request).result.result

    def now(self):
        return self.ask(GetSimulationState, 'get_simulation_state').state.state

    def time(self):
        stamp = self.state('floor').state.header.stamp
        return round(stamp.sec + stamp.nanosec * 1e-9, 3)

    def spawn(self, **fields):
        answer = self.ask(SpawnEntity, 'spawn_entity', SpawnEntity.Request(**fields))
        return answer.result.result, answer.entity_name

    def steps(self, count):
        client = ActionClient(self, SimulateSteps, 'simulate_steps')
        client.wait_for_server()
        heard = []
        sent = client.send_goal_async(SimulateSteps.Goal(steps=count),
                                      feedback_callback=lambda one: heard.append(one.feedback))
        rclpy.spin_until_future_complete(self, sent)
        done = sent.result().get_result_async()
        rclpy.spin_until_future_complete(self, done)
        return done.result().result.result.result, heard[-1].completed_steps if heard else None

    def tell(self, what, *values):
        print(what, *values, flush=True)


def main():
    rclpy.init()
    node = Inspector()
    features = node.ask(GetSimulatorFeatures, 'get_simulator_features').features
    node.tell('formats', list(features.spawn_formats), 33 in features.features)
    node.tell('all', *node.entities())
    node.tell('filtered', node.entities('^w|flo+r'), node.entities(category=EntityCategory.CATEGORY_STATIC_OBJECT),
              node.entities('(')[0])
    info = node.ask(GetEntityInfo, 'get_entity_info', GetEntityInfo.Request(entity='wall'))
    node.tell('wall', info.info.category.category, node.state('nobody').result.result)
    node.tell('plays', node.now(), node.turn(1), node.turn(2), node.now(), node.turn(4))
    before = node.time()
    node.tell('step', node.ask(StepSimulation, 'step_simulation', StepSimulation.Request(steps=25)).result.result,
              round(node.time() - before, 3))
    before = node.time()
    node.tell('steps', *node.steps(2000), round(node.time() - before, 3))
    node.tell('set', node.set_state('crate', set_pose=True), node.set_state('crate', set_twist=True),
              node.set_state('wall', set_twist=True), node.set_state('nobody', set_pose=True),
              node.set_state('crate', set_acceleration=True))
    crate = node.state('crate').state
    node.tell('crate', round(crate.pose.position.x, 3), round(crate.pose.position.z, 3), round(crate.twist.linear.y, 3))
    sdf = Resource(resource_string=BALL)
    node.tell('spawn', node.spawn(entity_resource=sdf), node.spawn(entity_resource=sdf),
              node.spawn(entity_resource=sdf, allow_renaming=True), node.spawn(name='x', entity_resource=Resource(uri='nowhere.sdf')),
              node.spawn(name='y', entity_resource=Resource(resource_string='<sdf')))
    many = SpawnEntities.Request(spawn_requests=[Order(name='one', entity_resource=sdf), Order(name='wall', entity_resource=sdf)])
    answer = node.ask(SpawnEntities, 'spawn_entities', many)
    node.tell('spawned', answer.result.result, [one.result.result for one in answer.results])
    answer = node.ask(GetEntitiesStates, 'get_entities_states')
    node.tell('states', list(answer.entities), len(answer.states))
    node.tell('delete', *[node.ask(DeleteEntity, 'delete_entity', DeleteEntity.Request(entity=name)).result.result
                          for name in ('one', 'one')])
    node.tell('reset', node.ask(ResetSimulation, 'reset_simulation', ResetSimulation.Request(scope=4)).result.result,
              node.entities()[1], round(node.state('crate').state.pose.position.x, 3))
    endless = node.links['step_simulation'].call_async(StepSimulation.Request(steps=2**62))
    before = node.time()
    while node.time() < before + 0.05:
        pass
    stopped = node.turn(0)
    rclpy.spin_until_future_complete(node, endless)
    node.tell('endless', stopped, node.time(), endless.result().result.result, node.turn(1), node.turn(2))
    node.tell('stop', node.turn(0), node.now(), node.time(), round(node.state('crate').state.pose.position.x, 3), node.turn(2))
    node.tell('again', node.turn(1), node.now())
    node.tell('not paused', node.ask(StepSimulation, 'step_simulation').result.result, node.steps(1)[0])
    node.tell('quit', node.turn(3))


main()
`;

let workspace: PackWorkspace;

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('yard', {}, {
    cmake: `install(FILES yard.sdf sim.launch.py DESTINATION share/\${PROJECT_NAME})
install(PROGRAMS inspector DESTINATION lib/\${PROJECT_NAME})\n`,
    depends: ['ros_gz_sim', 'rclpy', 'simulation_interfaces'],
  });
  workspace.write('src/yard/yard.sdf', world);
  workspace.write('src/yard/inspector', `#!/usr/bin/env python3${inspector}`);
  workspace.write('src/yard/sim.launch.py', launch);
  workspace.write('workspace.yaml', 'schema: 1\nname: yard\npackages: [src/*]\nlaunch: src/yard/sim.launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stdout + packed.stderr);
}, watchdog);
after(() => workspace.close());

test('each service and the action of simulation_interfaces does what it says', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--for', '60s']);
  const said = (what: string): string | undefined => run.stdout.split('\n').find((line) => line.includes(`] ${what} `))?.replace(/^.*?\] /, '');
  const expected = [
    "formats ['sdf', 'urdf'] True",
    "all 1 ['floor', 'wall', 'crate']",
    "filtered (1, ['floor', 'wall']) (1, ['floor', 'wall']) 4",
    'wall 5 2',
    'plays 1 101 1 2 103',
    'step 1 0.025',
    'steps 1 2000 2.0',
    'set 1 1 4 2 0',
    'crate 5.0 2.0 0.5',
    "spawn (1, 'ball') (101, '') (1, 'ball_0') (104, '') (106, '')",
    'spawned 150 [1, 101]',
    "states ['floor', 'wall', 'crate', 'ball', 'ball_0', 'one'] 6",
    'delete 1 2',
    "reset 1 ['floor', 'wall', 'crate'] 5.0",
    'endless 1 0.0 4 1 1',
    'stop 1 0 0.0 1.0 103',
    'again 1 1',
    'not paused 4 4',
    'quit 1',
  ];
  const found = expected.map((line) => said(line.slice(0, line.search(/ [\d['(]/))));
  assert.deepEqual(found, expected, run.stdout + run.stderr);
  assert.match(run.stderr, /process has finished cleanly/);
});
