// A report of a worker comes from its program: a program in Python can send anything in the worker's place. So each
// report is validated before use. Only the node that sends an invalid one is ended for it.

import { TerminalMode } from '../../protocol/generated/constants.ts';
import { mostLines } from '../bus/console_sender.ts';
import type { WorkerReport } from './worker_messages.ts';
import type { WorkerEvents } from './platform.ts';

type Members = Readonly<Record<string, unknown>>;

/** The latest site time of a report, ms since 1970: the last one that a Date can hold. */
const lastMs = 8.64e15;
/** UTF-16 units; a program's line is cut at a sixteenth of that. */
const longestText = 1 << 20;
/** Upper bound for a path or a name, in UTF-16 units. */
const longestName = 4096;
const code = /^R2W\d{4}$/;

function isMembers(value: unknown): value is Members {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function isText(value: unknown, longest = longestText): boolean {
  return typeof value === 'string' && value.length <= longest;
}

function isCount(value: unknown): boolean {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}

function isInteger(...values: readonly unknown[]): boolean {
  return values.every((value) => Number.isSafeInteger(value));
}

function isLine(value: unknown): boolean {
  if (!Array.isArray(value) || value.length !== 3) return false;
  const [stream, time, text] = value as readonly unknown[];
  return (stream === 1 || stream === 2) && typeof time === 'number' && Math.abs(time) <= lastMs && isText(text);
}

function isEnd(value: unknown): boolean {
  if (!isMembers(value)) return false;
  switch (value['kind']) {
    case 'thread':
      return true;
    case 'exit':
      return isInteger(value['code']);
    case 'crash':
      return typeof value['code'] === 'string' && code.test(value['code']) && isText(value['message']);
    default:
      return false;
  }
}

function isRest(value: unknown): boolean {
  if (!isMembers(value)) return false;
  const { untilNs, token, stops } = value;
  return typeof untilNs === 'number' && !Number.isNaN(untilNs) && (token === undefined || isInteger(token)) && isInteger(stops);
}

function isSent(value: unknown): boolean {
  if (!isMembers(value)) return false;
  const { name, sequence, stamp, bytes, hash } = value;
  return [name, sequence, stamp, hash].every((text) => isText(text, longestName)) && isCount(bytes);
}

function isThread(value: unknown): boolean {
  if (!isMembers(value)) return false;
  const { thread, entry, argument, stackTop, stackSize } = value;
  return isInteger(thread, entry, argument, stackTop, stackSize);
}

function isThreadMemory(value: unknown): boolean {
  return isMembers(value) && value['memory'] instanceof WebAssembly.Memory && isCount(value['waits']);
}

function isBytes(value: unknown): boolean {
  return value instanceof Uint8Array && value.buffer instanceof ArrayBuffer;
}

const always = (): boolean => true;
const forms: Readonly<Record<WorkerReport['t'], (report: Members) => boolean>> = {
  running: always,
  waits: always,
  broken_image: always,
  terminal: ({ mode }) => Object.values<unknown>(TerminalMode).includes(mode),
  lines: ({ lines, dropped }) => Array.isArray(lines) && lines.length <= mostLines && lines.every(isLine) && isCount(dropped),
  file: ({ path, bytes, at }) => isText(path, longestName) && isBytes(bytes) && typeof at === 'number' && !Number.isNaN(at),
  event: ({ event }) => typeof event === 'string',
  thread: ({ request, memory }) => isThread(request) && memory instanceof WebAssembly.Memory,
  memory: ({ memory }) => isThreadMemory(memory),
  rest: ({ rest }) => isRest(rest),
  sent: ({ message }) => isSent(message),
  image: ({ image }) => image === undefined || image instanceof Blob,
  launch: ({ failed }) => failed === undefined || isText(failed),
  source: ({ path }) => isText(path, longestName),
  end: ({ end, closed }) => isEnd(end) && typeof closed === 'boolean',
};

/** The checked report; undefined: no program built by ros2wasm sends it. */
export function readReport(data: unknown): WorkerReport | undefined {
  if (!isMembers(data)) return undefined;
  const kind = data['t'];
  if (typeof kind !== 'string' || !Object.hasOwn(forms, kind)) return undefined;
  return forms[kind as WorkerReport['t']](data) ? data as unknown as WorkerReport : undefined;
}

/** The code of a node that sends something else (cli/explain/R2W0727.md), and what is said of it. */
export const strangeReport = { code: 'R2W0727', message: 'the program sends the page what is not a report of a node' } as const;

/** Hands on what a worker has sent. */
export function takeReport(data: unknown, events: WorkerEvents): void {
  const report = readReport(data);
  if (report === undefined) events.failed(strangeReport.message, strangeReport.code);
  else events.report(report);
}
