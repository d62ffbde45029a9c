// A hundred nodes on a thousand topics in Chromium: what they cost idle and at 10 kHz, and whether a publisher in a
// tight loop leaves the page its frames: fewer than 50 per second, at 10 kHz or in the flood, are a failure. The nodes
// are JavaScript workers on the runtime's own shared link.
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'esbuild';
import type { CrowdFigures } from './crowd_page.ts';
import type { CrowdTask } from './crowd_worker.ts';
import { machineLoad } from './machine_load.ts';
import { processTree, treeMemoryKb } from './process_memory.ts';
import type { BenchContext } from './run.ts';
import { inBrowser } from './browser_site.ts';

const NODES = 100;
const TOPICS_EACH = 10;
const HZ = 10;
const BYTES = 100;
const SECONDS = 10;
/** The page must show so many frames beside the crowd, as a mean over the time and by its median frame. */
const LEAST_FRAMES_PER_SECOND = 50;

interface CrowdPage {
  gather(nodes: number, topicsEach: number, bytes: number): Promise<void>;
  measureCrowd(tasks: readonly CrowdTask[]): Promise<CrowdFigures>;
  disperse(): void;
  countMemories(): { count: number; error: string; };
}

/** User and system time of a process and all that it started, in ms. */
function treeCpuMs(root: number): number {
  const ticksMs = 10;
  let ticks = 0;
  for (const pid of processTree(root)) {
    try {
      const stat = readFileSync(`/proc/${pid}/stat`, 'utf8');
      const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
      ticks += Number(fields[11]) + Number(fields[12]);
    } catch {
      // The process ended between the two reads.
    }
  }
  return ticks * ticksMs;
}

const rounded = (value: number): number => Math.round(value * 100) / 100;

export async function benchCrowd(context: BenchContext): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-crowd-'));
  const entryPoints = ['crowd_page.ts', 'crowd_worker.ts'].map((file) => join(import.meta.dirname, file));
  await build({ entryPoints, bundle: true, format: 'iife', outdir: folder, target: 'es2024', logLevel: 'warning' });
  if (readdirSync(folder).length !== entryPoints.length) throw new Error('the page was not built');
  writeFileSync(join(folder, 'index.html'), '<!doctype html><title>crowd</title><script src="crowd_page.js"></script>');
  try {
    await inBrowser(folder, async (page, pid, url) => {
      await page.goto(url);
      const emptyKb = treeMemoryKb(pid);
      await page.evaluate(([nodes, topics, bytes]) => (globalThis as unknown as CrowdPage).gather(nodes, topics, bytes), [NODES, TOPICS_EACH, BYTES] as const);
      const fullKb = treeMemoryKb(pid);
      const measured = async (tasks: readonly CrowdTask[]): Promise<CrowdFigures & { cpu: number; }> => {
        const before = treeCpuMs(pid);
        const figures = await page.evaluate((given) => (globalThis as unknown as CrowdPage).measureCrowd(given), tasks as CrowdTask[]);
        return { ...figures, cpu: rounded((treeCpuMs(pid) - before) / 1000 / figures.seconds) };
      };
      const durationMs = SECONDS * 1000;
      const frames = ({ framesPerSecond, frameP50, frameP99, frameLongest }: CrowdFigures): Record<string, number> => ({
        frames_per_second: rounded(framesPerSecond),
        frame_p50_ms: rounded(frameP50),
        frame_p99_ms: rounded(frameP99),
        frame_longest_ms: rounded(frameLongest),
        machine_load: machineLoad(),
      });
      // A waiting worker ends its wait once, when the time is over.
      const idle = await measured([{ hz: 0, durationMs }]);
      context.emit({
        bench: 'crowd',
        what: 'idle',
        nodes: NODES,
        topics: NODES * TOPICS_EACH,
        kb_per_node: rounded((fullKb - emptyKb) / NODES),
        wake_ups_per_node_and_second: rounded((idle.wakeUps - NODES) / NODES / idle.seconds),
        processors_used: idle.cpu,
        ...frames(idle),
      });
      const talk = await measured([{ hz: HZ, durationMs }]);
      context.emit({
        bench: 'crowd',
        what: 'talk',
        nodes: NODES,
        topics: NODES * TOPICS_EACH,
        bytes: BYTES,
        wanted_per_second: NODES * TOPICS_EACH * HZ,
        sent_per_second: rounded(talk.sent / talk.seconds),
        delivered_share: rounded(talk.received / talk.sent),
        processors_used: talk.cpu,
        ...frames(talk),
      });
      const flood = await measured([{ hz: 1e6, durationMs }, ...Array.from({ length: NODES - 1 }, () => ({ hz: 1, durationMs }))]);
      context.emit({
        bench: 'crowd',
        what: 'one node floods',
        nodes: NODES,
        bytes: BYTES,
        sent_per_second: rounded(flood.sent / flood.seconds),
        processors_used: flood.cpu,
        ...frames(flood),
      });
      for (const [what, { framesPerSecond, frameP50 }] of Object.entries({ talk, flood })) {
        if (framesPerSecond < LEAST_FRAMES_PER_SECOND || frameP50 > 1000 / LEAST_FRAMES_PER_SECOND) {
          context.fail(`crowd, ${what}: the page has ${rounded(framesPerSecond)} frames per second, ${LEAST_FRAMES_PER_SECOND} are the least`);
        }
      }
      await page.evaluate(() => (globalThis as unknown as CrowdPage).disperse());
      const memories = await page.evaluate(() => (globalThis as unknown as CrowdPage).countMemories());
      context.emit({ bench: 'crowd', what: 'wasm memories in one process', ...memories });
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
