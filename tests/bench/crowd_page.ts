// The page of the crowd: a broker, as many workers, and a count of its own frames meanwhile.

import { type Broker, SharedBroker } from '../../runtime/site/bus/broker.ts';
import type { CrowdOrder, CrowdReport, CrowdTask } from './crowd_worker.ts';

export interface CrowdFigures extends CrowdReport {
  readonly framesPerSecond: number;
  /** Milliseconds between frames. */
  readonly frameP50: number;
  readonly frameP99: number;
  readonly frameLongest: number;
  readonly seconds: number;
}

const marginMs = 1000;

let broker: Broker | undefined;
let workers: Worker[] = [];

function ask<T>(worker: Worker, message: unknown, transfer: Transferable[] = []): Promise<T> {
  return new Promise((resolve, reject) => {
    worker.onmessage = (event: MessageEvent<T>) => resolve(event.data);
    worker.onerror = (event) => reject(new Error(event.message));
    worker.postMessage(message, transfer);
  });
}

/** Starts the workers; resolves when every publisher has its reader. */
async function gather(nodes: number, topicsEach: number, bytes: number): Promise<void> {
  const shared = new SharedBroker();
  broker = shared;
  workers = [];
  for (let index = 0; index < nodes; index += 1) {
    const admission = shared.admit();
    if (admission === undefined) throw new Error('no place');
    const worker = new Worker('crowd_worker.js');
    workers.push(worker);
    const order: CrowdOrder = { ticket: admission.ticket, index, nodes, topicsEach, bytes };
    await ask(worker, { order }, [...admission.transfer]);
  }
  await Promise.all(workers.map((worker) => ask(worker, { matched: true })));
}

function watchFrames(): () => number[] {
  const gaps: number[] = [];
  let last = performance.now();
  let going = true;
  const frame = (): void => {
    const now = performance.now();
    gaps.push(now - last);
    last = now;
    if (going) requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  return () => {
    going = false;
    return gaps.toSorted((a, b) => a - b);
  };
}

/**
 * `tasks`: one for all, or one for each worker. Frames count from a while after the beginning to a while before the end:
 * when a hundred workers begin or end at the same moment, they hold the processors for some tenths of a second, and
 * that is not what the tasks cost.
 */
async function measureCrowd(tasks: readonly CrowdTask[]): Promise<CrowdFigures> {
  const begin = performance.now();
  const asked = Promise.all(workers.map((worker, i) => ask<CrowdReport>(worker, { task: tasks[i % tasks.length] })));
  const sleep = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
  await sleep(marginMs);
  const frames = watchFrames();
  const watched = performance.now();
  await sleep(Math.min(...tasks.map(({ durationMs }) => durationMs)) - 2 * marginMs);
  const gaps = frames();
  const framesPerSecond = (gaps.length * 1000) / (performance.now() - watched);
  const reports = await asked;
  const seconds = (performance.now() - begin) / 1000;
  const late = await Promise.all(workers.map((worker) => ask<number>(worker, { drain: true })));
  const at = (share: number): number => gaps[Math.floor(gaps.length * share)] ?? Number.NaN;
  const total = (of: (report: CrowdReport) => number): number => reports.reduce((sum, report) => sum + of(report), 0);
  return {
    sent: total((report) => report.sent),
    received: total((report) => report.received) + late.reduce((a, b) => a + b, 0),
    wakeUps: total((report) => report.wakeUps),
    framesPerSecond,
    frameP50: at(0.5),
    frameP99: at(0.99),
    frameLongest: gaps.at(-1) ?? Number.NaN,
    seconds,
  };
}

function disperse(): void {
  for (const worker of workers) worker.terminate();
  workers = [];
  broker?.close();
}

/** How many wasm memories this process may have, and what it says after that. */
function countMemories(): { count: number; error: string; } {
  const kept: WebAssembly.Memory[] = [];
  for (;;) {
    try {
      kept.push(new WebAssembly.Memory({ initial: 1 }));
    } catch (error) {
      return { count: kept.length, error: String(error) };
    }
    if (kept.length === 10_000) return { count: kept.length, error: '' };
  }
}

Object.assign(globalThis, { gather, measureCrowd, disperse, countMemories });
