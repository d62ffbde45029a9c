// How displays of a scene look by their settings, maps with their updates, and measurements that are one small shape.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, DataTexture, Group, InstancedMesh, Mesh, Points } from 'three';
import type { BufferGeometry, MeshBasicMaterial, Object3D, PointsMaterial } from 'three';
import type { DisplayLook } from '../../../runtime/site/ui/model/display_look.ts';
import { readLook, readLooks, withLook, writeLooks } from '../../../runtime/site/ui/model/display_look.ts';
import { pointValues } from '../../../runtime/site/ui/model/point_cloud.ts';
import { readOptions, writeOptions } from '../../../runtime/site/ui/model/scene_options.ts';
import type { Display, DisplayContext } from '../../../runtime/site/ui/scene/display.ts';
import { makeDisplay, settingsOf, updatesOf } from '../../../runtime/site/ui/scene/kinds.ts';
import { MeshShelf } from '../../../runtime/site/ui/scene/mesh_shelf.ts';
import { estimateValue } from '../../../runtime/site/ui/scene/tools.ts';

const meshes = new MeshShelf({ size: () => undefined, read: () => Promise.reject(new Error('none')) }, () => undefined);
const header = { stamp: { sec: 3, nanosec: 0 }, frame_id: 'map' };
const upright = { x: 0, y: 0, z: 0, w: 1 };
const pose = (x: number, y = 0, z = 0): unknown => ({ position: { x, y, z }, orientation: upright });

/** The display, and what makes it look otherwise. */
function shown(topic: string, type: string): readonly [Display, (look: DisplayLook) => void] {
  let look: DisplayLook = {};
  const context: DisplayContext = {
    colors: { text: '#000', accent: '#ffffff' },
    get look() {
      return look;
    },
    keep: 1,
    meshes,
  };
  const display = makeDisplay(topic, type, context) ?? assert.fail(type);
  return [display, (next) => {
    look = next;
    display.repaint();
  }];
}

function all<T extends Object3D>(display: Display, isKind: (one: Object3D) => one is T): readonly T[] {
  const found: T[] = [];
  display.group.traverse((one) => {
    if (isKind(one)) found.push(one);
  });
  return found;
}
const isPoints = (one: Object3D): one is Points<BufferGeometry, PointsMaterial> => one instanceof Points;
const isMesh = (one: Object3D): one is Mesh<BufferGeometry, MeshBasicMaterial> => one instanceof Mesh;
const isCopies = (one: Object3D): one is InstancedMesh => one instanceof InstancedMesh;
const isGroup = (one: Object3D): one is Group => one instanceof Group;

test('looks are read with care, kept short, and changed one by one', () => {
  const look = { size: 7, color: '#ff0000', alpha: 0.5, decay: 2, channel: 'x', least: -1, most: 4, scheme: 'costmap', hideVisual: true, collision: true };
  assert.deepEqual(readLook(look), look);
  assert.deepEqual(readLook({ size: 0, color: 'red;', alpha: 2, decay: -1, channel: 7, least: NaN, most: 'x', scheme: 'no', hideVisual: 1 }), {});
  for (const odd of [null, 7, 'no', [], { '/a': null, '/b': {} }]) assert.deepEqual(readLooks(odd), {});
  const looks = withLook(withLook({}, '/a', { size: 5, alpha: 0.5 }), '/a', { alpha: undefined });
  assert.deepEqual(looks, { '/a': { size: 5 } });
  assert.deepEqual(withLook(looks, '/a', { size: undefined }), {});
  const options = readOptions({
    looks,
    images: [{ topic: '/i', size: 'large' }, { topic: '/j', size: 'vast' }, 7, {}],
    variance: { x: 1, y: -1 },
    follow: 'base',
  });
  assert.deepEqual(options.images, [{ topic: '/i', size: 'large' }, { topic: '/j', size: 'small' }]);
  assert.deepEqual(options.variance, { x: 1, y: 0.25, yaw: 0.06853891909122467 });
  const again = readOptions(writeOptions(options));
  assert.deepEqual({ ...again, view: options.view }, options);
  assert.ok(JSON.stringify(writeOptions(readOptions(null))).length < 500);
  assert.equal(Object.keys(writeLooks(Object.fromEntries(Array.from({ length: 500 }, (_, i) => [`/t${i}`, { size: 5 }]))) ?? {}).length, 100);
});

function scan(count: number): unknown {
  return {
    header,
    angle_min: 0,
    angle_increment: 0.01,
    range_min: 0,
    range_max: 10,
    ranges: new Float32Array(count).fill(2),
    intensities: Float32Array.from({ length: count }, (_, i) => i),
  };
}

test('points have the size, colour and opacity that were set, in buffers that serve the next message', () => {
  const [display, look] = shown('/scan', 'sensor_msgs/msg/LaserScan');
  display.take(scan(100));
  display.build(0);
  const [points] = all(display, isPoints);
  const buffer = points?.geometry.getAttribute('position').array;
  for (let i = 0; i < 5; i += 1) {
    display.take(scan(90 + i));
    display.build(i);
  }
  assert.equal(all(display, isPoints)[0], points);
  assert.equal(points?.geometry.getAttribute('position').array, buffer);
  assert.equal(points?.geometry.drawRange.count, 94);
  look({ size: 9, color: '#ff0000', alpha: 0.25 });
  display.build(6);
  const { material } = points ?? assert.fail();
  assert.deepEqual([material.size, material.opacity, material.transparent, material.vertexColors, material.color.getHexString()], [9, 0.25, true, false,
    'ff0000']);
  look({ channel: 'intensity', least: 0, most: 1000 });
  display.build(7);
  assert.ok(material.vertexColors);
  // All are near to the first colour: violet.
  const colors = points.geometry.getAttribute('color').array;
  assert.ok((colors[3 * 90 + 2] ?? 0) > 0.9 && (colors[3 * 90] ?? 1) < 0.5);
  assert.deepEqual([...(display.describe?.(points, 5) ?? [])].map(([name, value]) => `${name} ${Number(value).toFixed(2)}`), ['beam 5.00', 'angle 0.05',
    'range 2.00', 'intensity 5.00']);
  // More than there is room for.
  display.take(scan(1000));
  display.build(8);
  assert.equal(points.geometry.getAttribute('position').array.length >= 3000, true);
  display.take({});
  display.build(9);
  assert.deepEqual([display.problem, points.geometry.drawRange.count], ['no laser scan', 0]);
  display.close();
  assert.equal(display.group.children.length, 0);
});

test('messages stay as long as was set, each where its frame was, and the newest one for good', () => {
  const [display, look] = shown('/cloud', 'sensor_msgs/msg/PointCloud2');
  const cloud = (x: number): unknown => ({
    header: { ...header, frame_id: `f${x}` },
    height: 1,
    width: 1,
    point_step: 16,
    row_step: 16,
    is_bigendian: false,
    data: new Uint8Array(Float32Array.of(x, 0, 0, 7).buffer),
    fields: ['x', 'y', 'z', 'ring'].map((name, index) => ({ name, offset: index * 4, datatype: 7, count: 1 })),
  });
  const frames = (): readonly string[] => [...display.anchored()].map(({ header: { frame } }) => frame);
  look({ decay: 2 });
  for (const now of [0, 1]) {
    display.take(cloud(now));
    assert.equal(display.build(now), now === 0 ? undefined : 2);
  }
  assert.deepEqual(frames(), ['f0', 'f1']);
  assert.equal(display.build(2.5), undefined);
  assert.deepEqual(frames(), ['f1']);
  display.take(cloud(3));
  display.build(3);
  assert.deepEqual(frames(), ['f3']);
  assert.equal(display.build(1000), undefined);
  assert.deepEqual(frames(), ['f3']);
  assert.deepEqual([...pointValues(cloud(5), 0)], [['x', 5], ['y', 0], ['z', 0], ['ring', 7]]);
  assert.equal(pointValues(cloud(5), 9).size, 0);
  assert.equal(pointValues(null, 0).size, 0);
});

const UPDATE = 'map_msgs/msg/OccupancyGridUpdate';
const grid = (more: object = {}, data: unknown = Int8Array.of(0, 100, -1, 50)): unknown => ({
  header,
  info: { width: 2, height: 2, resolution: 0.5, origin: pose(-1, -1), ...more },
  data,
});

test('a map has its cells in their colours, the first one at its origin, and takes updates', () => {
  const [display, look] = shown('/map', 'nav_msgs/msg/OccupancyGrid');
  assert.equal(updatesOf('/map', 'nav_msgs/msg/OccupancyGrid'), '/map_updates');
  assert.equal(updatesOf('/scan', 'sensor_msgs/msg/LaserScan'), '');
  const cells = (): readonly number[] => {
    display.build(0);
    const [ground] = all(display, isMesh);
    assert.ok(ground?.material.map instanceof DataTexture);
    return [...(ground.material.map.image as { data: Uint8Array; }).data];
  };
  display.take({ header, x: 0, y: 0, width: 1, height: 1, data: Int8Array.of(0) }); // of a map that is not there yet
  assert.equal([...display.anchored()].length, 0);
  display.take(grid());
  assert.deepEqual(cells(), [255, 255, 255, 255, 0, 0, 0, 255, 112, 137, 134, 255, 128, 128, 128, 255]);
  assert.deepEqual(all(display, isMesh)[0]?.position.toArray(), [-1, -1, 0]);
  const [before] = all(display, isMesh);
  display.take({ header, x: 1, y: 0, width: 1, height: 2, data: Int8Array.of(0, 100) });
  assert.deepEqual(cells(), [255, 255, 255, 255, 255, 255, 255, 255, 112, 137, 134, 255, 0, 0, 0, 255]);
  assert.equal(all(display, isMesh)[0], before); // only its picture is another
  for (const lie of [{ x: 2 }, { width: 9 }, { data: Int8Array.of(1) }, { y: -1 }, { width: NaN }]) {
    display.take(grid());
    display.take({ header, x: 0, y: 0, width: 2, height: 2, data: Int8Array.of(9, 9, 9, 9), ...lie });
    assert.equal(display.problem, 'an update does not fit the map', `${UPDATE} ${JSON.stringify(lie)}`);
  }
  // Costmaps: free is seen through, then blue to red, inscribed, lethal; unknown is as in maps.
  look({ scheme: 'costmap', alpha: 0.5 });
  display.take(grid({ width: 3 }, Int8Array.of(0, 1, 98, 99, 100, -1)));
  assert.deepEqual(cells(), [0, 0, 0, 0, 3, 0, 252, 255, 250, 0, 5, 255, 0, 255, 255, 255, 255, 0, 255, 255, 112, 137, 134, 255]);
  look({ scheme: 'raw' });
  assert.deepEqual(cells().slice(4, 8), [1, 1, 1, 255]);
  const lies: readonly unknown[] = [
    grid({ width: 3 }),
    grid({ width: 65536, height: 65536 }),
    grid({ resolution: NaN }),
    grid({ resolution: 0 }),
    grid({ resolution: 1e30 }),
    grid({ origin: pose(NaN) }),
    grid({}, [0, 0, 0, 0]),
    grid({ width: 0, height: 0 }, new Int8Array(0)),
    {},
    null,
  ];
  for (const lie of lies) {
    display.take(lie);
    display.build(0);
    assert.deepEqual([display.problem, [...display.anchored()].length], ['its cells do not fit its size', 0]);
  }
  display.take(grid({ width: 5000, height: 2 }, new Int8Array(10_000)));
  display.build(0);
  assert.match(display.problem, /one of 2 cells/);
});

const vector = (x: number, y = 0, z = 0): unknown => ({ x, y, z });

test('points, polygons, ranges, forces, velocities and cells have the size that is told', () => {
  const size = (type: string, message: object): readonly number[] => {
    const [display] = shown('/t', type);
    display.take({ header, ...message });
    display.build(0);
    assert.equal(display.problem, '', type);
    const box = new Box3().setFromObject(display.group);
    return [...box.min.toArray(), ...box.max.toArray()].map((part) => Number(part.toFixed(2)) + 0);
  };
  assert.deepEqual(size('geometry_msgs/msg/PointStamped', { point: vector(1, 2, 3) }), [0.8, 1.8, 2.8, 1.2, 2.2, 3.2]);
  const cone = { field_of_view: Math.PI / 2, min_range: 0.1, max_range: 4, range: 2 };
  assert.deepEqual(size('sensor_msgs/msg/Range', cone), [0, -2, -2, 2, 2, 2]);
  const nothing = size('sensor_msgs/msg/Range', { ...cone, range: Infinity });
  assert.equal(nothing[0], Infinity); // nothing is there
  const [, , , forward] = size('geometry_msgs/msg/WrenchStamped', { wrench: { force: vector(1.5), torque: vector(0, 0, 0) } });
  assert.equal(forward, 3);
  const twist = size('geometry_msgs/msg/TwistStamped', { twist: { linear: vector(2), angular: vector(0, 0, 3) } });
  assert.deepEqual([twist[3], twist[5]], [2, 3]);
  const accel = size('geometry_msgs/msg/AccelStamped', { accel: { linear: vector(0, -2), angular: vector(0) } });
  assert.equal(accel[1], -2);
  const [cells] = shown('/cells', 'nav_msgs/msg/GridCells');
  cells.take({ header, cell_width: 0.5, cell_height: 0.5, cells: [vector(1), vector(NaN), vector(2)] });
  cells.build(0);
  assert.equal(all(cells, isCopies)[0]?.count, 2);
  const [polygon] = shown('/footprint', 'geometry_msgs/msg/PolygonStamped');
  polygon.take({ header, polygon: { points: [vector(0), vector(1), vector(1, 1)] } });
  polygon.build(0);
  const [edge] = all(polygon, isMesh);
  assert.equal((edge?.geometry as { instanceCount?: number; } | undefined)?.instanceCount, 3); // it is closed
});

test('measurements that make no sense are said', () => {
  const kinds = ['PointStamped', 'PolygonStamped', 'WrenchStamped', 'TwistStamped', 'AccelStamped'].map((name) => `geometry_msgs/msg/${name}`);
  for (const type of [...kinds, 'sensor_msgs/msg/Range', 'nav_msgs/msg/GridCells']) {
    for (const wrong of [null, {}, { point: vector(NaN), polygon: { points: 7 }, wrench: { force: vector(1e300) }, twist: 7, cells: [], cell_width: -1 }]) {
      const [display] = shown('/t', type);
      display.take(wrong);
      display.build(0);
      assert.notEqual(display.problem, '', `${type} ${JSON.stringify(wrong)}`);
    }
  }
});

test('a robot shows its shapes for collisions, for seeing, both or none', () => {
  const [display, look] = shown('/robot_description', 'std_msgs/msg/String');
  display.take({
    data: `<robot name="r"><link name="a">
    <visual><geometry><box size="1 1 1"/></geometry></visual><collision><geometry><box size="2 2 2"/></geometry></collision></link>
    <link name="b"><collision><geometry><sphere radius="3"/></geometry></collision></link></robot>`,
  });
  const sizes = (): readonly number[] => {
    display.build(0);
    return all(display, isGroup).filter(({ parent }) => parent === display.group).map((link) => {
      const { min, max } = new Box3().setFromObject(link);
      return Number((max.x - min.x).toFixed(1));
    });
  };
  assert.deepEqual(sizes(), [1]);
  look({ collision: true });
  assert.deepEqual(sizes(), [2, 6]);
  look({ hideVisual: true });
  assert.deepEqual(sizes(), []);
  look({ alpha: 0.5 });
  assert.deepEqual(sizes(), [1]);
  assert.deepEqual(all(display, isMesh).map(({ material }) => material.opacity), [0.5]);
});

test('each kind has the settings that it minds, and an estimate the covariance of RViz', () => {
  assert.deepEqual(settingsOf('/c', 'sensor_msgs/msg/PointCloud2'), ['size', 'color', 'alpha', 'decay', 'channel']);
  assert.deepEqual(settingsOf('/m', 'nav_msgs/msg/OccupancyGrid'), ['alpha', 'scheme']);
  assert.deepEqual(settingsOf('/m', 'visualization_msgs/msg/Marker'), []);
  const { covariance } = estimateValue({ place: [1, 2, 0], heading: 0 }, readOptions(null).variance) as { covariance: readonly number[]; };
  assert.deepEqual([covariance.length, covariance[0], covariance[7], covariance[35]], [36, 0.25, 0.25, 0.06853891909122467]);
  assert.equal(covariance.filter((value) => value !== 0).length, 3);
});
