// A node in the design of the ROS2WASM paper, replayed: it asks the page for each of its topics in turn and sleeps 10 ms
// after each that has nothing yet; messages are YAML text. Its wasm and its unwinding of stacks are skipped.

import { parse, stringify } from 'yaml';

/** The task of a node: send and wait for the answer `trips` times, answer, send at a rate, or count the messages that come. */
export type PaperTask =
  | { readonly does: 'ping'; readonly bytes: number; readonly trips: number; }
  | { readonly does: 'pong'; }
  | { readonly does: 'send'; readonly bytes: number; readonly hz: number; readonly durationMs: number; }
  | { readonly does: 'count'; readonly durationMs: number; };

/** From a worker to the page. */
export type PaperReport =
  | { readonly command: 'publish'; readonly topic: string; readonly message: string; }
  | { readonly command: 'retrieve'; readonly topic: string; }
  /** For `ping`, how long each trip took, in ms. For `count`, when each message came. */
  | { readonly command: 'done'; readonly ms: readonly number[]; };

/** From the page to every worker. */
export interface PaperMessage {
  readonly topic: string;
  readonly message: string;
}

interface Bytes {
  readonly layout: { readonly dim: readonly never[]; readonly data_offset: number; };
  readonly data: readonly number[];
}

const pollMs = 10;
/** The topics that every rclcpp node of that time has in addition to the user's; its executor always treats them as ready. */
const ownTopics = [
  'describe_parameters',
  'get_parameter_types',
  'get_parameters',
  'list_parameters',
  'set_parameters',
  'set_parameters_atomically',
  'parameter_events',
];

const scope = self as unknown as DedicatedWorkerGlobalScope;
const newest = new Map<string, string>();

const sleep = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
const tell = (report: PaperReport): void => scope.postMessage(report);

function message(bytes: number): Bytes {
  return { layout: { dim: [], data_offset: 0 }, data: Array.from({ length: bytes }, () => 42) };
}

function publish(topic: string, content: Bytes): void {
  tell({ command: 'publish', topic, message: stringify(content) });
}

async function take(topic: string): Promise<Bytes | undefined> {
  const text = newest.get(topic);
  if (text === undefined) {
    tell({ command: 'retrieve', topic });
    await sleep(pollMs);
    return undefined;
  }
  newest.delete(topic);
  return parse(text) as Bytes;
}

/** Until `over` says so. */
async function spin(topic: string, callback: (content: Bytes) => void, over: () => boolean): Promise<void> {
  while (!over()) {
    for (const each of [...ownTopics, topic]) {
      const content = await take(each);
      if (content !== undefined) callback(content);
    }
  }
}

async function run(task: PaperTask): Promise<void> {
  const ms: number[] = [];
  const end = performance.now() + ('durationMs' in task ? task.durationMs : Infinity);
  switch (task.does) {
    case 'ping': {
      const content = message(task.bytes);
      let begin = performance.now();
      publish('ping', content);
      await spin('pong', () => {
        ms.push(performance.now() - begin);
        begin = performance.now();
        if (ms.length < task.trips) publish('ping', content);
      }, () => ms.length >= task.trips);
      break;
    }
    case 'pong':
      await spin('ping', (content) => publish('pong', content), () => false);
      break;
    case 'send': {
      const content = message(task.bytes);
      while (performance.now() < end) {
        publish('flood', content);
        await sleep(1000 / task.hz);
      }
      break;
    }
    case 'count':
      await spin('flood', () => void ms.push(performance.now()), () => performance.now() >= end);
      break;
  }
  tell({ command: 'done', ms });
}

scope.onmessage = ({ data }: MessageEvent<PaperMessage | { readonly task: PaperTask; }>) => {
  if ('task' in data) void run(data.task);
  else newest.set(data.topic, data.message.replaceAll(', ', '\n'));
};
