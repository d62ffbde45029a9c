// A site that runs for long in Chromium, page open: nodes publish at fixed rates (a large message among them), call a
// service and log. Every minute one line: memory, delivered share, latencies, frames. The last line says what stayed flat.
// The page's heap grows until its lists of lines are full, here for half an hour: a short soak does not find it flat.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { CDPSession, Page } from 'playwright-core';
import { BusHeader } from '../../runtime/protocol/generated/constants.ts';
import { inBrowser } from './browser_site.ts';
import { machineLoad } from './machine_load.ts';
import { packLaunch } from './packed_launch.ts';
import { treePrivateKb } from './process_memory.ts';
import type { BenchContext } from './run.ts';
import { gather, judge, rounded, RULE, type SoakReport, type SoakSample } from './soak_verdict.ts';

const PULSES = [
  { topic: '/small', bytes: 100, hz: 200, log: false },
  { topic: '/logged', bytes: 1000, hz: 50, log: true },
  { topic: '/middle', bytes: 64_000, hz: 20, log: false },
  { topic: '/large', bytes: 6_000_000, hz: 4, log: false },
];
const CALLS_HZ = 20;
const DEFAULT_MINUTES = 60;
/** Samples that a soak has at least. */
const LEAST_SAMPLES = 12;

/** The data that the page records for this bench; set up before the page's own scripts run. */
interface Noted {
  reports: SoakReport[];
  frames: number[];
  bus: WebAssembly.Memory | undefined;
}

function note(): void {
  const noted: Noted = { reports: [], frames: [], bus: undefined };
  const OfPage = globalThis.Worker;
  globalThis.Worker = class extends OfPage {
    constructor(url: string | URL, options?: WorkerOptions) {
      super(url, options);
      this.addEventListener('message', ({ data }: MessageEvent<{ t: string; lines?: [number, number, string][]; }>) => {
        for (const [, , text] of data.lines ?? []) if (text.startsWith('{"soak"')) noted.reports.push(JSON.parse(text) as SoakReport);
      });
    }

    override postMessage(message: unknown, transfer: StructuredSerializeOptions | Transferable[] = []): void {
      noted.bus ??= (message as { start?: { ticket?: { memory?: WebAssembly.Memory; }; }; }).start?.ticket?.memory;
      super.postMessage(message, transfer as Transferable[]);
    }
  };
  let last = performance.now();
  const frame = (now: number): void => {
    noted.frames.push(now - last);
    last = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  Object.assign(globalThis, { noted });
}

interface PageFigures {
  readonly reports: readonly SoakReport[];
  readonly frames: readonly number[];
  readonly busPages: number;
}

/** Takes what was noted since the last time. */
function drain([table, first]: readonly [number, number]): PageFigures {
  const { noted } = globalThis as unknown as { noted: Noted; };
  const words = new Int32Array(noted.bus?.buffer ?? new ArrayBuffer(0));
  let busPages = 0;
  const [from, pages] = [words[table] ?? 0, words[first] ?? 0];
  const total = Math.floor((words.byteLength - pages) / 4096);
  for (let page = 0; page < total; page += 1) if (words[from / 4 + page] !== 0) busPages += 1;
  const { reports, frames } = noted;
  noted.reports = [];
  noted.frames = [];
  return { reports, frames, busPages };
}

async function heapKb(devtools: CDPSession): Promise<number> {
  await devtools.send('HeapProfiler.collectGarbage');
  const { metrics } = await devtools.send('Performance.getMetrics');
  return Math.round((metrics.find(({ name }) => name === 'JSHeapUsedSize')?.value ?? Number.NaN) / 1024);
}

async function soak(context: BenchContext, page: Page, pid: number, minutes: number, periodS: number): Promise<void> {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable');
  const samples: SoakSample[] = [];
  const streams = [...PULSES.map(({ topic, hz }) => ({ soak: topic, due: hz * periodS })), { soak: 'calls', due: CALLS_HZ * periodS }];
  const count = Math.floor((minutes * 60) / periodS);
  const constants = [BusHeader.pageTable, BusHeader.pages] as const;
  for (let i = 1; i <= count; i += 1) {
    // A sample is due when all who send and all who take have reported.
    await page.waitForFunction((reporters) => {
      const { reports } = (globalThis as unknown as { noted: Noted; }).noted;
      return new Set(reports.map((report) => `${report.soak} ${'published' in report}`)).size >= reporters;
    }, 2 * streams.length, { timeout: 3 * periodS * 1000, polling: 500 });
    const { reports, frames, busPages } = await page.evaluate(drain, constants);
    const gaps = frames.toSorted((a, b) => a - b);
    const at = (share: number): number => rounded(gaps[Math.floor(gaps.length * share)] ?? Number.NaN);
    const sample: SoakSample = {
      minute: rounded((i * periodS) / 60),
      heap_kb: await heapKb(devtools),
      processes_kb: treePrivateKb(pid),
      bus_used_kb: busPages * 4,
      streams: gather(reports, streams),
    };
    samples.push(sample);
    context.emit({
      bench: 'soak',
      what: 'sample',
      ...sample,
      frames: gaps.length,
      frame_p50_ms: at(0.5),
      frame_p99_ms: at(0.99),
      frame_longest_ms: rounded(gaps.at(-1) ?? Number.NaN),
      machine_load: machineLoad(),
    });
    // Frames that the sample itself delayed are not counted.
    await page.evaluate(() => {
      (globalThis as unknown as { noted: Noted; }).noted.frames = [];
    });
  }
  const judged = judge(samples, streams);
  if (!judged.flat) context.fail('soak: not flat');
  context.emit({
    bench: 'soak',
    what: 'verdict',
    minutes,
    samples: samples.length,
    ...judged,
    rule: RULE,
  });
}

export async function benchSoak(context: BenchContext): Promise<void> {
  const minutes = context.minutes ?? DEFAULT_MINUTES;
  const periodS = Math.max(1, Math.min(60, Math.floor((minutes * 60) / LEAST_SAMPLES)));
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const topics = PULSES.map(({ topic }) => `"${topic}"`).join(', ');
    const site = packLaunch(context, folder, ['soak_bench'], 'soak', [
      `{package: soak_bench, executable: gauge, parameters: {topics: [${topics}], report_s: ${periodS}}}`,
      '{package: soak_bench, executable: adder}',
      `{package: soak_bench, executable: caller, parameters: {hz: ${CALLS_HZ}, report_s: ${periodS}}}`,
      ...PULSES.map(({ topic, bytes, hz, log }) =>
        `{package: soak_bench, executable: pulse, name: pulse_${
          topic.slice(1)
        }, parameters: {topic: ${topic}, bytes: ${bytes}, hz: ${hz}, log: ${log}, report_s: ${periodS}}}`
      ),
    ]);
    await inBrowser(site, async (page, pid, url) => {
      await page.addInitScript(note);
      await page.goto(url);
      await soak(context, page, pid, minutes, periodS);
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
