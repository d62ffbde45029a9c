// The objects that a scene makes from messages: places and colours as in the message, and nothing for values that make no sense.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { InstancedMesh, Matrix4, Mesh, Quaternion, Vector3 } from 'three';
import { eyeOf, USUAL_VIEW, panned, readView, turned, writeView, zoomed } from '../../../runtime/site/ui/model/camera_view.ts';
import { readCovariance } from '../../../runtime/site/ui/model/covariance.ts';
import type { DisplayContext } from '../../../runtime/site/ui/scene/display.ts';
import type { DisplayLook } from '../../../runtime/site/ui/model/display_look.ts';
import { readScan } from '../../../runtime/site/ui/model/laser_scan.ts';
import { readCloud } from '../../../runtime/site/ui/model/point_cloud.ts';
import { readOptions, writeOptions } from '../../../runtime/site/ui/model/scene_options.ts';
import { keyed } from '../../../runtime/site/ui/scene/camera_control.ts';
import { canShow, makeDisplay } from '../../../runtime/site/ui/scene/kinds.ts';
import { Markers } from '../../../runtime/site/ui/scene/markers.ts';
import { MeshShelf } from '../../../runtime/site/ui/scene/mesh_shelf.ts';
import { path, poseArray, singlePose } from '../../../runtime/site/ui/scene/poses.ts';
import { named } from '../../../runtime/site/ui/scene/shapes.ts';

const header = { stamp: { sec: 3, nanosec: 0 }, frame_id: 'map' };
const noMeshes = new MeshShelf({ size: () => undefined, read: () => Promise.reject(new Error('none')) }, () => undefined);
const context = (look: DisplayLook = {}, keep = 1): DisplayContext => ({ colors: { text: '#000', accent: '#fff' }, look, keep, meshes: noMeshes });
const upright = { x: 0, y: 0, z: 0, w: 1 };
const pose = (x: number, y = 0, z = 0): unknown => ({ position: { x, y, z }, orientation: upright });

test('a view turns, moves and zooms within bounds, and is kept', () => {
  const [x, y, z] = eyeOf({ ...USUAL_VIEW, azimuth: 0, elevation: 0, target: [1, 2, 3] });
  assert.deepEqual([x, y, z].map((part) => Number(part.toFixed(6))), [7, 2, 3]);
  let view = USUAL_VIEW;
  for (let i = 0; i < 100; i += 1) view = turned(view, 37, 500, 400);
  assert.ok(view.elevation < Math.PI / 2 && Math.abs(view.azimuth) <= Math.PI);
  for (let i = 0; i < 500; i += 1) view = zoomed(view, 0.5);
  assert.ok(view.distance > 0);
  for (let i = 0; i < 500; i += 1) view = zoomed(view, 2);
  view = panned(view, 1e12, -1e12, 1);
  assert.ok(view.target.every((part) => Math.abs(part) <= 1e6));
  assert.deepEqual(zoomed(view, NaN), view);
  // From above the ground follows the pointer: half a picture is half of what is seen.
  const top = panned({ ...USUAL_VIEW, top: true }, 100, 0, 200);
  assert.ok(Math.abs(top.target[0] + USUAL_VIEW.distance * Math.tan(Math.PI / 8)) < 1e-9);
  assert.equal(top.target[1], 0);
  assert.deepEqual(readView(writeView({ ...USUAL_VIEW, azimuth: Math.PI, elevation: 1.5697963 })).azimuth, 3.141);
  assert.deepEqual(readView({ distance: -1, azimuth: 'no', x: Infinity, top: 7 }), USUAL_VIEW);
  assert.equal(keyed(USUAL_VIEW, 'Home', false, 400), 'home');
  assert.equal(keyed(USUAL_VIEW, 'a', false, 400), null);
});

test('what the panel keeps is read as it was written, and from links with care', () => {
  const options = readOptions(writeOptions(readOptions({ frame: 'odom', topics: ['/scan'], grid: false, keep: 7 })));
  assert.deepEqual([options.frame, options.topics, options.grid, options.keep], ['odom', ['/scan'], false, 7]);
  for (const keep of [0, -1, 1e9, NaN, 'many']) assert.equal(readOptions({ keep }).keep, 100);
  assert.deepEqual(readOptions(writeOptions(options)), options);
  assert.equal(readOptions(null).topics, null);
  assert.deepEqual(readOptions({ topics: 7, view: [], goal: {} }).topics, []);
  assert.ok(JSON.stringify(writeOptions(options)).length < 1000);
});

test('beams of a scan stand at their angles, without those that hit nothing', () => {
  const scan = {
    header,
    angle_min: 0,
    angle_increment: Math.PI / 2,
    range_min: 0.1,
    range_max: 10,
    ranges: Float32Array.of(1, 2, Infinity, 3, NaN, 0.01, 11, -1),
  };
  const read = readScan(scan) ?? assert.fail();
  assert.deepEqual([...read.positions].map((value) => Number(value.toFixed(4)) + 0), [1, 0, 0, 0, 2, 0, 0, -3, 0]);
  assert.deepEqual([[...read.sources], read.colors], [[0, 1, 3], null]);
  assert.equal(readScan({ ...scan, angle_increment: NaN }), null);
  assert.equal(readScan({}), null);
  // By what came back, least violet and most red; by a field that is missing all are alike.
  const strong = readScan({ ...scan, intensities: Float32Array.of(5, 5, 0, 25, 0, 0, 0, 0) }, { channel: 'intensity' });
  assert.deepEqual([...(strong?.colors ?? [])], [0.5, 0, 1, 0.5, 0, 1, 1, 0, 0]);
  assert.equal(new Set(readScan(scan, { channel: 'intensity' })?.colors ?? []).size <= 3, true);
});

function cloud(fields: readonly (readonly [string, number, number])[], step: number, data: Uint8Array, more: object = {}): unknown {
  return {
    header,
    height: 1,
    width: data.length / step,
    point_step: step,
    row_step: data.length,
    is_bigendian: false,
    data,
    fields: fields.map(([name, offset, datatype]) => ({ name, offset, datatype, count: 1 })),
    ...more,
  };
}

test('points of a cloud have their places and colours, in any layout', () => {
  const bytes = new Uint8Array(32);
  const view = new DataView(bytes.buffer);
  for (const [index, value] of [1, 2, 3].entries()) view.setFloat32(index * 4, value, true);
  view.setUint32(12, 0xff8000, true);
  for (const [index, value] of [4, NaN, 6].entries()) view.setFloat32(16 + index * 4, value, true);
  const fields = [['x', 0, 7], ['y', 4, 7], ['z', 8, 7], ['rgb', 12, 7]] as const;
  const found = readCloud(cloud(fields, 16, bytes));
  assert.ok(typeof found !== 'string');
  assert.deepEqual([[...found.positions], found.coloredBy], [[1, 2, 3], 'rgb']);
  assert.deepEqual([...(found.colors ?? [])].map((part) => Number(part.toFixed(3))), [1, 0.502, 0]);

  // Big-endian 16-bit places with an intensity of 8 bits: least violet, most red.
  const small = Uint8Array.of(0, 1, 0, 2, 0, 3, 10, 0, 4, 0, 5, 0, 6, 200);
  const other = readCloud(cloud([['x', 0, 3], ['y', 2, 3], ['z', 4, 3], ['intensity', 6, 2]], 7, small, { is_bigendian: true }));
  assert.ok(typeof other !== 'string');
  assert.deepEqual([[...other.positions], other.coloredBy], [[1, 2, 3, 4, 5, 6], 'intensity']);
  assert.deepEqual([...(other.colors ?? [])], [0.5, 0, 1, 1, 0, 0]);
});

test('clouds whose sizes lie give what they hold', () => {
  const fields = [['x', 0, 7], ['y', 4, 7], ['z', 8, 7]] as const;
  const data = new Uint8Array(24);
  const lies: readonly object[] = [
    { width: 4e9, height: 4e9 },
    { row_step: 4e9 },
    { width: 1, height: 1e9, row_step: 0 },
    { width: 0, height: 5 },
    { width: 1e9, height: 0 },
  ];
  for (const lie of lies) {
    const found = readCloud(cloud(fields, 12, data, lie));
    assert.ok(typeof found !== 'string' && found.positions.length <= 6, JSON.stringify(lie));
  }
  assert.equal(readCloud(cloud(fields, 12, data, { point_step: 0 })), 'no-data');
  assert.equal(readCloud(cloud([['x', 0, 7], ['y', 4, 7], ['z', 9, 7]], 12, data)), 'no-places');
  assert.equal(readCloud(cloud([['x', -4, 7], ['y', 4, 7], ['z', 8, 99]], 12, data)), 'no-places');
  assert.equal(readCloud({ data: 'text' }), 'no-data');
  assert.equal(readCloud(null), 'no-data');
  const many = readCloud(cloud(fields, 12, new Uint8Array(12 * 1_000_010)));
  assert.ok(typeof many !== 'string' && many.leftOut === 10);
});

/** A covariance of place (x, y) and heading. */
function covariance(xx: number, xy: number, yy: number, yaw: number): Float64Array {
  const all = new Float64Array(36);
  [all[0], all[1], all[6], all[7], all[35]] = [xx, xy, xy, yy, yaw];
  return all;
}

test('how sure a pose is stands around it as an ellipse and a sector, of one standard deviation', () => {
  assert.deepEqual(readCovariance(covariance(0.25, 0, 0.0625, 0.0625)), { ellipse: { radii: [0.5, 0.25], angle: 0 }, heading: 0.25 });
  // Along a diagonal: the variance is 1 along it and 0.5 across.
  const turned = readCovariance([...covariance(0.75, 0.25, 0.75, 0)])?.ellipse ?? assert.fail();
  assert.deepEqual([...turned.radii, turned.angle].map((value) => value.toFixed(6)), ['1.000000', '0.707107', (Math.PI / 4).toFixed(6)]);
  // The longer axis is along y.
  assert.equal(readCovariance(covariance(0.04, 0, 0.25, 0))?.ellipse?.angle, Math.PI / 2);
  const quarter = { x: 0, y: 0, z: Math.SQRT1_2, w: Math.SQRT1_2 };
  const told = { pose: { position: { x: 1, y: 2, z: 3 }, orientation: quarter }, covariance: covariance(0.25, 0, 0.0625, 0.0625) };
  const { object } = singlePose(named('#fff'))({ header, pose: told });
  const [pointer, ellipse, sector] = object?.children ?? [];
  assert.deepEqual(object?.position.toArray(), [1, 2, 3]);
  // The ellipse is told in the frame of the message, whatever the pose's heading.
  assert.deepEqual([ellipse?.scale.toArray(), ellipse?.rotation.z], [[0.5, 0.25, 1], 0]);
  assert.ok(Math.abs((sector?.rotation.z ?? 0) - Math.PI / 2) < 1e-9 && Math.abs((pointer?.rotation.z ?? 0) - Math.PI / 2) < 1e-9);
});

test('odometry leaves arrows where it has been, as many as are kept', () => {
  const odometry = makeDisplay('/odom', 'nav_msgs/msg/Odometry', context({}, 4)) ?? assert.fail();
  const told = (x: number, frame = 'odom'): unknown => ({ header: { ...header, frame_id: frame }, pose: { pose: pose(x), covariance: [] } });
  const places = (): readonly number[] => {
    odometry.build(0);
    const found: number[] = [];
    odometry.group.traverse((part) => {
      if (!(part instanceof InstancedMesh)) return;
      const matrix = new Matrix4();
      for (let i = 0; i < part.count; i += 1) {
        part.getMatrixAt(i, matrix);
        found.push(Number(new Vector3().setFromMatrixPosition(matrix).x.toFixed(3)));
      }
    });
    return found;
  };
  assert.deepEqual([...odometry.anchored()], []);
  // 0.05 is too near to what was before.
  for (const x of [0, 0.05, 0.5]) odometry.take(told(x));
  assert.deepEqual(places(), [0]);
  for (const x of [1, 2, NaN, 1e300, 3]) odometry.take(told(x));
  assert.deepEqual(places(), [0.5, 1, 2]);
  assert.deepEqual([...odometry.anchored()].map(({ header: { frame } }) => frame), ['odom']);
  // Turning on the spot counts, too.
  odometry.take({ header, pose: { pose: { position: { x: 3, y: 0, z: 0 }, orientation: { x: 0, y: 0, z: 0.1, w: 0.995 } } } });
  assert.deepEqual(places(), []); // in another frame
  odometry.take({ header, pose: { pose: pose(3) } });
  assert.deepEqual(places(), [3]);
  odometry.close();
});

test('a covariance that is none draws nothing', () => {
  const nothing = [
    covariance(0, 0, 0, 0),
    covariance(NaN, 0, 1, NaN),
    covariance(-1, 0, 1, -1),
    covariance(1, 5, 1, 0),
    covariance(1e12, 0, 1e12, 0),
    covariance(Infinity, 0, 1, Infinity),
    new Float64Array(35),
    [],
    'text',
    null,
    Array.from({ length: 36 }, () => 'no'),
  ];
  for (const wrong of nothing) {
    assert.equal(readCovariance(wrong), null);
    assert.ok(singlePose(named('#fff'))({ header, pose: { pose: pose(4), covariance: wrong } }).object instanceof Mesh);
  }
  // The covariance of an unknown heading.
  assert.equal(readCovariance(covariance(0, 0, 0, 1e6))?.heading, Math.PI);
});

test('poses stand where they are told, and what is none is said', () => {
  const color = named('#fff');
  assert.deepEqual(singlePose(color)({ header, pose: pose(1, 2, 3) }).object?.position.toArray(), [1, 2, 3]);
  // As in odometry: within a pose with its covariance.
  assert.deepEqual(singlePose(color)({ header, pose: { pose: pose(4), covariance: [] } }).object?.position.toArray(), [4, 0, 0]);
  for (const wrong of [{}, null, { pose: pose(NaN) }, { pose: pose(1e300) }, { pose: { position: 1 } }])
    assert.notEqual(singlePose(color)(wrong).problem, '');
  const array = poseArray(color)({ header, poses: [pose(1), pose(NaN), pose(2)] }).object;
  assert.ok(array instanceof InstancedMesh && array.count === 2);
  assert.notEqual(poseArray(color)({ poses: 'no' }).problem, '');
  const line = path(color)({ header: { ...header, frame_id: '' }, poses: [{ header, pose: pose(1) }, { header, pose: pose(2) }] });
  assert.equal(line.header?.frame, 'map');
  assert.equal(path(color)({ header, poses: [] }).problem, '');
  assert.equal(path(color)({}).problem, 'no pose');
});

const marker = (id: number, more: object = {}): unknown => ({
  header,
  ns: 'n',
  id,
  type: 1,
  action: 0,
  pose: pose(id),
  scale: { x: 1, y: 1, z: 1 },
  color: { r: 1, g: 0, b: 0, a: 1 },
  lifetime: { sec: 0, nanosec: 0 },
  frame_locked: false,
  points: [],
  colors: [],
  text: '',
  mesh_resource: '',
  ...more,
});

test('markers are added, changed and deleted, and end with their lifetime', () => {
  const display = new Markers(noMeshes);
  const shown = (): readonly number[] => [...display.anchored()].map(({ object }) => object.children[0]?.position.x ?? NaN);
  display.take({ markers: [marker(1), marker(2), marker(3, { lifetime: { sec: 2, nanosec: 0 } })] });
  assert.equal(display.build(100), 102);
  assert.deepEqual(shown(), [1, 2, 3]);
  display.take(marker(2, { pose: pose(20) }));
  display.take(marker(1, { action: 2 }));
  assert.equal(display.build(101), 102);
  assert.deepEqual(shown(), [20, 3]);
  assert.equal(display.build(102), undefined);
  assert.deepEqual(shown(), [20]);
  display.take({ markers: [marker(0, { action: 3 }), marker(9)] });
  display.build(103);
  assert.deepEqual(shown(), [9]);
  // Locked to its frame, it is where the frame is now.
  display.take(marker(9, { frame_locked: true }));
  display.build(104);
  assert.ok([...display.anchored()].every(({ header: { stamp } }) => Number.isNaN(stamp)));
  display.close();
  assert.equal(display.group.children.length, 0);
});

test('every type of marker is drawn, with points and colours that make no sense too', () => {
  const points = [{ x: 0, y: 0, z: 0 }, { x: 1, y: 0, z: 0 }, { x: 0, y: 1, z: 0 }, { x: NaN, y: 0, z: 0 }, { x: 1e300, y: 0, z: 0 }, null];
  for (const type of [0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 12]) {
    for (const more of [{ points: [] }, { points }, { points, colors: points.map(() => ({ r: 9, g: NaN, b: -1, a: 1 })) }, { points: 'no' }]) {
      const display = new Markers(noMeshes);
      display.take(marker(1, { type, ...more }));
      display.build(0);
      assert.equal(display.problem, '', String(type));
      assert.equal([...display.anchored()].length, 1, String(type));
    }
  }
  for (const wrong of [{ type: 10 }, { type: 99 }, { pose: null }, { scale: { x: NaN, y: 0, z: 0 } }, { scale: { x: 1e30, y: 0, z: 0 } }]) {
    const display = new Markers(noMeshes);
    display.take(marker(1, wrong));
    display.build(0);
    assert.notEqual(display.problem, '');
  }
  const display = new Markers(noMeshes);
  for (const nothing of [null, 7, {}, { markers: [null, {}] }]) display.take(nothing);
  display.take({ markers: Array.from({ length: 6000 }, (_, id) => marker(id)) });
  display.build(0);
  assert.equal([...display.anchored()].length, 5000);
  assert.equal(display.problem, 'too many markers');
});

const row = (count: number): unknown => Array.from({ length: count }, (_, x) => ({ x, y: 0, z: 0 }));

test('a strip of arrows is drawn at once, each from its point to the next', () => {
  const display = new Markers(noMeshes);
  display.take(
    marker(1, {
      type: 12,
      scale: { x: 0.1, y: 0.2, z: 0.25 },
      points: [{ x: 1, y: 0, z: 0 }, { x: 1, y: 0, z: 0 }, { x: 1, y: 2, z: 0 }, { x: 3, y: 2, z: 0 }],
    }),
  );
  display.build(0);
  const found: InstancedMesh[] = [];
  display.group.traverse((each) => {
    if (each instanceof InstancedMesh) found.push(each);
  });
  // One that goes nowhere is none.
  assert.deepEqual(found.map(({ count }) => count), [2, 2]);
  const places = found.map((each) =>
    [0, 1].map((index) => {
      const [matrix, at, turn, size] = [new Matrix4(), new Vector3(), new Quaternion(), new Vector3()];
      each.getMatrixAt(index, matrix);
      matrix.decompose(at, turn, size);
      return [...at.toArray(), ...size.toArray()].map((part) => Number(part.toFixed(4)) + 0);
    })
  );
  assert.deepEqual(places, [
    [[1, 0, 0, 1.75, 0.1, 0.1], [1, 2, 0, 1.75, 0.1, 0.1]],
    [[1, 1.75, 0, 0.25, 0.2, 0.2], [2.75, 2, 0, 0.25, 0.2, 0.2]],
  ]);
  display.close();
});

test('hostile markers are bounded together, and leave room when they go', () => {
  for (
    const [more, fit] of [
      [{ type: 6, points: row(20_000) }, 5],
      [{ type: 12, points: row(20_000) }, 5],
      [{ type: 4, points: row(200_000) }, 5],
    ] as const
  ) {
    const display = new Markers(noMeshes);
    const shown = (): number => [...display.anchored()].length;
    for (let id = 0; id < 8; id += 1) display.take(marker(id, more));
    display.build(0);
    assert.deepEqual([shown(), display.problem], [fit, 'too many markers']);
    for (let id = 0; id < 8; id += 1) display.take(marker(id, { action: 2 }));
    display.take(marker(9, more));
    display.build(1);
    assert.deepEqual([shown(), display.problem], [1, '']);
    // Said again it is the same one.
    for (let i = 0; i < 8; i += 1) {
      display.take(marker(9, more));
      display.build(2 + i);
    }
    assert.deepEqual([shown(), display.problem], [1, '']);
    display.close();
  }
});

test('topics that can be shown are known by their type, robots by their name too', () => {
  assert.ok(canShow('/scan', 'sensor_msgs/msg/LaserScan'));
  assert.ok(canShow('/robot1/robot_description', 'std_msgs/msg/String'));
  assert.ok(!canShow('/chatter', 'std_msgs/msg/String'));
  assert.equal(makeDisplay('/chatter', 'std_msgs/msg/String', context()), null);
  const display = makeDisplay('/plan', 'nav_msgs/msg/Path', context());
  display?.take({ header, poses: [] });
  display?.build(0);
  assert.equal(display?.problem, '');
});
