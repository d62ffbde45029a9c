// The drawing of the graph panel: hidden things, actions, groups, filters, places; small changes move nothing.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { GraphActionView, GraphEndpointView, GraphNodeView, GraphView } from '../../../runtime/site/contract/session.ts';
import { inColumns } from '../../../runtime/site/ui/model/graph_layout.ts';
import type { Place, Sizes } from '../../../runtime/site/ui/model/graph_layout.ts';
import { pictureOf, shortName } from '../../../runtime/site/ui/model/graph_picture.ts';
import type { Picture, PictureOptions } from '../../../runtime/site/ui/model/graph_picture.ts';
import { arrange } from '../../../runtime/site/ui/model/graph_places.ts';
import type { Arrangement } from '../../../runtime/site/ui/model/graph_places.ts';
import { arrowOf, nextOf, pathOf, readingOrder } from '../../../runtime/site/ui/model/graph_shapes.ts';
import { fitted, showing, zoomed } from '../../../runtime/site/ui/model/camera.ts';

const QOS = {
  reliability: 'reliable',
  durability: 'volatile',
  history: 'keep_last',
  depth: 10,
  liveliness: 'automatic',
  deadlineNs: 0,
  lifespanNs: 0,
  leaseNs: 0,
} as const;

interface Spec {
  readonly pub?: readonly string[];
  readonly sub?: readonly string[];
  readonly serves?: readonly string[];
  readonly calls?: readonly string[];
}

function node(name: string, { pub = [], sub = [], serves = [], calls = [] }: Spec = {}): GraphNodeView {
  const end = (of: string): GraphEndpointView => ({ name: of, type: 'a/msg/A', hash: '', qos: QOS, gid: '' });
  const action = (of: string): GraphActionView => ({ name: of, type: 'a/action/A' });
  return {
    name,
    process: undefined,
    publishers: pub.map(end),
    subscriptions: sub.map(end),
    services: [],
    clients: [],
    actionServers: serves.map(action),
    actionClients: calls.map(action),
  };
}

const usual: PictureOptions = { mode: 'topics', hidden: false, services: false, groups: true, text: '' };
const picture = (nodes: readonly GraphNodeView[], options: Partial<PictureOptions> = {}): Picture => pictureOf({ nodes }, { ...usual, ...options });
const names = ({ boxes }: Picture): readonly string[] => boxes.map(({ kind, name }) => `${kind} ${name}`);
const wires = (of: Picture): readonly string[] => of.wires.map(({ from, to, names: carried }) => `${from} > ${to}: ${carried.join(' ')}`);

const pair: GraphView['nodes'] = [
  node('/_ros2wasm_page', { sub: ['/chat'] }),
  node('/listener', { sub: ['/chat', '/parameter_events'], pub: ['/rosout'], calls: ['/count'] }),
  node('/talker', { pub: ['/chat', '/rosout', '/count/_action/feedback'], serves: ['/count'] }),
];

test('nodes, topics and actions are boxes; what is hidden is not', () => {
  const of = picture(pair);
  assert.deepEqual(names(of), ['node /listener', 'node /talker', 'topic /chat', 'action /count']);
  assert.deepEqual(wires(of), [
    'node /talker > topic /chat: /chat',
    'topic /chat > node /listener: /chat',
    'node /listener > action /count: /count',
    'action /count > node /talker: /count',
  ]);
  assert.deepEqual(names(picture(pair, { hidden: true })), [
    'node /_ros2wasm_page',
    'node /listener',
    'node /talker',
    'topic /chat',
    'topic /count/_action/feedback',
    'topic /parameter_events',
    'topic /rosout',
    'action /count',
  ]);
});

test('services are shown when they are asked for, without those that every node has', () => {
  const end = (name: string, type: string): GraphEndpointView => ({ name, type, hash: '', qos: QOS, gid: '' });
  const nodes: readonly GraphNodeView[] = [
    { ...node('/asker'), clients: [end('/add', 'demo/srv/Add'), end('/gone', 'demo/srv/Add')] },
    {
      ...node('/adder'),
      services: [
        end('/add', 'demo/srv/Add'),
        end('/_hidden', 'demo/srv/Add'),
        end('/adder/set_parameters', 'rcl_interfaces/srv/SetParameters'),
      ],
    },
  ];
  assert.deepEqual(names(picture(nodes)), ['node /asker', 'node /adder']);
  const of = picture(nodes, { services: true });
  assert.deepEqual(names(of), ['node /asker', 'node /adder', 'service /add', 'service /gone']);
  assert.deepEqual(wires(of), [
    'node /asker > service /add: /add',
    'service /add > node /adder: /add',
    'node /asker > service /gone: /gone',
  ]);
  assert.deepEqual(of.wires.map(({ kind, rateOf }) => `${kind} ${rateOf}`), Array(3).fill('service null'));
  const between = picture(nodes, { services: true, mode: 'nodes' });
  assert.deepEqual(wires(between), ['node /asker > node /adder: /add']);
  assert.deepEqual(between.wires[0]?.lines.map(({ kind }) => kind), ['service']);
  assert.deepEqual(names(picture(nodes, { services: true, hidden: true })).filter((name) => name.startsWith('service')), [
    'service /_hidden',
    'service /add',
    'service /adder/set_parameters',
    'service /gone',
  ]);
});

test('between nodes only, one wire carries all topics from the one to the other', () => {
  const nodes = [node('/a', { pub: ['/1', '/2', '/3', '/4', '/5'] }), node('/b', { sub: ['/5', '/4', '/3', '/2', '/1'], calls: ['/go'] }),
    node('/c', { serves: ['/go'] })];
  const of = picture(nodes, { mode: 'nodes' });
  assert.deepEqual(names(of), ['node /a', 'node /b', 'node /c']);
  assert.deepEqual(wires(of), ['node /a > node /b: /1 /2 /3 /4 /5', 'node /b > node /c: /go']);
  assert.deepEqual(of.wires[0]?.lines.map(({ name }) => name), ['/1', '/2', '/3']);
  assert.equal(of.wires[0]?.more, 2);
});

test('a rate stands on the wire that all messages of the topic pass', () => {
  const rated = (of: Picture): readonly string[] => of.wires.filter(({ rateOf }) => rateOf !== null).map(({ id }) => id);
  assert.deepEqual(rated(picture([node('/a', { pub: ['/t'] }), node('/b', { sub: ['/t'] })])), ['node /a > topic /t']);
  assert.deepEqual(rated(picture([node('/a', { pub: ['/t'] }), node('/b', { sub: ['/t'], pub: ['/t'] })])), ['topic /t > node /b']);
});

test('a namespace with two things or more is a group, within its outer ones', () => {
  const of = picture([
    node('/fleet/one/laser', { pub: ['/fleet/one/scan'] }),
    node('/fleet/two/laser', { pub: ['/fleet/two/scan'] }),
    node('/alone/node'),
    node('/deep/er/est/a'),
    node('/deep/er/est/b'),
  ]);
  assert.deepEqual(of.groups, [
    { id: '/fleet', label: '/fleet', parent: null },
    { id: '/fleet/one', label: '/fleet/one', parent: '/fleet' },
    { id: '/fleet/two', label: '/fleet/two', parent: '/fleet' },
    { id: '/deep/er/est', label: '/deep/er/est', parent: null },
  ]);
  assert.deepEqual(of.boxes.map(({ label, group }) => [label, group]), [
    ['laser', '/fleet/one'],
    ['laser', '/fleet/two'],
    ['/alone/node', null],
    ['a', '/deep/er/est'],
    ['b', '/deep/er/est'],
    ['scan', '/fleet/one'],
    ['scan', '/fleet/two'],
  ]);
  assert.deepEqual(picture([node('/a/b'), node('/a/c')], { groups: false }).groups, []);
});

test('a filter keeps what has the text, and what that is connected with', () => {
  const nodes = [node('/a', { pub: ['/scan'] }), node('/b', { sub: ['/scan'], pub: ['/cmd'] }), node('/c', { sub: ['/cmd'] }), node('/d')];
  assert.deepEqual(names(picture(nodes, { text: 'SCAN' })), ['node /a', 'node /b', 'topic /scan']);
  assert.deepEqual(names(picture(nodes, { text: '/c' })), ['node /b', 'node /c', 'topic /cmd']);
  assert.deepEqual(names(picture(nodes, { text: 'scan', mode: 'nodes' })), ['node /a', 'node /b']);
  assert.deepEqual(names(picture(nodes, { text: 'nothing' })), []);
});

test('nodes of one name are each drawn, and hostile names are keys of nothing', () => {
  const of = picture([node('/a', { pub: ['/__proto__'] }), node('/a', { sub: ['/__proto__'] }), node('/constructor')], { hidden: true });
  assert.deepEqual(of.boxes.map(({ id }) => id), ['node /a', 'node /a 2', 'node /constructor', 'topic /__proto__']);
  assert.equal(arrange(null, of, sizes(of), WIDE).routes.size, 2);
  assert.equal(shortName('/a\u202eb\u0000c'), '/a\ufffdb\ufffdc');
  assert.equal([...shortName(`/${'x'.repeat(500)}`)].length, 39);
});

const WIDE = { width: 1600, height: 300 };
const TALL = { width: 300, height: 1600 };

function sizes(of: Picture): Sizes {
  return {
    boxes: new Map(of.boxes.map(({ id, label }) => [id, { width: 40 + 8 * label.length, height: 30 }])),
    wires: new Map(of.wires.filter(({ lines }) => lines.length > 0).map(({ id }) => [id, { width: 80, height: 20 }])),
  };
}

const overlap = (a: Place, b: Place): boolean => Math.abs(a.x - b.x) * 2 < a.width + b.width && Math.abs(a.y - b.y) * 2 < a.height + b.height;

/** No box over another, none in a group that is not its own, wires from box to box. */
function expectTidy(of: Picture, { places, groups, routes }: Arrangement): void {
  const at = (id: string): Place => places.get(id) ?? assert.fail(`${id} has no place`);
  const outer = (id: string | null): readonly string[] => (id === null ? [] : [id, ...outer(of.groups.find((group) => group.id === id)?.parent ?? null)]);
  for (const [index, a] of of.boxes.entries()) {
    for (const b of of.boxes.slice(index + 1)) assert.ok(!overlap(at(a.id), at(b.id)), `${a.id} lies over ${b.id}`);
    for (const [id, area] of groups) assert.equal(overlap(at(a.id), area), outer(a.group).includes(id), `${a.id} and group ${id}`);
  }
  for (const { id, from, to } of of.wires) {
    const points = routes.get(id)?.points ?? assert.fail(`${id} is not drawn`);
    for (const [point, box] of [[points[0], from], [points.at(-1), to]] as const) {
      const { x, y, width, height } = at(box);
      assert.ok(point !== undefined && Math.abs(point.x - x) * 2 <= width + 1 && Math.abs(point.y - y) * 2 <= height + 1, `${id} misses ${box}`);
    }
  }
}

/** Many robots, each with nodes that talk in their namespace, and one that watches all. */
function fleet(count: number): readonly GraphNodeView[] {
  const robots = Array.from({ length: count }, (_, index) => `/r${index}`);
  return [
    ...robots.flatMap((space) => [
      node(`${space}/drive`, { sub: [`${space}/cmd`], pub: [`${space}/odom`, '/tf'] }),
      node(`${space}/plan`, { sub: [`${space}/odom`, `${space}/scan`], pub: [`${space}/cmd`] }),
      node(`${space}/laser`, { pub: [`${space}/scan`] }),
    ]),
    node('/watch', { sub: ['/tf', ...robots.map((space) => `${space}/scan`)] }),
  ];
}

test('a graph is laid out tidily, in both directions and modes, and always the same', () => {
  for (const mode of ['topics', 'nodes'] as const) {
    for (const view of [WIDE, TALL]) {
      const of = picture(fleet(5), { mode });
      const made = arrange(null, of, sizes(of), view);
      expectTidy(of, made);
      assert.deepEqual(arrange(null, of, sizes(of), view), made);
    }
  }
});

test('what dagre cannot lay out stands in columns, each group in its own', () => {
  const of = picture(fleet(4));
  const { boxes, routes } = inColumns(of, sizes(of));
  assert.equal(routes.size, 0);
  const shown = of.boxes.map(({ id, group }) => ({ group, place: boxes.get(id) ?? assert.fail(id) }));
  for (const [index, a] of shown.entries()) {
    for (const b of shown.slice(index + 1)) {
      assert.ok(!overlap(a.place, b.place));
      assert.equal(a.place.x === b.place.x, a.group === b.group);
    }
  }
});

test('a graph flows in the direction in which it is seen larger', () => {
  const of = picture(Array.from({ length: 6 }, (_, index) => node(`/n${index}`, { sub: [`/t${index}`], pub: [`/t${index + 1}`] })));
  assert.equal(arrange(null, of, sizes(of), WIDE).direction, 'right');
  assert.equal(arrange(null, of, sizes(of), TALL).direction, 'down');
});

test('what leaves and comes back moves nothing, nor does one thing more', () => {
  const before = picture(fleet(3));
  const first = arrange(null, before, sizes(before), WIDE);
  const less = picture(fleet(3).filter(({ name }) => name !== '/r1/plan'));
  const second = arrange(first, less, sizes(less), WIDE);
  expectTidy(less, second);
  const third = arrange(second, before, sizes(before), WIDE);
  expectTidy(before, third);
  assert.deepEqual(third.places, first.places);
  assert.deepEqual(third.routes, first.routes);
  const more = picture([...fleet(3), node('/r1/log', { sub: ['/r1/scan', '/tf'], pub: ['/r1/odom'] }), node('/loop', { pub: ['/tf'], sub: ['/tf'] })]);
  const fourth = arrange(third, more, sizes(more), WIDE);
  expectTidy(more, fourth);
  for (const { id } of before.boxes) assert.deepEqual(fourth.places.get(id), first.places.get(id), id);
  assert.equal(fourth.version, first.version);
  const other = picture(fleet(12));
  const fifth = arrange(fourth, other, sizes(other), WIDE);
  expectTidy(other, fifth);
  assert.equal(fifth.version, first.version + 1);
});

test('a graph that is too large is drawn as far as it can be, and says how much is skipped', () => {
  const of = picture(Array.from({ length: 400 }, (_, index) => node(`/n${index}`, { pub: ['/all'], sub: ['/all'] })), { mode: 'nodes' });
  assert.ok(of.boxes.length > 10 && of.boxes.length < 30, `${of.boxes.length} boxes`);
  assert.equal(of.boxes.length + of.leftOut, 400);
  // All wires between what is drawn, also those of a node to itself.
  assert.equal(of.wires.length, of.boxes.length ** 2);
  const apart = picture(Array.from({ length: 400 }, (_, index) => node(`/n${index}`)));
  assert.deepEqual([apart.boxes.length, apart.leftOut], [150, 250]);
});

test('a wire ends in an arrowhead, and arrow keys find the nearest box', () => {
  const points = [{ x: 0, y: 0 }, { x: 50, y: 0 }, { x: 50, y: 40 }];
  assert.equal(pathOf(points), 'M0 0L25 0Q50 0 50 20L50 40');
  assert.equal(arrowOf(points), 'M50 40L46.4 31L53.6 31Z');
  const item = (id: string, x: number, y: number) => ({ id, place: { x, y, width: 10, height: 10 } });
  const items = readingOrder([item('d', 100, 50), item('b', 0, 40), item('a', 0, 0), item('c', 100, 0)], 'right');
  assert.deepEqual(items.map(({ id }) => id), ['a', 'b', 'c', 'd']);
  assert.equal(nextOf(items, 0, 'ArrowRight')?.id, 'c');
  assert.equal(nextOf(items, 0, 'ArrowDown')?.id, 'b');
  assert.equal(nextOf(items, 3, 'ArrowLeft')?.id, 'b');
  assert.equal(nextOf(items, 0, 'ArrowUp'), undefined);
});

test('the camera fits, zooms about a point, and moves no more than it must', () => {
  const view = { width: 232, height: 132 };
  const camera = fitted({ x: 200, y: 50, width: 400, height: 100 }, view);
  assert.deepEqual(camera, { scale: 0.5, x: 16, y: 41 });
  const near = zoomed(camera, 2, { x: 16, y: 41 });
  assert.deepEqual(near, { scale: 1, x: 16, y: 41 });
  assert.deepEqual(showing(near, { x: 20, y: 20, width: 20, height: 20 }, view), near);
  assert.deepEqual(showing(near, { x: 300, y: 20, width: 20, height: 20 }, view), { scale: 1, x: -94, y: 41 });
});
