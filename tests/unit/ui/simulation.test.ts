// The panel Simulation below its drawing: what the simulator's hidden topics say, the objects that are added, and its state.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LineSegments, Points } from 'three';
import type { SpotLight } from 'three';
import { SIM_SHAPES, freeName, momentsOf, sdfOf } from '../../../runtime/site/ui/model/sim_shapes.ts';
import { linkOf, modelOf, readPace, SimWorld } from '../../../runtime/site/ui/model/sim_world.ts';
import { readSimulation, writeSimulation } from '../../../runtime/site/ui/model/simulation_options.ts';
import { worldOf } from '../../../runtime/site/ui/parts/sim_client.ts';
import { scanRays } from '../../../runtime/site/ui/scene/scan_rays.ts';
import type { PlacedLight } from '../../../runtime/site/ui/scene/shadow.ts';
import { WorldLights } from '../../../runtime/site/ui/scene/world_lights.ts';

const upright = { x: 0, y: 0, z: 0, w: 1 };
const transform = (parent: string, child: string, x = 0): unknown => ({
  header: { stamp: { sec: 1, nanosec: 0 }, frame_id: parent },
  child_frame_id: child,
  transform: { translation: { x, y: 0, z: 0 }, rotation: upright },
});
const whole = (...links: readonly unknown[]): unknown => ({ transforms: [transform('', 'world'), ...links] });

test('a whole message has the models, others move their links', () => {
  const world = new SimWorld();
  const links = [transform('world', 'rover::base', 1), transform('world', 'rover::arm::hand', 2), transform('world', 'box::link')];
  assert.equal(world.take({ transforms: [transform('world', 'rover::base', 1)] }), 'moved');
  assert.deepEqual(world.models, []);
  assert.equal(world.take(whole(...links, transform('rover::base', 'rover::base::lidar', 0.1))), 'models');
  assert.deepEqual(world.models, [{ name: 'rover', links: ['rover::base', 'rover::arm::hand'] }, { name: 'box', links: ['box::link'] }]);
  assert.equal(world.take(whole(...links, transform('rover::base', 'rover::base::lidar', 0.1))), 'same');
  assert.equal(world.take({ transforms: [transform('world', 'rover::base', 3)] }), 'moved');
  assert.deepEqual(world.place('rover::base')?.translation, [3, 0, 0]);
  assert.ok(world.isInner('rover::base::lidar') && !world.isInner('rover::base'));
  // The box has gone, and what was in it.
  assert.equal(world.take(whole(...links.slice(0, 2))), 'models');
  assert.deepEqual(world.models.map(({ name }) => name), ['rover']);
  assert.equal(world.place('box::link'), undefined);
  assert.ok(!world.tree.has('box::link'));
  assert.deepEqual([modelOf('a::b::c'), linkOf('a::b::c'), modelOf('a'), linkOf('a')], ['a', 'b::c', 'a', '']);
});

test('frames of sensors are found by the names that messages have', () => {
  const world = new SimWorld();
  world.take(whole(
    transform('world', 'a::base'),
    transform('world', 'b::base'),
    transform('b::base', 'b::base::laser_frame'),
    transform('b::base', 'b::base::scan'),
  ));
  assert.equal(world.frameOf('b/base/scan'), 'b::base::scan'); // as Gazebo Sim scopes it
  assert.equal(world.frameOf('/laser_frame'), 'b::base::laser_frame');
  assert.equal(world.frameOf('base'), 'a::base');
  assert.equal(world.frameOf('robot1/laser_frame'), 'b::base::laser_frame');
  assert.equal(world.frameOf('map'), undefined);
  assert.equal(world.frameOf(''), undefined);
});

test('shapes that do not go with their frame are those of static models', () => {
  const world = new SimWorld();
  world.takeShapes({ markers: [{ action: 3 }, { ns: 'wall::link', frame_locked: false }, { ns: 'box::link', frame_locked: true }] });
  assert.deepEqual([world.moves('wall::link'), world.moves('box::link'), world.moves('other::link')], [false, true, true]);
});

// Guarantee, hostile input: messages of a simulator that lie neither throw nor leave anything half done
test('messages that are none change nothing', () => {
  const world = new SimWorld();
  for (const message of [null, 3, {}, { transforms: 3 }, { transforms: [null, {}, { child_frame_id: 'world' }, transform('world', '', NaN)] }]) {
    assert.equal(world.take(message), 'same');
    world.takeShapes(message);
  }
  assert.deepEqual(world.models, []);
  assert.equal(readPace({ header: { stamp: 1 } }), null);
  assert.deepEqual(readPace({ header: { stamp: { sec: 2, nanosec: 500_000_000 } }, real_time_factor: 0.5 }), { time: 2.5, factor: 0.5 });
});

test('an object that is added is solid and even, and has a name of its own', () => {
  // A solid sphere: 2/5 m r^2; a cube: m a^2 / 6; a cylinder about its axis: m r^2 / 2.
  assert.deepEqual(momentsOf('sphere').map((value) => value.toFixed(6)), ['0.009000', '0.009000']);
  assert.deepEqual(momentsOf('box').map((value) => value.toFixed(6)), ['0.015000', '0.015000']);
  assert.deepEqual(momentsOf('cylinder').map((value) => value.toFixed(6)), ['0.013125', '0.011250']);
  for (const shape of SIM_SHAPES) assert.match(sdfOf(shape, 'mine'), new RegExp(`<model name="mine">.*<${shape}>.*</${shape}>`));
  assert.equal(freeName('box', new Set()), 'box');
  assert.equal(freeName('box', new Set(['box', 'box_1', 'box_3'])), 'box_2');
});

test('the state of the panel is read as hostile, and written without what is usual', () => {
  const usual = readSimulation(null);
  assert.ok(usual.flags.shadows && usual.flags.grid && usual.list && !usual.flags.collisions);
  assert.deepEqual(Object.keys(writeSimulation(usual) as object), ['view', 'list']);
  const odd = readSimulation({
    view: { azimuth: 1, elevation: 0.5 },
    shadows: false,
    rays: true,
    grid: 'no',
    follow: 3,
    list: 0,
    images: [{ topic: '/camera' }],
  });
  assert.deepEqual([odd.flags.shadows, odd.flags.rays, odd.flags.grid, odd.follow, odd.list], [false, true, true, '', true]);
  assert.deepEqual(readSimulation(writeSimulation({ ...odd, follow: 'rover::base' })), { ...odd, follow: 'rover::base' });
});

test('without a graphics card shadows are drawn when the visitor wants them', () => {
  const usual = readSimulation(null, false);
  assert.equal(usual.flags.shadows, false);
  assert.deepEqual(Object.keys(writeSimulation(usual, false) as object), ['view', 'list']);
  const wanted = writeSimulation({ ...usual, flags: { ...usual.flags, shadows: true } }, false);
  assert.equal((wanted as { shadows: boolean; }).shadows, true);
  assert.equal(readSimulation(wanted, false).flags.shadows, true);
});

test('lights of the world shine as it says, and a few of them cast shadows', () => {
  const light = (ns: string, more: object = {}): unknown => ({
    header: { frame_id: 'world' },
    action: 0,
    ns,
    pose: { position: { x: 0, y: 0, z: 3 }, orientation: { x: 0, y: Math.SQRT1_2, z: 0, w: Math.SQRT1_2 } },
    scale: { x: 20, y: 1, z: 0.5 },
    color: { r: 0.8, g: 0.4, b: 0, a: 1 },
    points: [{ x: 1, y: 0, z: 0.5 }],
    mesh_use_embedded_materials: true,
    ...more,
  });
  let used: readonly PlacedLight[] = [];
  const lights = new WorldLights((list) => {
    used = list;
  });
  lights.take({
    markers: [{ action: 3 }, light('directional'), light('spot'), light('point'), light('spot', { mesh_use_embedded_materials: false }), light('laser'),
      light('spot', { color: { r: 0, g: -1, b: NaN } }), light('spot', { pose: null })],
  });
  lights.build();
  assert.deepEqual(used.map(({ light: { type }, casts }) => [type, casts]), [['DirectionalLight', true], ['SpotLight', true], ['PointLight', false], [
    'SpotLight',
    false,
  ]]);
  assert.deepEqual(used[0]?.ahead().toArray().map((part) => Math.round(part) + 0), [0, 0, -1]);
  const spot = used[1]?.light as SpotLight;
  assert.ok(Math.abs(spot.intensity - 1.6) < 1e-9 && Math.abs(spot.color.g - 0.5) < 1e-9);
  assert.deepEqual([spot.angle, spot.penumbra, spot.decay, spot.distance], [0.5, 0.5, 2, 20]);
  assert.equal([...lights.anchored()].length, 4);
  // The view's own light is back when the world has none, and many lights are not all drawn.
  lights.take({ markers: Array.from({ length: 20 }, () => light('directional')) });
  lights.build();
  assert.deepEqual([used.length, used.filter(({ casts }) => casts).length], [8, 4]);
  lights.take({ markers: [{ action: 3 }] });
  lights.build();
  assert.deepEqual([used.length, lights.group.children.length], [0, 0]);
  for (const message of [null, {}, { markers: [null, 3] }]) {
    lights.take(message);
    lights.build();
  }
});

test('the world is the one whose control a node offers', () => {
  const offering = (name: string) => ({
    nodes: [{
      name: '/n',
      process: '',
      publishers: [],
      subscriptions: [],
      clients: [],
      actionServers: [],
      actionClients: [],
      services: [{ name, type: 'ros_gz_interfaces/srv/ControlWorld', hash: '', qos: {} as never, gid: '' }],
    }],
  });
  assert.equal(worldOf(offering('/_gz/world/yard/control')), 'yard');
  // A bridge offers it under its plain name; that is not the simulator.
  assert.equal(worldOf(offering('/world/yard/control')), undefined);
});

test('rays go from the sensor to what they met', () => {
  const { object, problem } = scanRays('#ff0000')({
    header: { frame_id: 'a' },
    angle_min: 0,
    angle_increment: Math.PI / 2,
    range_min: 0.1,
    range_max: 10,
    ranges: [2, Infinity, 3],
    intensities: [],
  });
  assert.equal(problem, '');
  const [lines, dots] = object?.children ?? [];
  assert.ok(lines instanceof LineSegments && dots instanceof Points);
  assert.deepEqual(Array.from(lines.geometry.getAttribute('position').array as Float32Array, (value) => Math.round(value) + 0), [0, 0, 0, 2, 0, 0, 0, 0, 0, -3,
    0, 0]);
  assert.equal(dots.geometry.getAttribute('position').count, 2);
  assert.notEqual(scanRays('#ff0000')({}).problem, '');
});
