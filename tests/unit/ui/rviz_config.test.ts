// The scene that an .rviz file describes, and files that describe none.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { DRAWN, readRviz } from '../../../runtime/site/ui/model/rviz_config.ts';

const FILE = `
Panels:
  - Class: rviz_common/Displays
    Name: Displays
Visualization Manager:
  Class: ""
  Displays:
    - {Class: rviz_default_plugins/Grid, Enabled: true, Name: Grid, Cell Size: 1}
    - Class: rviz_default_plugins/RobotModel
      Description Topic: {Depth: 5, Durability Policy: Volatile, Value: /robot_description}
      Enabled: true
      Name: RobotModel
    - Class: rviz_common/Group
      Enabled: true
      Name: Sensors
      Displays:
        - {Class: rviz_default_plugins/LaserScan, Enabled: true, Name: LaserScan, Topic: {Value: scan}}
        - {Class: rviz_default_plugins/PointCloud2, Enabled: false, Name: Cloud, Topic: {Value: /points}}
    - {Class: rviz_common/Group, Enabled: false, Displays: [{Class: rviz_default_plugins/Map, Enabled: true, Topic: {Value: /hidden}}]}
    - {Class: rviz/Map, Enabled: true, Name: Map, Topic: /map}
    - {Class: rviz_default_plugins/TF, Enabled: true, Name: TF, Show Names: false}
    - {Class: rviz_default_plugins/Odometry, Enabled: true, Name: Odometry, Keep: 7, Topic: {Value: /odom}}
    - {Class: nav2_rviz_plugins/ParticleCloud, Enabled: true, Name: Swarm}
  Enabled: true
  Global Options: {Background Color: 48; 48; 48, Fixed Frame: /odom, Frame Rate: 30}
  Tools:
    - Class: rviz_default_plugins/Interact
    - Class: rviz_default_plugins/SetGoal
      Topic: {Value: /robot/goal}
  Views:
    Current: {Class: rviz_default_plugins/Orbit, Distance: 4.5, Pitch: 0.6, Yaw: 5.5, Focal Point: {X: 1, Y: -2, Z: 0.5}}
`;

test('displays, frame, view and goal are taken over', () => {
  const scene = readRviz(FILE) ?? assert.fail();
  const { view, ...options } = scene.options;
  assert.deepEqual(options, {
    topics: ['/robot_description', '/scan', '/map', '/odom'],
    grid: true,
    frames: true,
    names: false,
    frame: 'odom',
    goal: '/robot/goal',
    keep: 7,
    follow: '',
    looks: {},
    images: [],
  });
  assert.deepEqual(scene.leftOut, ['Swarm']);
  for (const [written, keep] of [['0', 1000], ['5000', 1000], ['-3', 1000], ['1', 1], ['many', undefined]] as const)
    assert.equal(readRviz(FILE.replace('Keep: 7', `Keep: ${written}`))?.options.keep, keep);
  assert.deepEqual(view?.target, [1, -2, 0.5]);
  assert.equal(view?.distance, 4.5);
  assert.ok(Math.abs((view?.azimuth ?? 0) - (5.5 - 2 * Math.PI)) < 1e-9);
  for (const [written, background] of [['255; 0; 16', '#ff0010'], ['300; 0; 0', undefined], ['white', undefined]] as const)
    assert.equal(readRviz(FILE.replace('48; 48; 48', written))?.options.background, background);
  const top = readRviz(FILE.replace(/Current: .*/, 'Current: {Class: rviz_default_plugins/TopDownOrtho, Scale: 100, X: 3, Y: 4}'));
  assert.deepEqual([top?.options.view?.top, top?.options.view?.target], [true, [3, 4, 0]]);
  assert.ok(Math.abs((top?.options.view?.distance ?? 0) - 3 / Math.tan(Math.PI / 8)) < 1e-9);
});

test('kinds of displays are those that pack tells of, and what is not drawn is skipped', () => {
  const read = (path: string): string => readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8');
  const scene = readRviz(read('tests/support/rviz/kinds.rviz')) ?? assert.fail();
  assert.deepEqual(scene.options.topics, ['/t1', '/t2', '/t3', '/t4', '/t5', '/t6', '/t7', '/t8', '/t9']);
  assert.deepEqual([scene.options.grid, scene.options.frames], [true, true]);
  assert.deepEqual(scene.leftOut, [1, 2, 3].map((number) => `skipped ${number}`));
  assert.deepEqual(scene.options.images?.map(({ topic }) => topic), ['/i1', '/i2', '/i3']);
  const [, list = ''] = /kDrawn\[\] = \{([^}]*)\}/.exec(read('bundler/launch/rviz_config.cpp')) ?? [];
  assert.deepEqual([...list.matchAll(/"(\w+)"/g)].map(([, kind]) => kind).sort(), [...DRAWN].sort());
});

test('what is no such file is refused, and odd values are as usual', () => {
  const bomb = `a0: &a0 [x, x]\n${Array.from({ length: 30 }, (_, i) => `a${i + 1}: &a${i + 1} [*a${i}, *a${i}]`).join('\n')}\n`;
  for (const text of ['', 'just words', '[1, 2', 'Visualization Manager: 7', 'Visualization Manager: {Displays: no}', bomb, 'x'.repeat(2_000_000)])
    assert.equal(readRviz(text), null, text.slice(0, 40));
  let nest = '{Class: x/Grid, Enabled: true}';
  for (let i = 0; i < 50; i += 1) nest = `{Class: x/Group, Enabled: true, Displays: [${nest}]}`;
  assert.equal(readRviz(`Visualization Manager: {Displays: [${nest}]}`)?.options.grid, false);
  const odd = readRviz(
    'Visualization Manager: {Displays: [null, 7, {Enabled: true}], Views: {Current: {Class: x/Orbit, Distance: .nan, Yaw: .inf}}, Tools: 3}',
  );
  assert.equal(odd?.options.view?.distance, 6);
  assert.deepEqual(odd?.options.topics, []);
  assert.equal(odd?.options.view?.azimuth, Math.PI / 4);
});

test('how displays look, where tools publish and what the view goes with are taken over', () => {
  const read = (displays: string, more = ''): ReturnType<typeof readRviz> => readRviz(`Visualization Manager:\n  Displays:\n${displays}\n${more}`);
  const looks = (display: string): unknown => Object.values(read(`    - {Enabled: true, Topic: {Value: /t}, ${display}}`)?.options.looks ?? {})[0];
  assert.deepEqual(
    looks(
      'Class: rviz_default_plugins/PointCloud2, Alpha: 0.5, Size (Pixels): 7, Decay Time: 2.5, Color Transformer: AxisColor, Axis: X, Autocompute Value Bounds: {Value: false, Min Value: -1, Max Value: 4}',
    ),
    { alpha: 0.5, size: 7, decay: 2.5, channel: 'x', least: -1, most: 4 },
  );
  assert.deepEqual(
    looks(
      'Class: rviz_default_plugins/LaserScan, Color Transformer: Intensity, Channel Name: intensity, Autocompute Intensity Bounds: false, Min Intensity: 0, Max Intensity: 47',
    ),
    { channel: 'intensity', least: 0, most: 47 },
  );
  assert.deepEqual(looks('Class: rviz_default_plugins/LaserScan, Color Transformer: FlatColor, Color: 255; 0; 16'), { color: '#ff0010', channel: 'flat' });
  assert.deepEqual(looks('Class: rviz_default_plugins/PointCloud2, Alpha: 1, Size (Pixels): 3, Decay Time: 0, Color Transformer: RGB8'), { channel: 'rgb' });
  assert.deepEqual(looks('Class: rviz_default_plugins/Map, Alpha: 0.7, Color Scheme: costmap'), { alpha: 0.7, scheme: 'costmap' });
  assert.deepEqual(looks('Class: rviz_default_plugins/Path, Alpha: 1, Color: 25; 255; 0'), { color: '#19ff00' });
  assert.deepEqual(looks('Class: rviz_default_plugins/RobotModel, Alpha: 1, Visual Enabled: false, Collision Enabled: true'), {
    hideVisual: true,
    collision: true,
  });
  assert.deepEqual(looks('Class: rviz_default_plugins/Wrench, Force Color: 1; 2; 3'), { color: '#010203' });
  assert.equal(looks('Class: rviz_default_plugins/Path, Alpha: 7, Color: 1; 2'), undefined);
  assert.equal(looks('Class: rviz_default_plugins/Path, Alpha: many, Color: 1; 2; 999'), undefined);
  const tools = read('    - {Class: rviz_default_plugins/Grid, Enabled: true}', `  Tools:
    - {Class: rviz_default_plugins/SetInitialPose, Covariance x: 0.5, Covariance y: 0.125, Covariance yaw: .nan, Topic: {Value: /robot/initialpose}}
    - {Class: rviz_default_plugins/PublishPoint, Single click: true, Topic: {Value: there}}
  Views: {Current: {Class: rviz_default_plugins/Orbit, Target Frame: /base_link}}
`)?.options;
  assert.deepEqual([tools?.estimate, tools?.point, tools?.follow], ['/robot/initialpose', '/there', 'base_link']);
  assert.deepEqual(tools?.variance, { x: 0.5, y: 0.125, yaw: 0.06853891909122467 });
  assert.equal(read('    - {Class: rviz_default_plugins/Grid, Enabled: true}', '  Views: {Current: {Target Frame: <Fixed Frame>}}')?.options.follow, '');
});
