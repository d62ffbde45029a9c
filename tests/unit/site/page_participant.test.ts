// The page as a participant of the graph, on both links: what it sends and hears, calls and goals that always settle,
// by the site's time; and the graph as it sees it.

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { EndpointKind, ErrorCode } from '../../../runtime/protocol/generated/constants.ts';
import { type Broker, PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import type { GraphNodeView, MessageInfo } from '../../../runtime/site/contract/page_node.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { GraphPeer, type Sample } from './graph_peer.ts';
import { makeFolder } from './site_fixture.ts';

const watchdog = { timeout: 120_000 };
const string = 'std_msgs/msg/String';
const add = 'example_interfaces/srv/AddTwoInts';
const count = 'demo/action/Count';

interface Scene {
  readonly broker: Broker;
  readonly session: SiteSession;
  readonly peer: () => GraphPeer;
}

async function withScene(link: 'shared' | 'port', use: (scene: Scene) => Promise<void>): Promise<void> {
  const folder = makeFolder([]);
  const platform = nodePlatform(folder, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
  const broker = link === 'shared' ? new SharedBroker({ ceiling: 64 << 20 }) : new PortBroker();
  const session = new SiteSession({ site: readSite(await platform.json('site.json')), platform, broker });
  const peers: GraphPeer[] = [];
  const peer = (): GraphPeer => {
    const made = new GraphPeer(broker);
    peers.push(made);
    return made;
  };
  try {
    await use({ broker, session, peer });
  } finally {
    session.close();
    for (const each of peers) each.link.close();
    platform.close();
    rmSync(folder, { recursive: true });
  }
}

/** Resolves when the condition holds; the bus needs turns of the event loop. */
async function holds(condition: () => boolean): Promise<void> {
  while (!condition()) {
    await new Promise((resolve) => {
      setTimeout(resolve, 2);
    });
  }
}

async function codeOf(promise: Promise<unknown>): Promise<string> {
  return await promise.then(() => 'resolved', (error: unknown) => error instanceof SiteError ? error.code : String(error));
}

const bytes = (...values: number[]): Uint8Array => Uint8Array.of(0, 1, 0, 0, ...values);

test('port: a message that was to wait for room and was lost is told by the next call', watchdog,
  (context) =>
    withScene('port', async ({ broker, session }) => {
      const publisher = session.node().publisher('/all', string);
      for (const [code, told] of [[ErrorCode.outOfMemory, /does not fit into the memory/], [ErrorCode.stopped, /was closed/]] as const) {
        const write = context.mock.method(broker.link, 'write', () => Promise.resolve(code));
        assert.equal(publisher.publish(bytes(1)), undefined);
        assert.match(publisher.publish(bytes(2))?.message ?? '', /cannot take more now/);
        await new Promise((resolve) => setImmediate(resolve));
        write.mock.restore();
        const problem = publisher.publish(bytes(3));
        assert.equal(problem?.code, 'R2W0718');
        assert.match(problem.message, told);
        assert.equal(publisher.publish(bytes(4)), undefined);
      }
    }));

for (const link of ['shared', 'port'] as const) {
  test(`${link}: endpoints that cannot be made are not remembered`, watchdog, () =>
    withScene(link, async ({ session }) => {
      const node = session.node();
      const { open } = node as unknown as { readonly open: ReadonlySet<unknown>; };
      const before = open.size;
      for (let i = 0; i < 10; i += 1) {
        assert.ok(node.publisher('/a b', string).problem);
        assert.ok(node.subscription('/a b', string, {}, () => undefined).problem);
        assert.ok(node.client('/a b', add).problem);
        assert.ok(node.actionClient('/a b', count).problem);
      }
      assert.equal(open.size, before);
    }));

  test(`${link}: messages go both ways; what is closed sends nothing and throws nothing`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const other = peer();
      const heard = other.make(EndpointKind.subscription, 'listener', '/chatter', string);
      const spoken = other.make(EndpointKind.publisher, 'talker', '/reply', string);
      const node = session.node();
      assert.equal(session.node(), node);
      const publisher = node.publisher('chatter', string);
      assert.equal(publisher.problem, undefined);
      const got: (readonly [Uint8Array, MessageInfo])[] = [];
      const subscription = node.subscription('/reply', string, {}, (message, info) => void got.push([message, info]));
      await holds(() => publisher.matched() === 1 && subscription.matched() === 1);
      await other.until(() => other.link.matched(heard) === 1 && other.link.matched(spoken) === 1);
      for (let n = 1; n <= 5; n += 1) assert.equal(publisher.publish(bytes(n)), undefined);
      for (let n = 1; n <= 5; n += 1) assert.deepEqual((await other.next(heard)).bytes, bytes(n));
      const before = session.time.view().now;
      for (let n = 1; n <= 5; n += 1) other.write(spoken, bytes(n));
      other.write(spoken, new Uint8Array(100_000).fill(7));
      await holds(() => got.length === 6);
      assert.deepEqual(got.slice(0, 5).map(([message]) => message), [1, 2, 3, 4, 5].map((n) => bytes(n)));
      assert.deepEqual(got[5]?.[0], new Uint8Array(100_000).fill(7));
      const info = got[0]![1];
      assert.ok(info.publishedAt >= before - 1 && info.receivedAt >= info.publishedAt && info.receivedAt <= session.time.view().now);
      assert.equal(info.gid, session.graph().nodes.find(({ name }) => name === '/talker')?.publishers[0]?.gid);
      publisher.close();
      assert.equal(publisher.publish(bytes(1))?.code, 'R2W0718');
      subscription.close();
      await other.until(() => other.link.matched(spoken) === 0 && other.link.matched(heard) === 0);
      session.close();
      assert.equal(publisher.publish(bytes(1))?.code, 'R2W0718');
      assert.equal(node.publisher('/late', string).problem?.code, 'R2W0718');
    }));

  test(`${link}: what a transient_local publisher sent before is heard; one that wants all holds up a writer that keeps all`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const other = peer();
      const latched = other.make(EndpointKind.publisher, 'map_server', '/map', string, { durability: 'transient_local', depth: 1 });
      other.write(latched, bytes(42));
      const node = session.node();
      const got: number[] = [];
      node.subscription('/first', string, {}, () =>
        undefined);
      node.subscription('/map', string, { durability: 'transient_local', depth: 1 }, (message) => got.push(message[4]!));
      await holds(() => got.length === 1);
      assert.deepEqual(got, [42]);
      const slow = other.make(EndpointKind.subscription, 'slow', '/all', string, { history: 'keep_all' });
      const publisher = node.publisher('/all', string, { history: 'keep_all' });
      await holds(() => publisher.matched() === 1);
      await other.until(() => other.link.matched(slow) === 1);
      let sent = 0;
      let problem = publisher.publish(bytes(1));
      while (problem === undefined) {
        sent += 1;
        assert.ok(sent < 100_000);
        problem = publisher.publish(bytes(1));
      }
      assert.equal(problem.code, 'R2W0718');
      for (let n = 0; n < sent; n += 1) await other.next(slow);
      await holds(() => publisher.publish(bytes(1)) === undefined);
    }));

  test(`${link}: who asks for the past begins with what publishers still hold, where the link has it`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const other = peer();
      const spoken = other.make(EndpointKind.publisher, 'talker', '/chatter', string, { depth: 8 });
      for (let n = 1; n <= 100; n += 1)
        other.write(spoken, bytes(n));
      const node = session.node();
      const [plain, all, newest]: [number[], number[], number[]] = [[], [], []];
      const into = (got: number[]) => (message: Uint8Array): void =>
        void got.push(message[4]!);
      const ends = [
        node.subscription('/chatter', string, { depth: 200 }, into(plain)),
        node.subscription('/chatter', string, { depth: 200, past: true }, into(all)),
        node.subscription('/chatter', string, { depth: 3, past: true }, into(newest)),
      ];
      await holds(() => ends.every((end) => end.matched() === 1));
      await other.until(() => other.link.matched(spoken) === 3);
      // The past is read before the next one comes, which would push it out of the shortest history.
      if (link === 'shared') await holds(() => newest.length === 3);
      other.write(spoken, bytes(101));
      await holds(() => [plain, all, newest].every((got) => got.at(-1) === 101));
      assert.deepEqual(plain, [101]);
      if (link === 'port') {
        assert.deepEqual([all, newest], [[101], [101]]);
      } else {
        assert.ok(all.length > 8 && all.every((value, index) => value === 101 - all.length + 1 + index), all.join(' '));
        assert.deepEqual(newest, [98, 99, 100, 101]);
      }
    }));

  test(`${link}: names and types that the graph does not take`, watchdog, () =>
    withScene(link, async ({ session }) => {
      const node = session.node();
      for (const [name, type] of [['/a b', string], ['', string], ['/1a', string], ['/a/', string], ['/a', 'String'], ['/a', 'std_msgs/String']] as const) {
        const publisher = node.publisher(name, type);
        assert.equal(publisher.problem?.code, 'R2W0715', name);
        assert.equal(publisher.publish(bytes())?.code, 'R2W0715');
        assert.equal(publisher.matched(), 0);
        assert.equal(node.subscription(name, type, {}, () => undefined).problem?.code, 'R2W0715');
        assert.equal(await codeOf(node.client(name, type).call(bytes())), 'R2W0715');
        const goal = node.actionClient(name, type).sendGoal(bytes());
        assert.equal(await codeOf(goal.accepted), 'R2W0715');
        assert.equal(await codeOf(goal.result), 'R2W0715');
      }
      const left = session.graph().nodes.flatMap(({ publishers, subscriptions, clients }) => [...publishers, ...subscriptions, ...clients]);
      assert.deepEqual(left, []);
    }));

  test(`${link}: a call waits for its server, and gets the reply to its own request`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const client = session.node().client('/add', add);
      const first = client.call(bytes(1));
      assert.equal(client.ready(), false);
      const other = peer();
      const server = other.make(EndpointKind.server, 'adder', '/add', add);
      const second = client.call(bytes(2));
      const asked: Sample[] = [await other.next(server), await other.next(server)];
      assert.ok(client.ready());
      for (const sample of asked.reverse()) other.write(server, bytes(sample.bytes[4]! + 10), sample);
      assert.deepEqual([await first, await second], [bytes(11), bytes(12)]);
      // The last word of a server that leaves.
      const third = client.call(bytes(3));
      const last = await other.next(server);
      other.write(server, bytes(13), last);
      other.leave();
      assert.deepEqual(await third, bytes(13));
    }));

  test(`${link}: calls that come to nothing are rejected: the server goes or dies, does not answer, is not there, the call is given up`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const node = session.node();
      const client = node.client('/add', add);
      for (const end of ['leave', 'die'] as const) {
        const other = peer();
        const server = other.make(EndpointKind.server, 'adder', '/add', add);
        const call = client.call(bytes(1));
        await other.next(server);
        other[end]();
        assert.equal(await codeOf(call), 'R2W0716', end);
        await holds(() =>
          !client.ready()
        );
      }
      assert.equal(await codeOf(client.call(bytes(1), { timeoutMs: 20 })), 'R2W0716');
      const other = peer();
      const server = other.make(EndpointKind.server, 'adder', '/add', add);
      const late = client.call(bytes(1), { timeoutMs: 20 });
      const asked = await other.next(server);
      assert.equal(await codeOf(late), 'R2W0717');
      other.write(server, bytes(9), asked);
      const abort = new AbortController();
      const given = client.call(bytes(2), { signal: abort.signal });
      const again = await other.next(server);
      abort.abort();
      assert.equal(await codeOf(given), 'R2W0718');
      const next = client.call(bytes(3));
      other.write(server, bytes(8), again);
      other.write(server, bytes(7), await other.next(server));
      assert.deepEqual(await next, bytes(7), 'late replies are not taken for its own');
      const open = client.call(bytes(4));
      const closed = codeOf(open);
      client.close();
      assert.equal(await closed, 'R2W0718');
      assert.equal(await codeOf(client.call(bytes(5))), 'R2W0718');
      const ended = codeOf(node.client('/add', add).call(bytes(6)));
      session.close();
      assert.equal(await ended, 'R2W0718');
    }));

  test(`${link}: time that is held holds timeouts and timers too`, watchdog, () =>
    withScene(link, async ({ session }) => {
      const node = session.node();
      session.time.pause();
      let code = '';
      void codeOf(node.client('/add', add).call(bytes(1), { timeoutMs: 5000 })).then((known) => {
        code = known;
      });
      const rung: number[] = [];
      const begin = session.time.view().now;
      const timer = node.timer(1000, () => rung.push(Math.round(session.time.view().now - begin)));
      session.time.setRate(1000);
      session.time.step(2500e6);
      await holds(() => session.time.view().state === 'paused');
      await holds(() => rung.length > 0);
      assert.equal(code, '');
      session.time.step(2600e6);
      await holds(() => code !== '');
      assert.equal(code, 'R2W0716');
      assert.ok(rung.every((ms) => ms >= 1000) && rung.length <= 5, String(rung));
      timer.close();
      const last = rung.length;
      session.time.step(5000e6);
      await holds(() => session.time.view().state === 'paused');
      assert.equal(rung.length, last);
    }));

  test(`${link}: a goal that waits for a server is given up at once, and is not sent later`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const client = session.node().actionClient('/count', count);
      const waiting = new AbortController();
      const goal = client.sendGoal(bytes(5, 0, 0, 0), { timeoutMs: Infinity, signal: waiting.signal });
      waiting.abort();
      await assert.rejects(goal.accepted, { code: 'R2W0718' });
      await assert.rejects(goal.result, { code: 'R2W0718' });
      const other = peer();
      const server = new HandServer(other);
      await holds(() => client.ready());
      await server.ready();
      client.sendGoal(bytes(6, 0, 0, 0));
      assert.deepEqual([...(await other.next(server.goals)).bytes.subarray(20)], [6, 0, 0, 0]);
    }));

  test(`${link}: a goal with feedback, status and result; one that is given up is canceled; one that is refused`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const client = session.node().actionClient('/count', count);
      const other = peer();
      const server = new HandServer(other);
      await holds(() => client.ready());
      await server.ready();

      let [statesSeen, feedbackSeen] = [0, 0];
      session.node().subscription('/count/_action/feedback', `${count}_FeedbackMessage`, {}, () => void (feedbackSeen += 1));
      session.node().subscription('/count/_action/status', 'action_msgs/msg/GoalStatusArray', {}, () => void (statesSeen += 1));
      const feedback: number[] = [];
      const states: string[] = [];
      const goal = client.sendGoal(bytes(5, 0, 0, 0), { onFeedback: (message) => feedback.push(message[4]!), onStatus: (status) => states.push(status) });
      const request = await other.next(server.goals);
      assert.equal(request.bytes.length, 24);
      assert.deepEqual([...request.bytes.subarray(20)], [5, 0, 0, 0]);
      const id = request.bytes.subarray(4, 20);
      assert.equal(Buffer.from(id).toString('hex'), goal.id);
      // Words about the goal may overtake the answer: they come after it all the same.
      server.status([[id, 2]]);
      other.write(server.feedback, bytes(...id, 0));
      await holds(() => statesSeen > 0 && feedbackSeen > 0);
      assert.deepEqual([states, feedback], [[], []]);
      server.answer(request, true);
      assert.equal(await goal.accepted, true);
      await holds(() => states.includes('executing'));
      other.write(server.feedback, bytes(...new Uint8Array(16), 99));
      for (let n = 1; n <= 3; n += 1) other.write(server.feedback, bytes(...id, n));
      await holds(() => feedback.length === 4);
      assert.deepEqual(feedback, [0, 1, 2, 3]);
      const wanted = await other.next(server.results);
      assert.deepEqual(wanted.bytes.subarray(4), id);
      other.write(server.results, bytes(4, 0, 0, 0, 8, 0, 0, 0), wanted);
      const result = await goal.result;
      assert.equal(result.status, 'succeeded');
      assert.deepEqual(result.bytes, bytes(4, 0, 0, 0, 8, 0, 0, 0));
      assert.deepEqual(states, ['accepted', 'executing', 'succeeded']);

      const refused = client.sendGoal(bytes(1, 0, 0, 0));
      server.answer(await other.next(server.goals), false);
      assert.equal(await refused.accepted, false);
      assert.equal(await codeOf(refused.result), 'R2W0719');

      const long = client.sendGoal(bytes(9, 0, 0, 0));
      const longRequest = await other.next(server.goals);
      server.answer(longRequest, true);
      await long.accepted;
      const cancel = long.cancel();
      const cancelRequest = await other.next(server.cancels);
      assert.deepEqual([...cancelRequest.bytes], [...bytes(...longRequest.bytes.subarray(4, 20)), ...new Uint8Array(8)]);
      server.agree(cancelRequest);
      assert.equal(await cancel, true);
      other.write(server.results, bytes(5, 0, 0, 0), await other.next(server.results));
      assert.equal((await long.result).status, 'canceled');

      for (const when of ['before the answer', 'after it'] as const) {
        const abort = new AbortController();
        const given = client.sendGoal(bytes(2, 0, 0, 0), { signal: abort.signal });
        const taken = await other.next(server.goals);
        if (when === 'before the answer') abort.abort();
        server.answer(taken, true);
        if (when === 'after it') {
          await given.accepted;
          abort.abort();
        }
        assert.equal(await codeOf(given.result), 'R2W0718', when);
        const asked = await other.next(server.cancels);
        assert.deepEqual(asked.bytes.subarray(4, 20), taken.bytes.subarray(4, 20), when);
        server.agree(asked);
      }

      const doomed = client.sendGoal(bytes(3, 0, 0, 0));
      server.answer(await other.next(server.goals), true);
      await doomed.accepted;
      other.die();
      assert.equal(await codeOf(doomed.result), 'R2W0716');
    }));

  test(`${link}: an action client that is closed cancels its goals and leaves nothing in the graph`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      const client = session.node().actionClient('/count', count);
      const other = peer();
      const server = new HandServer(other);
      await holds(() =>
        client.ready()
      );
      const goal = client.sendGoal(bytes(5, 0, 0, 0));
      const request = await other.next(server.goals);
      server.answer(request, true);
      await goal.accepted;
      client.close();
      assert.equal(await codeOf(goal.result), 'R2W0718');
      const asked = await other.next(server.cancels);
      assert.deepEqual(asked.bytes.subarray(4, 20), request.bytes.subarray(4, 20));
      server.agree(asked);
      const own = (): GraphNodeView | undefined => session.graph().nodes.find(({ name }) => name === session.node().name);
      await holds(() => own()?.clients.length === 0 && own()?.subscriptions.length === 0);
      assert.equal(await codeOf(client.sendGoal(bytes(1)).result), 'R2W0718');
    }));

  test(`${link}: the graph, hidden nodes too, and its changes`, watchdog, () =>
    withScene(link, async ({ session, peer }) => {
      assert.deepEqual(session.graph().nodes, []);
      const seen: string[][] = [];
      const off = session.onGraph(({ nodes }) => seen.push(nodes.map(({ name }) => name)));
      const other = peer();
      other.make(EndpointKind.publisher, 'talker', '/chatter', string, { reliability: 'best_effort', deadlineNs: 1e9, depth: 3 });
      new HandServer(other);
      session.node().client('/add', add);
      await holds(() => seen.at(-1)?.length === 3);
      assert.deepEqual(seen.at(-1), ['/_ros2wasm_page', '/counter', '/talker']);
      const [page, counter, talker] = session.graph().nodes;
      assert.deepEqual(page?.clients.map(({ name, type }) => [name, type]), [['/add', add]]);
      assert.deepEqual(counter?.actionServers, [{ name: '/count', type: count }]);
      assert.deepEqual(counter?.services.map(({ name }) => name), ['cancel_goal', 'get_result', 'send_goal'].map((part) => `/count/_action/${part}`));
      assert.deepEqual(talker?.publishers.map(({ gid, ...rest }) => [/^[0-9a-f]{32}$/.test(gid), rest]), [[true, {
        name: '/chatter',
        type: string,
        hash: '',
        qos: {
          reliability: 'best_effort',
          durability: 'volatile',
          history: 'keep_last',
          depth: 3,
          liveliness: 'automatic',
          deadlineNs: 1e9,
          lifespanNs: 0,
          leaseNs: 0,
        },
      }]]);
      other.leave();
      await holds(() => seen.at(-1)?.length === 1);
      off();
      const before = seen.length;
      const another = peer();
      another.make(EndpointKind.publisher, 'talker', '/chatter', string);
      await holds(() => session.graph().nodes.length === 2);
      assert.equal(seen.length, before);
    }));
}

/** The five endpoints of an action server. */
class HandServer {
  private readonly peer: GraphPeer;
  readonly goals: number;
  readonly cancels: number;
  readonly results: number;
  readonly feedback: number;
  private readonly states: number;

  constructor(peer: GraphPeer) {
    this.peer = peer;
    const at = (part: string): string => `/count/_action/${part}`;
    this.goals = peer.make(EndpointKind.server, 'counter', at('send_goal'), `${count}_SendGoal`);
    this.cancels = peer.make(EndpointKind.server, 'counter', at('cancel_goal'), 'action_msgs/srv/CancelGoal');
    this.results = peer.make(EndpointKind.server, 'counter', at('get_result'), `${count}_GetResult`);
    this.feedback = peer.make(EndpointKind.publisher, 'counter', at('feedback'), `${count}_FeedbackMessage`);
    this.states = peer.make(EndpointKind.publisher, 'counter', at('status'), 'action_msgs/msg/GoalStatusArray', { depth: 1, durability: 'transient_local' });
  }

  async ready(): Promise<void> {
    await this.peer.until(() => [this.goals, this.cancels, this.results, this.feedback, this.states].every((each) => this.peer.link.matched(each) > 0));
  }

  answer(request: Sample, accepted: boolean): void {
    this.peer.write(this.goals, bytes(accepted ? 1 : 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0), request);
  }

  agree(request: Sample): void {
    this.peer.write(this.cancels, bytes(0, 0, 0, 0, 1, 0, 0, 0, ...request.bytes.subarray(4, 28)), request);
  }

  status(list: readonly (readonly [Uint8Array, number])[]): void {
    const body: number[] = [list.length, 0, 0, 0];
    for (const [id, status] of list) {
      body.push(...id);
      while (body.length % 4 !== 0) body.push(0);
      body.push(0, 0, 0, 0, 0, 0, 0, 0, status);
    }
    this.peer.write(this.states, bytes(...body));
  }
}
