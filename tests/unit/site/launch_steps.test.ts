// The launcher's steps after starts, ends and changes of state, on a host of the test's own; and the messages of managed nodes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LaunchSteps } from '../../../runtime/site/launch/launch_steps.ts';
import { changeStateRequest, changeStateSucceeded, readTransitionEvent } from '../../../runtime/site/launch/lifecycle_messages.ts';
import type { MessageListener, PageNode } from '../../../runtime/site/contract/page_node.ts';
import type { LaunchStep, LineTest, NodeMoment, NodeState, OutputMoment, SiteNode } from '../../../runtime/site/contract/session.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';

/** lifecycle_msgs/msg/TransitionEvent, little-endian. */
function transitionEvent(transition: string, start: string, goal: string): Uint8Array<ArrayBuffer> {
  const parts: number[] = [0, 1, 0, 0, ...new Array<number>(8).fill(9)];
  for (const label of [transition, start, goal]) {
    parts.push(7);
    while (parts.length % 4 !== 0) parts.push(0);
    const text = [...new TextEncoder().encode(label), 0];
    parts.push(text.length & 255, text.length >> 8, 0, 0, ...text);
  }
  return new Uint8Array(parts);
}

class Host {
  readonly said: string[] = [];
  readonly done: string[] = [];
  readonly calls: number[] = [];
  readonly states = new Map<string, NodeState['kind']>();
  answers = true;
  /** A call is answered when it is given up. */
  silent = false;
  idle = false;
  problem: SiteError | undefined;
  private tasks: { readonly at: number; readonly task: () => void; off: boolean; }[] = [];
  private listener: MessageListener | undefined;
  readonly steps: LaunchSteps;

  constructor(steps: readonly LaunchStep[], nodes: readonly Partial<SiteNode>[] = []) {
    const unused = (): never => assert.fail('nobody asked for this');
    const node: PageNode = {
      name: '/page',
      publisher: unused,
      actionClient: unused,
      timer: unused,
      subscription: (_topic, _type, _qos, listener) => {
        this.listener = listener;
        return { problem: undefined, matched: () => 1, close: () => void this.done.push('deaf') };
      },
      client: () => ({
        problem: undefined,
        matched: () => 1,
        ready: () => true,
        close: () => undefined,
        call: async (request, options) => {
          this.calls.push(request[4] ?? -1);
          if (this.silent) await new Promise((_resolve, reject) => options?.signal?.addEventListener('abort', () => reject(new Error('given up'))));
          if (this.problem !== undefined) throw this.problem;
          return new Uint8Array([0, 1, 0, 0, this.answers ? 1 : 0]);
        },
      }),
    };
    this.steps = new LaunchSteps({
      nodes: nodes as readonly SiteNode[],
      steps,
      after: (ms, task) => {
        const entry = { at: ms, task, off: false };
        this.tasks.push(entry);
        return () => {
          entry.off = true;
        };
      },
      state: (id) => ({ kind: this.states.get(id) ?? 'running', code: 0 }) as NodeState,
      start: (id, after) => void this.done.push(`start ${id} ${after}`),
      stop: (id) => {
        this.done.push(`stop ${id}`);
        this.steps.happened(id, 'stop');
      },
      stopAll: (reason) => {
        this.done.push('stop');
        this.steps.shutdown(reason);
      },
      idle: () => this.idle,
      say: (level, logger, text) => void this.said.push(`${level} ${logger} ${text}`),
      pageNode: () => node,
    });
    this.steps.prepare();
  }

  ring(): void {
    for (const { task, off } of this.tasks.splice(0)) if (!off) task();
  }

  hears(transition: string, start: string, goal: string): void {
    this.listener?.(transitionEvent(transition, start, goal), { publishedAt: 0, receivedAt: 0, gid: '' });
  }
}

const log = (text: string, more: Partial<LaunchStep> = {}): LaunchStep => ({ do: 'log', level: 'info', text, after: 0, ...more } as LaunchStep);

test('lines come with the launch, late, and after starts and ends', () => {
  const host = new Host([
    log('at once'),
    log('late', { after: 2 }),
    log('started', { on: { event: 'start', node: 'a-1' } }),
    log('ended', { on: { event: 'exit', node: 'a-1', once: true } }),
  ]);
  host.steps.launched();
  assert.deepEqual(host.said, ['INFO launch.user at once']);
  host.steps.happened('b-2', 'start');
  host.steps.happened('a-1', 'start');
  host.steps.happened('a-1', 'exit');
  host.steps.happened('a-1', 'exit');
  host.ring();
  assert.deepEqual(host.said.slice(1), ['started', 'ended', 'late'].map((text) => `INFO launch.user ${text}`));
});

test('of the moments of a handler that is followed once the first one counts, with all that it says', () => {
  const on = (node: string): NodeMoment => ({ event: 'exit', node, once: true, handler: 3 });
  const host = new Host([
    log('a ended', { on: on('a-1') }),
    log('a, really', { on: on('a-1') }),
    log('b ended', { on: on('b-1') }),
    log('each time', { on: { event: 'exit', node: 'b-1' } }),
  ], [{ id: 'c-1', startOn: on('b-1'), startAfter: 0 }, { id: 'd-1', startOn: on('a-1'), startAfter: 0 }]);
  for (const id of ['c-1', 'd-1']) host.states.set(id, 'waiting');
  host.steps.launched();
  host.steps.happened('a-1', 'exit');
  host.steps.happened('b-1', 'exit');
  assert.deepEqual(host.said, ['a ended', 'a, really', 'each time'].map((text) => `INFO launch.user ${text}`));
  assert.deepEqual(host.done, ['start d-1 0']);
});

test('a shutdown tells its reason once, calls off what was to come, and nothing is followed after it', () => {
  const host = new Host([
    { do: 'shutdown', reason: 'done', after: 0, on: { event: 'exit', node: 'a-1' } },
    log('never', { after: 1 }),
    log('bye, \u2039why all ends\u203a', { level: 'error', on: { event: 'shutdown' } }),
    log('not any more', { on: { event: 'exit', node: 'b-1' } }),
  ] as LaunchStep[]);
  host.steps.launched();
  host.steps.happened('a-1', 'exit');
  host.steps.happened('b-1', 'exit');
  host.steps.shutdown('once more');
  host.ring();
  assert.deepEqual(host.said, ['INFO launch all nodes are stopped: done', 'ERROR launch.user bye, done']);
  assert.deepEqual(host.done, ['stop']);
});

test('when nothing runs any more and nothing is to come, all has ended: idle', async () => {
  const host = new Host([log('late', { after: 1 }), log('bye, \u2039why all ends\u203a', { on: { event: 'shutdown' } })]);
  const moment = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
  host.steps.happened('a-1', 'stop');
  await moment();
  host.steps.launched();
  host.steps.happened('a-1', 'exit');
  await moment();
  assert.deepEqual(host.said, [], 'another one runs');
  host.idle = true;
  host.steps.happened('b-1', 'exit');
  await moment();
  assert.deepEqual(host.said, [], 'a line is to come');
  host.ring();
  await moment();
  assert.deepEqual(host.said, ['INFO launch.user late', 'INFO launch.user bye, idle']);
  host.steps.launched();
  host.steps.happened('b-1', 'exit');
  host.idle = false;
  await moment();
  assert.equal(host.said.length, 2, 'its end started another one');
});

test('lines of a node bring what asks for such, and stand in what is said of them', () => {
  const test = (how: LineTest['how'], text: string, more: Partial<LineTest> = {}): LineTest => ({ how, text, anyCase: false, holds: true, ...more });
  const on = (tests: readonly LineTest[], more: Partial<OutputMoment> = {}): OutputMoment => ({
    event: 'output',
    node: 'a-1',
    stream: 'stdout',
    tests,
    ...more,
  });
  const host = new Host([
    log('all: \u2039what it prints\u203a', { on: on([]) }),
    log('begins', { on: on([test('begins', 'sys')]) }),
    log('ends', { on: on([test('ends', 'dy')]) }),
    log('is', { on: on([test('is', 'system READY', { anyCase: true })]) }),
    log('not', { on: on([test('contains', 'ready'), test('contains', 'un', { holds: false })]) }),
    log('once', { on: on([], { once: true }) }),
    log('error', { on: on([], { stream: 'stderr' }) }),
    { do: 'shutdown', reason: 'it said \u2039what it prints\u203a', after: 0, on: on([test('is', 'stop $&')]) },
  ], [{ id: 'b-1', startOn: on([test('contains', 'ready')]), startAfter: 1 }]);
  host.states.set('b-1', 'waiting');
  host.steps.launched();
  host.steps.printed('b-1', [[1, 0, 'system ready']]);
  host.steps.printed('a-1', [[1, 0, 'system ready'], [2, 0, 'bad']]);
  assert.deepEqual(host.done, ['start b-1 1']);
  assert.deepEqual(host.said.splice(0), ['all: system ready', 'begins', 'ends', 'is', 'not', 'once', 'error'].map((text) => `INFO launch.user ${text}`));
  host.states.set('b-1', 'running');
  host.steps.printed('a-1', [[1, 0, 'unready!'], [1, 0, 'stop $&']]);
  assert.deepEqual(host.said, ['INFO launch.user all: unready!', 'INFO launch.user all: stop $&', 'INFO launch all nodes are stopped: it said stop $&']);
});

test('a node that the launch ends has ended as if by itself; one that is stopped has not', () => {
  const host = new Host([
    { do: 'end', node: 'a-1', after: 0, on: { event: 'start', node: 'b-1' } },
    log('over', { on: { event: 'exit', node: 'a-1' } }),
  ], [{ id: 'a-1', shutdownOnExit: true }, { id: 'b-1' }]);
  host.steps.launched();
  host.states.set('a-1', 'exited');
  host.steps.happened('b-1', 'start');
  host.steps.happened('a-1', 'stop');
  assert.deepEqual([host.done, host.said], [[], []]);
  host.states.set('a-1', 'running');
  host.steps.happened('b-1', 'start');
  assert.deepEqual([host.done, host.said], [['stop a-1', 'stop'], ['INFO launch.user over']]);
});

const change = (on?: LaunchStep['on']): LaunchStep => ({
  do: 'transition',
  node: 'a-1',
  name: '/a',
  transitions: [1, 3],
  after: 0,
  ...(on === undefined ? {} : { on }),
});
const turn = (): Promise<void> =>
  new Promise((resolve) => {
    setImmediate(resolve);
  });

test('transitions are made one after the other when the node runs, and no further than one that is refused', async () => {
  const host = new Host([change()]);
  host.states.set('a-1', 'starting');
  host.steps.launched();
  await turn();
  assert.deepEqual(host.calls, []);
  host.steps.happened('a-1', 'start');
  await turn();
  assert.deepEqual([host.calls, host.said], [[1, 3], []]);

  host.states.delete('a-1');
  host.answers = false;
  host.steps.launched();
  await turn();
  assert.deepEqual(host.calls, [1, 3, 1]);
  assert.match(host.said[0] ?? '', /^ERROR launch error\[R2W0725\]: Failed to make transition 'configure' for LifecycleNode '\/a'$/);
  host.problem = new SiteError('R2W0716', 'the server has gone');
  host.steps.launched();
  await turn();
  assert.equal(host.said[1], 'ERROR launch error[R2W0716]: the server has gone');
});

test('while the launch goes on, only the transitions of nodes that are added are made', async () => {
  const once = log('once', { on: { event: 'start', node: 'b-1', once: true } });
  const host = new Host([log('at once'), log('late', { after: 9 }), change(), { ...change(), after: 2 } as LaunchStep, once]);
  host.steps.launched();
  host.steps.happened('b-1', 'start');
  await turn();
  assert.deepEqual([host.said.length, host.calls], [2, [1, 3]]);
  host.steps.launched(new Set(['b-1']));
  host.steps.happened('b-1', 'start');
  await turn();
  assert.deepEqual([host.said.length, host.calls], [2, [1, 3]]);
  host.steps.launched(new Set(['a-1']));
  await turn();
  assert.deepEqual([host.said.length, host.calls], [2, [1, 3, 1, 3]]);
  host.ring();
  await turn();
  assert.deepEqual([host.said.slice(2), host.calls.length], [['INFO launch.user late'], 6]);
  // After the end of all it is a launch again.
  host.steps.shutdown('over');
  host.steps.launched(new Set(['a-1']));
  assert.equal(host.said.at(-1), 'INFO launch.user at once');
});

test('transitions of a node that was stopped, or could not start, are given up', async () => {
  const host = new Host([change()]);
  host.states.set('a-1', 'starting');
  host.steps.launched();
  host.steps.happened('a-1', 'stop');
  host.steps.happened('a-1', 'start');
  await turn();
  const warning = 'WARN launch `/a` ended before its transitions were made';
  assert.deepEqual([host.calls, host.said], [[], [warning]]);
  host.states.delete('a-1');
  host.silent = true;
  host.steps.launched();
  await turn();
  assert.deepEqual(host.calls, [1]);
  host.steps.happened('a-1', 'stop');
  await turn();
  assert.deepEqual([host.calls, host.said], [[1], [warning, warning]]);
});

test('changes of state start nodes and steps that ask for them', async () => {
  const active = { event: 'transition', node: 'a-1', name: '/a', startState: 'activating', goalState: 'active' } as const;
  const host = new Host([log('is active', { on: active })], [{ id: 'b-2', startOn: active, startAfter: 1.5 }]);
  host.states.set('b-2', 'waiting');
  host.hears('activate', 'inactive', 'activating');
  assert.deepEqual(host.done, []);
  host.hears('transition_success', 'activating', 'active');
  assert.deepEqual([host.done, host.said], [['start b-2 1.5'], ['INFO launch.user is active']]);
  host.steps.close();
  assert.equal(host.done.at(-1), 'deaf');
});

test('messages of managed nodes', () => {
  assert.deepEqual([...changeStateRequest(3)], [0, 1, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 0]);
  assert.equal(changeStateSucceeded(new Uint8Array([0, 1, 0, 0, 1])), true);
  assert.equal(changeStateSucceeded(new Uint8Array()), false);
  const whole = transitionEvent('configure', 'unconfigured', 'configuring');
  assert.deepEqual(readTransitionEvent(whole), { transition: 'configure', startState: 'unconfigured', goalState: 'configuring' });
  for (let end = 0; end < whole.length; end += 1) assert.equal(readTransitionEvent(whole.subarray(0, end)), undefined);
  const lying = whole.slice();
  lying[16] = 255;
  lying[19] = 255;
  assert.equal(readTransitionEvent(lying), undefined);
});
